#include "core/measure/reduce_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace airlight::measure {
namespace {

constexpr std::uint8_t kNotFinite = 255;
constexpr double kErrorSteps = 254.0;

// Blocks of `factor` x `factor` pixels, those at the right and lower edges smaller.
struct Blocks {
  int columns = 0;
  int rows = 0;
  int factor = 1;

  int across() const { return (columns + factor - 1) / factor; }
  int down() const { return (rows + factor - 1) / factor; }

  // Calls `visit` with the index of every pixel of a block.
  template <class Visit>
  void each(int x, int y, Visit visit) const {
    for (int row = y * factor; row < std::min((y + 1) * factor, rows); ++row) {
      for (int column = x * factor; column < std::min((x + 1) * factor, columns); ++column) {
        visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column));
      }
    }
  }
};

Blocks blocks_for(const PixelFrame& frame, std::size_t most_pixels) {
  Blocks blocks{.columns = frame.columns, .rows = frame.rows, .factor = 1};
  while (blocks.factor < std::max(frame.columns, frame.rows) &&
         static_cast<std::size_t>(blocks.across()) * static_cast<std::size_t>(blocks.down()) > most_pixels) {
    ++blocks.factor;
  }
  return blocks;
}

std::array<std::uint8_t, 4> rgbe(const std::array<double, 3>& value) {
  const double largest = std::max({value[0], value[1], value[2]});
  for (const double v : value) {
    if (!std::isfinite(v)) return {0, 0, 0, kNotFinite};
  }
  int exponent = 0;
  // A mantissa that rounds up to 256 takes the next exponent.
  if (largest > 0.0 && std::frexp(largest, &exponent) >= 255.5 / 256.0) ++exponent;
  if (!(largest > 0.0) || exponent <= -128) return {0, 0, 0, 0};
  exponent = std::min(exponent, 126);
  std::array<std::uint8_t, 4> code{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
  for (std::size_t i = 0; i < 3; ++i) {
    const double mantissa = std::ldexp(std::max(value[i], 0.0), 8 - exponent);
    code[i] = static_cast<std::uint8_t>(std::lround(std::clamp(mantissa, 0.0, 255.0)));
  }
  return code;
}

std::vector<std::byte> reduced_picture(const Blocks& blocks, const ShownPicture& picture) {
  std::vector<std::byte> bytes;
  for (int y = 0; y < blocks.down(); ++y) {
    for (int x = 0; x < blocks.across(); ++x) {
      std::array<double, 3> sum{};
      double count = 0.0;
      blocks.each(x, y, [&](std::size_t i) {
        sum[0] += static_cast<double>(picture.red[i]);
        sum[1] += static_cast<double>(picture.green[i]);
        sum[2] += static_cast<double>(picture.blue[i]);
        count += 1.0;
      });
      for (const std::uint8_t part : rgbe({sum[0] / count, sum[1] / count, sum[2] / count})) {
        bytes.push_back(static_cast<std::byte>(part));
      }
    }
  }
  return bytes;
}

std::vector<std::byte> reduced_errors(const Blocks& blocks, const std::vector<float>& errors, const ErrorScale& scale) {
  std::vector<std::byte> bytes;
  for (int y = 0; y < blocks.down(); ++y) {
    for (int x = 0; x < blocks.across(); ++x) {
      double largest = 0.0;
      blocks.each(x, y, [&](std::size_t i) {
        const double error = static_cast<double>(errors[i]);
        largest = std::isfinite(error) ? std::max(largest, error) : std::numeric_limits<double>::infinity();
      });
      bytes.push_back(static_cast<std::byte>(
          std::isfinite(largest) ? static_cast<std::uint8_t>(std::lround(kErrorSteps * scale.fraction(largest)))
                                 : kNotFinite));
    }
  }
  return bytes;
}

}  // namespace

ShownPicture shown_planes(const std::vector<Plane>& planes, MemberOf<Plane, std::vector<float>> side) {
  const std::vector<std::size_t> colours = colour_planes(planes);
  const bool grey = colours.size() != 3;
  return {planes[colours[0]].*side, planes[colours[grey ? 0 : 1]].*side, planes[colours[grey ? 0 : 2]].*side};
}

ShownPictures reduce_pictures(const PicturePair& pair, const std::vector<float>& errors, const ErrorScale& scale,
                              std::size_t most_pixels) {
  const Blocks blocks = blocks_for(pair.frame, most_pixels);
  const ShownPicture b = shown_planes(pair.planes, &Plane::b);
  return {.width = blocks.across(),
          .height = blocks.down(),
          .left = pair.frame.left,
          .top = pair.frame.top,
          .reduced = blocks.factor,
          .a = reduced_picture(blocks, shown_planes(pair.planes, &Plane::a)),
          .b = reduced_picture(blocks, b),
          .errors = reduced_errors(blocks, errors, scale),
          .logarithmic = scale.logarithmic,
          .low = scale.low,
          .high = scale.high,
          .error_name = scale.title,
          .exposure = exposure_for(b)};
}

}  // namespace airlight::measure
