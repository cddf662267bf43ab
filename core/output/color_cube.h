#pragma once
// An expensive colour transform, evaluated only at those points of a fine grid that a picture needs, and interpolated
// between them. A sky covers a thin sheet of all colours: ten thousand points serve two million pixels.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace airlight {

// Transforms RGBA pixels in place; called from several threads at once.
using ColorTransform = std::function<void(std::span<float> rgba)>;

class ColorCube {
 public:
  ColorCube();

  // Evaluates the transform at the points that these pixels need and earlier ones did not. If that would cost more than
  // to transform all pixels so far, these pixels go through the transform instead. The evaluated points depend on the
  // pixels given so far and on how they were divided between calls.
  void prepare(std::span<const float> rgba, const ColorTransform& transform);

  // Transforms pixels in place. Colours outside the grid, colours that were not prepared, non-finite ones, and those
  // where the transform bends too sharply go through the transform itself.
  void apply(std::span<float> rgba, const ColorTransform& transform) const;

  // Points evaluated so far.
  std::size_t points() const { return points_; }

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  void evaluate_cells(std::span<const std::uint32_t> cells, std::span<const std::uint32_t> nodes,
                      const ColorTransform& transform);

  // RGB and a mark for each grid point, red fastest. Untouched pages cost no memory.
  std::unique_ptr<float[], Free> values_;
  std::vector<std::uint8_t> marks_;  // of each cell, by its first node, and of each node
  std::size_t credit_ = 0;           // points that may still be evaluated
  std::size_t points_ = 0;
};

}  // namespace airlight
