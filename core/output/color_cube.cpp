#include "core/output/color_cube.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>
#include <new>
#include <utility>

#include "core/output/parallel.h"

namespace airlight {
namespace {

// The grid of a channel is even in the bits of the float (value + kOffset): 2^kSubdivision even steps in each octave,
// nearly even in value below kOffset. With 2^3 steps the ACES view of a sky is at most 0.20 of an 8-bit code off
// (2^2: 0.72; 2^4: 0.09 for three times the points).
constexpr std::uint32_t kSubdivision = 3;
constexpr float kOffset = 0x1p-10F;
constexpr std::uint32_t kOctaves = 16;  // up to 2^6: beyond, as in the sun's disc, the exact transform is used
// Interpolation is not used in cells whose middle it misses by more than this, such as at the edge of the display's
// gamut.
constexpr float kTolerance = 0.4F / 255.0F;
constexpr float kSmooth = 1.0F;  // in the fourth value of a cell's first node

constexpr std::uint32_t kShift = 23 - kSubdivision;
constexpr std::uint32_t kOffsetBits = std::bit_cast<std::uint32_t>(kOffset);
constexpr std::uint32_t kCells = kOctaves << kSubdivision;
constexpr std::uint32_t kEnd = kCells << kShift;
constexpr std::size_t kNodes = kCells + 1;
constexpr std::array<std::size_t, 3> kStride = {1, kNodes, kNodes* kNodes};  // of red, green, blue
constexpr std::size_t kAllNodes = kNodes * kNodes * kNodes;

float node_value(std::size_t index) {
  return std::bit_cast<float>(kOffsetBits + (static_cast<std::uint32_t>(index) << kShift)) - kOffset;
}

// Place of a colour on the grid: cell of each channel in the high bits, fraction in the low kShift bits.
struct Place {
  std::uint32_t red, green, blue;
  bool inside;
};

Place place_of(const float* rgb) {
  Place place{};
  place.red = std::bit_cast<std::uint32_t>(rgb[0] + kOffset) - kOffsetBits;
  place.green = std::bit_cast<std::uint32_t>(rgb[1] + kOffset) - kOffsetBits;
  place.blue = std::bit_cast<std::uint32_t>(rgb[2] + kOffset) - kOffsetBits;
  // Negative values, too large ones and NaN all wrap or grow beyond kEnd.
  place.inside = (place.red < kEnd) & (place.green < kEnd) & (place.blue < kEnd);
  return place;
}

std::size_t first_node(const Place& place) {
  return (place.red >> kShift) * kStride[0] + (place.green >> kShift) * kStride[1] +
         (place.blue >> kShift) * kStride[2];
}

// Linear in that one of six tetrahedra that holds the fractions: exact on the diagonal from black to white.
void interpolate(const float* values, const Place& place, float* out) {
  constexpr std::uint32_t kFraction = (1U << kShift) - 1;
  constexpr float kUnit = 1.0F / static_cast<float>(1U << kShift);
  const float red = static_cast<float>(static_cast<int>(place.red & kFraction)) * kUnit;
  const float green = static_cast<float>(static_cast<int>(place.green & kFraction)) * kUnit;
  const float blue = static_cast<float>(static_cast<int>(place.blue & kFraction)) * kUnit;
  std::array<std::pair<float, std::size_t>, 3> order = {{{red, kStride[0]}, {green, kStride[1]}, {blue, kStride[2]}}};
  const auto larger_first = [&order](std::size_t a, std::size_t b) {
    if (order[a].first < order[b].first) {
      std::swap(order[a], order[b]);
    }
  };
  larger_first(0, 1);
  larger_first(1, 2);
  larger_first(0, 1);
  const float* const corner0 = values + 4 * first_node(place);
  const float* const corner1 = corner0 + 4 * order[0].second;
  const float* const corner2 = corner1 + 4 * order[1].second;
  const float* const corner3 = corner2 + 4 * order[2].second;
  const float weight0 = 1.0F - order[0].first, weight1 = order[0].first - order[1].first,
              weight2 = order[1].first - order[2].first, weight3 = order[2].first;
  for (std::size_t c = 0; c < 3; ++c) {
    out[c] = weight0 * corner0[c] + weight1 * corner1[c] + weight2 * corner2[c] + weight3 * corner3[c];
  }
}

constexpr std::uint8_t kCellFound = 1, kCellDone = 2, kNodeFound = 4, kNodeDone = 8;

// The cells that these pixels are the first to touch; sets kCellFound for them.
std::vector<std::uint32_t> new_cells(std::span<const float> rgba, std::vector<std::uint8_t>& marks) {
  constexpr std::size_t kAtOnce = 4 * 4096;
  const int parts = static_cast<int>((rgba.size() + kAtOnce - 1) / kAtOnce);
  std::vector<std::uint32_t> cells;
  std::mutex mutex;
  for_row_strips(parts, [&](int first, int end) {
    std::vector<std::uint32_t> found;
    std::size_t last = kAllNodes;
    const std::size_t stop = std::min(rgba.size(), static_cast<std::size_t>(end) * kAtOnce);
    for (std::size_t i = static_cast<std::size_t>(first) * kAtOnce; i < stop; i += 4) {
      const Place place = place_of(&rgba[i]);
      const std::size_t cell = first_node(place);
      if (!place.inside || cell == last) {
        continue;
      }
      last = cell;
      std::atomic_ref mark(marks[cell]);
      constexpr std::uint8_t kKnown = kCellFound | kCellDone;
      if ((mark.load(std::memory_order_relaxed) & kKnown) == 0 &&
          (mark.fetch_or(kCellFound, std::memory_order_relaxed) & kKnown) == 0) {
        found.push_back(static_cast<std::uint32_t>(cell));
      }
    }
    const std::lock_guard lock(mutex);
    cells.insert(cells.end(), found.begin(), found.end());
  });
  return cells;
}

std::size_t corner_node(std::size_t cell, std::size_t corner) {
  return cell + (corner & 1) * kStride[0] + (corner >> 1 & 1) * kStride[1] + (corner >> 2) * kStride[2];
}

// Those corners of the cells that are not done, each once; sets kNodeFound for them.
std::vector<std::uint32_t> new_nodes(std::span<const std::uint32_t> cells, std::vector<std::uint8_t>& marks) {
  std::vector<std::uint32_t> nodes;
  for (const std::uint32_t cell : cells) {
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const std::size_t node = corner_node(cell, corner);
      if ((marks[node] & (kNodeFound | kNodeDone)) == 0) {
        marks[node] |= kNodeFound;
        nodes.push_back(static_cast<std::uint32_t>(node));
      }
    }
  }
  return nodes;
}

// The transform at each node, shifted by `shift` of a cell along the three axes.
std::vector<float> evaluate(std::span<const std::uint32_t> nodes, float shift, const ColorTransform& transform) {
  std::vector<float> rgba(4 * nodes.size(), 1.0F);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::array<std::size_t, 3> index = {nodes[i] % kNodes, nodes[i] / kNodes % kNodes, nodes[i] / kStride[2]};
    for (std::size_t c = 0; c < 3; ++c) {
      rgba[4 * i + c] = node_value(index[c]);
      if (shift > 0) {
        rgba[4 * i + c] += shift * (node_value(index[c] + 1) - node_value(index[c]));
      }
    }
  }
  transform(rgba);
  return rgba;
}

// Whether all four diagonals of a cell meet the transform's value `truth` in its middle.
bool is_smooth(const float* values, std::size_t cell, const float* truth) {
  const auto unit = [](float value) { return std::clamp(value, 0.0F, 1.0F); };
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const float* const one = values + 4 * corner_node(cell, corner);
    const float* const other = values + 4 * corner_node(cell, 7 - corner);
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(std::fabs(unit(0.5F * (one[c] + other[c])) - unit(truth[c])) <= kTolerance)) {
        return false;
      }
    }
  }
  return true;
}

template <class Work>
void for_blocks(std::span<const std::uint32_t> nodes, const Work& work) {
  constexpr std::size_t kBlock = 256;
  const int blocks = static_cast<int>((nodes.size() + kBlock - 1) / kBlock);
  for_row_strips(blocks, [&](int first, int end) {
    for (int block = first; block < end; ++block) {
      const std::size_t start = static_cast<std::size_t>(block) * kBlock;
      work(nodes.subspan(start, std::min(kBlock, nodes.size() - start)));
    }
  });
}

constexpr std::size_t kBytes = 4 * sizeof(float) * kAllNodes;

// calloc() would write zeros to what lies on a heap.
float* untouched_values() {
  void* const memory =
      ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) {
    throw std::bad_alloc();
  }
  return static_cast<float*>(memory);
}

}  // namespace

void ColorCube::Free::operator()(void* memory) const {
  ::munmap(memory, kBytes);
}

ColorCube::ColorCube() : values_(untouched_values()), marks_(kAllNodes) {}

void ColorCube::prepare(std::span<const float> rgba, const ColorTransform& transform) {
  const std::vector<std::uint32_t> cells = new_cells(rgba, marks_);
  const std::vector<std::uint32_t> nodes = new_nodes(cells, marks_);
  credit_ += rgba.size() / 4 / 3;
  const bool pays = cells.size() + nodes.size() <= credit_;
  if (pays) {
    evaluate_cells(cells, nodes, transform);
    credit_ -= cells.size() + nodes.size();
    points_ += cells.size() + nodes.size();
  }
  const auto settle = [&](std::uint32_t index, std::uint8_t found, std::uint8_t done) {
    marks_[index] = static_cast<std::uint8_t>((marks_[index] & ~found) | (pays ? done : 0));
  };
  std::ranges::for_each(cells, [&](std::uint32_t cell) { settle(cell, kCellFound, kCellDone); });
  std::ranges::for_each(nodes, [&](std::uint32_t node) { settle(node, kNodeFound, kNodeDone); });
}

void ColorCube::evaluate_cells(std::span<const std::uint32_t> new_cells, std::span<const std::uint32_t> new_nodes,
                               const ColorTransform& transform) {
  for_blocks(new_nodes, [&](std::span<const std::uint32_t> nodes) {
    const std::vector<float> results = evaluate(nodes, 0.0F, transform);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::copy_n(&results[4 * i], 3, values_.get() + 4 * static_cast<std::size_t>(nodes[i]));
    }
  });
  for_blocks(new_cells, [&](std::span<const std::uint32_t> cells) {
    const std::vector<float> truth = evaluate(cells, 0.5F, transform);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      values_[4 * cells[i] + 3] = is_smooth(values_.get(), cells[i], &truth[4 * i]) ? kSmooth : 0.0F;
    }
  });
}

void ColorCube::apply(std::span<float> rgba, const ColorTransform& transform) const {
  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const Place place = place_of(&rgba[i]);
    if (place.inside && values_[4 * first_node(place) + 3] == kSmooth) {
      interpolate(values_.get(), place, &rgba[i]);
    } else {
      outside.push_back(i);
    }
  }
  if (outside.empty()) {
    return;
  }
  std::vector<float> exact(4 * outside.size());
  for (std::size_t k = 0; k < outside.size(); ++k) {
    std::copy_n(&rgba[outside[k]], 4, &exact[4 * k]);
  }
  transform(exact);
  for (std::size_t k = 0; k < outside.size(); ++k) {
    std::copy_n(&exact[4 * k], 4, &rgba[outside[k]]);
  }
}

}  // namespace airlight
