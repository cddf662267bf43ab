#include "core/output/half_block.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>

#include "core/output/parallel.h"

namespace airlight {
namespace {

// Bit patterns of floats without their sign; as integers they have the order of the numbers.
constexpr std::int32_t kLargestHalf = 0x477fe000;     // 65504
constexpr std::int32_t kSmallestNormal = 0x38800000;  // 2^-14
constexpr std::int32_t kInfinity = 0x7f800000;

// Integer selects instead of branches, so that the loop over samples can be vectorised.
std::uint16_t half_bits(float sample) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(sample);
  const std::uint32_t sign = (bits >> 16) & 0x8000U;
  const std::uint32_t magnitude = bits & 0x7fffffffU;
  // Exponent bias 127 to 15, ten bits of mantissa, ties to even.
  const std::uint32_t normal = (magnitude + 0xfffU + ((magnitude >> 13) & 1U) - 0x38000000U) >> 13;
  // Below 2^-14 the step is 2^-24, the step of floats in [0.5, 1): the addition rounds.
  const std::uint32_t small = std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5F) - 0x3f000000U;
  const std::int32_t order = static_cast<std::int32_t>(magnitude);
  std::uint32_t half = order < kSmallestNormal ? small : normal;
  half = order > kLargestHalf ? 0x7bffU : half;
  half = order > kInfinity ? 0x7e00U : half;
  return static_cast<std::uint16_t>(sign | half);
}

// Contiguous samples, few enough for 32-bit counters.
struct BlockCounts {
  std::uint32_t clamped = 0, underflowed = 0, negative = 0, nan = 0;
};

BlockCounts count_block(const float* samples, std::size_t count) {
  BlockCounts found;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t bits = std::bit_cast<std::int32_t>(samples[i]);
    const std::int32_t order = bits & 0x7fffffff;
    const std::uint32_t nan = order > kInfinity ? 1 : 0;
    found.nan += nan;
    found.clamped += (order > kLargestHalf ? 1U : 0U) - nan;
    found.underflowed += order < kSmallestNormal && order > 0 ? 1 : 0;
    found.negative += bits < 0 && order > 0 && order <= kInfinity ? 1 : 0;
  }
  return found;
}

constexpr std::size_t kBlock = 1024;

// Calls work(samples, first, count) on contiguous copies of strided samples.
template <class Work>
void for_blocks(const float* samples, std::size_t stride, std::size_t count, const Work& work) {
  std::array<float, kBlock> block;
  for (std::size_t first = 0; first < count; first += kBlock) {
    const std::size_t length = std::min(kBlock, count - first);
    for (std::size_t i = 0; i < length; ++i) {
      block[i] = samples[(first + i) * stride];
    }
    work(block.data(), first, length);
  }
}

}  // namespace

void convert_to_half(const float* samples, std::size_t stride, std::size_t count, std::uint16_t* halves,
                     ExrCounts& counts) {
  for_blocks(samples, stride, count, [&](const float* block, std::size_t first, std::size_t length) {
    for (std::size_t i = 0; i < length; ++i) {
      halves[first + i] = half_bits(block[i]);
    }
    const BlockCounts found = count_block(block, length);
    add_counts(counts, {length, found.clamped, found.underflowed, found.negative, found.nan});
  });
}

void copy_floats(const float* samples, std::size_t stride, std::size_t count, std::uint16_t* words, ExrCounts& counts) {
  for_blocks(samples, stride, count, [&](const float* block, std::size_t first, std::size_t length) {
    std::memcpy(words + 2 * first, block, length * sizeof(float));
    const BlockCounts found = count_block(block, length);
    add_counts(counts, {length, 0, 0, found.negative, found.nan});
  });
}

std::string half_loss(const RadianceImage& image, double typical) {
  constexpr float kFewBits = 0x1p-16F;
  constexpr float kLargest = 65504.0F;
  const float dark = static_cast<float>(typical / 256.0);
  std::atomic<std::size_t> matter = 0;
  std::atomic<std::size_t> faint = 0;
  std::atomic<std::size_t> bright = 0;
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  for_row_strips(image.height, [&](int begin, int end) {
    std::size_t matters = 0;
    std::size_t faints = 0;
    std::size_t brights = 0;
    for (std::size_t i = row * static_cast<std::size_t>(begin); i < row * static_cast<std::size_t>(end); i += 4) {
      for (std::size_t c = 0; c < 3; ++c) {
        const float sample = image.rgba[i + c];
        const bool is_seen = sample > 0.0F && sample >= dark;
        matters += is_seen ? 1 : 0;
        faints += is_seen && sample < kFewBits ? 1 : 0;
        brights += sample > kLargest ? 1 : 0;
      }
    }
    matter += matters;
    faint += faints;
    bright += brights;
  });
  if (bright > 0) {
    return std::to_string(bright) + " samples are above 65504, the largest half";
  }
  return faint * 100 > matter ? "it is too dark for the digits of halves" : "";
}

void add_counts(ExrCounts& total, const ExrCounts& part) {
  total.samples += part.samples;
  total.clamped += part.clamped;
  total.underflowed += part.underflowed;
  total.negative += part.negative;
  total.nan += part.nan;
}

}  // namespace airlight
