#include "core/sequence/contact_sheet.h"

#include <algorithm>
#include <cmath>

namespace airlight::sequence {
namespace {

constexpr int kGap = 4;  // pixels between pictures, and around them
constexpr int kLabelHeight = measure::kGlyphHeight + 4;
constexpr measure::Colour kBackground{24, 24, 24};
constexpr measure::Colour kText{208, 208, 208};

// The source pixels that a pixel of the small picture covers.
struct Span {
  int begin = 0;
  int end = 0;
};

Span span_of(int pixel, int small, int large) {
  const auto edge = [&](int i) { return static_cast<int>(static_cast<long>(i) * large / small); };
  return {edge(pixel), std::max(edge(pixel) + 1, edge(pixel + 1))};
}

// Number of columns for a shape near 16:9. Rather a little off it than with empty cells in the last row.
int column_count(int count, int cell_width, int cell_height) {
  constexpr double kWeightOfShape = 0.3;  // 10 % off the shape are as bad as 3 % of the cells empty
  const double ideal = std::sqrt(count * 16.0 / 9.0 * cell_height / cell_width);
  int best = 1;
  double least = 1e9;
  for (int columns = 1; columns <= count; ++columns) {
    const int cells = (count + columns - 1) / columns * columns;
    const double cost =
        static_cast<double>(cells - count) / cells + kWeightOfShape * std::abs(std::log(columns / ideal));
    if (cost < least) {
      least = cost;
      best = columns;
    }
  }
  return best;
}

}  // namespace

std::vector<std::size_t> frames_shown(std::size_t frames, std::size_t most) {
  const std::size_t count = std::min(frames, most);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < count; ++i) {
    shown.push_back(count == 1 ? 0 : (i * (frames - 1) + (count - 1) / 2) / (count - 1));
  }
  return shown;
}

Thumbnail shrink(int width, int height, int channels, const std::vector<std::uint8_t>& pixels, int largest_side) {
  const int larger = std::max(width, height);
  const auto side = [&](int length) {
    return larger <= largest_side ? length : std::max(1, (length * largest_side + larger / 2) / larger);
  };
  Thumbnail small{side(width), side(height), {}, {}};
  small.rgb.reserve(3 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  for (int y = 0; y < small.height; ++y) {
    const Span rows = span_of(y, small.height, height);
    for (int x = 0; x < small.width; ++x) {
      const Span columns = span_of(x, small.width, width);
      double sum[3] = {};
      for (int row = rows.begin; row < rows.end; ++row) {
        for (int column = columns.begin; column < columns.end; ++column) {
          const std::size_t at =
              static_cast<std::size_t>(channels) *
              (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
          for (std::size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(pixels[at + c]) * pixels[at + c];
        }
      }
      const double count = static_cast<double>(rows.end - rows.begin) * (columns.end - columns.begin);
      for (const double total : sum) {
        small.rgb.push_back(static_cast<std::uint8_t>(std::lround(std::sqrt(total / count))));
      }
    }
  }
  return small;
}

measure::Raster contact_sheet(const std::vector<Thumbnail>& thumbnails) {
  int width = 1;
  int height = 1;
  for (const Thumbnail& small : thumbnails) {
    width = std::max({width, small.width, measure::text_width(small.label, 1)});
    height = std::max(height, small.height);
  }
  const int cell_width = width + kGap;
  const int cell_height = height + kLabelHeight + kGap;
  const int columns = column_count(static_cast<int>(thumbnails.size()), cell_width, cell_height);
  const int rows = (static_cast<int>(thumbnails.size()) + columns - 1) / columns;
  measure::Raster sheet(columns * cell_width + kGap, rows * cell_height + kGap, kBackground);
  for (std::size_t i = 0; i < thumbnails.size(); ++i) {
    const Thumbnail& small = thumbnails[i];
    const int left = kGap + static_cast<int>(i) % columns * cell_width;
    const int top = kGap + static_cast<int>(i) / columns * cell_height;
    for (int y = 0; y < small.height; ++y) {
      for (int x = 0; x < small.width; ++x) {
        const std::uint8_t* const rgb =
            &small.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) +
                            static_cast<std::size_t>(x))];
        sheet.set(left + x, top + y, {rgb[0], rgb[1], rgb[2]});
      }
    }
    sheet.write(left, top + height + 2, 1, kText, small.label);
  }
  return sheet;
}

}  // namespace airlight::sequence
