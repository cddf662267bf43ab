#pragma once
// An expensive colour transform, evaluated only at the points of a fine grid that a picture needs, and interpolated
// between them. A sky covers a thin sheet of all colours: ten thousand points serve two million pixels.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace airlight {

// Transforms RGBA pixels in place; called from several threads at once.
using ColorTransform = std::function<void(std::span<float> rgba)>;

// Fills one row of the picture to be transformed (RGBA); called from several threads at once.
using RowSource = std::function<void(int y, std::span<float> rgba)>;

class ColorCube {
 public:
  // Nothing when the picture has so many colours that the transform itself is cheaper.
  static std::optional<ColorCube> make(int width, int height, const RowSource& row, const ColorTransform& transform);

  // Transforms a row of the same picture in place. Colours outside the grid, non-finite ones, and those where the
  // transform bends too sharply go through it. The result depends on the pixel's colour alone, not on the picture.
  void apply(std::span<float> rgba, const ColorTransform& transform) const;

 private:
  struct Free {
    void operator()(void* memory) const;
  };
  using Values = std::unique_ptr<float[], Free>;
  explicit ColorCube(Values values) : values_(std::move(values)) {}

  Values values_;  // RGB of each grid point and a mark, red fastest; untouched pages cost no memory
};

}  // namespace airlight
