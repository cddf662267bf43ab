#include "core/output/quantize.h"

#include <array>
#include <cassert>
#include <cmath>

#include "core/output/parallel.h"

namespace airlight {
namespace {

// The same thresholds as the shaders'.
struct Spread {
  using real = double;
  using uint = std::uint32_t;
#include "shaders/physics/spread.glsl"
};

// The channels' thresholds are a third of the range apart, so that their errors cancel in the luminance.
constexpr std::uint32_t kStepChannel = 1431655765U;
constexpr std::size_t kThresholds = 256;

struct Thresholds {
  std::array<float, kThresholds> even{};        // [0, 1): added before rounding down; leaves whole numbers alone
  std::array<float, kThresholds> triangular{};  // (-1, 1) + 1/2: noise of the same strength at every value
};

Thresholds make_thresholds() {
  Thresholds thresholds;
  for (std::size_t i = 0; i < kThresholds; ++i) {
    const double even = (static_cast<double>(i) + 0.5) / static_cast<double>(kThresholds);
    const double triangular = even < 0.5 ? std::sqrt(2.0 * even) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * even);
    thresholds.even[i] = static_cast<float>(even);
    thresholds.triangular[i] = static_cast<float>(triangular + 0.5);
  }
  return thresholds;
}

// Comparisons in this order turn NaN into 0.
float unit_or_zero(float value) {
  return value > 0.0F ? (value < 1.0F ? value : 1.0F) : 0.0F;
}

// Within a step of the ends the triangle would be cut off and shift the mean. There the even thresholds are used, which
// keep pure black and white pure.
std::uint8_t dithered(float value, std::size_t index, const Thresholds& thresholds) {
  const float scaled = unit_or_zero(value) * 255.0F;
  const bool near_end = scaled < 1.0F || scaled > 254.0F;
  return static_cast<std::uint8_t>(
      static_cast<int>(scaled + (near_end ? thresholds.even[index] : thresholds.triangular[index])));
}

void dither_row(std::span<const float> encoded, int y, int channels, std::uint8_t* out) {
  static const Thresholds thresholds = make_thresholds();
  Spread spread;
  std::uint32_t position = spread.spread_bits(0, static_cast<std::uint32_t>(y));
  for (std::size_t i = 0; i < encoded.size(); i += 4) {
    std::uint32_t shifted = position;
    for (std::size_t c = 0; c < 3; ++c) {
      *out++ = dithered(encoded[i + c], shifted >> 24, thresholds);
      shifted += kStepChannel;
    }
    if (channels == 4) {
      *out++ = static_cast<std::uint8_t>(unit_or_zero(encoded[i + 3]) * 255.0F + 0.5F);
    }
    position += spread.kSpreadX;
  }
}

template <class Word>
void round_row(std::span<const float> encoded, int channels, float largest, Word* out) {
  for (std::size_t i = 0; i < encoded.size(); i += 4) {
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
      *out++ = static_cast<Word>(unit_or_zero(encoded[i + c]) * largest + 0.5F);
    }
  }
}

}  // namespace

PixelImage make_pixels(int width, int height, const QuantizeOptions& options) {
  assert(options.bits == 8 || options.bits == 16);
  PixelImage pixels;
  pixels.width = width;
  pixels.height = height;
  pixels.channels = options.alpha ? 4 : 3;
  pixels.bits = options.bits;
  const std::size_t samples =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(pixels.channels);
  pixels.bytes.resize(options.bits == 8 ? samples : 0);
  pixels.words.resize(options.bits == 16 ? samples : 0);
  return pixels;
}

void quantize_row(std::span<const float> encoded, int y, const QuantizeOptions& options, PixelImage& pixels,
                  int first_row) {
  const std::size_t first = static_cast<std::size_t>(y - first_row) * static_cast<std::size_t>(pixels.width) *
                            static_cast<std::size_t>(pixels.channels);
  if (options.bits == 16) {
    round_row(encoded, pixels.channels, 65535.0F, pixels.words.data() + first);
  } else if (options.dither) {
    dither_row(encoded, y, pixels.channels, pixels.bytes.data() + first);
  } else {
    round_row(encoded, pixels.channels, 255.0F, pixels.bytes.data() + first);
  }
}

PixelImage quantize(const RadianceImage& encoded, const QuantizeOptions& options, int first_row) {
  PixelImage pixels = make_pixels(encoded.width, encoded.height, options);
  const std::size_t row = 4 * static_cast<std::size_t>(encoded.width);
  for_row_strips(encoded.height, [&](int first, int end) {
    for (int y = first; y < end; ++y) {
      quantize_row({encoded.rgba.data() + static_cast<std::size_t>(y) * row, row}, first_row + y, options, pixels,
                   first_row);
    }
  });
  return pixels;
}

}  // namespace airlight
