#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "core/post/host_post.h"
#include "core/post/post.h"

// The pass's own text, also on float: a picture has millions of texels, each of which takes a logarithm.
namespace airlight::row_statistics {
namespace {

using real = float;
using uint = std::uint32_t;
using std::log;
using std::max;
using std::min;
using std::sqrt;

#include "shaders/shared/statistics.h"  // by itself: what comes next is written with its types

struct vec3 {
  real x, y, z;
};

real clamp(real x, real least, real most) {
  return min(max(x, least), most);
}

// As in the pass, by bits: the compiler could optimise std::isfinite() away.
bool is_finite(real x) {
  return (std::bit_cast<uint>(x) & 0x7f800000U) != 0x7f800000U;
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"  // numbers in GLSL are doubles in C++
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#include "shaders/post/luminance.glsl"
#include "shaders/post/row_statistics.glsl"
#pragma GCC diagnostic pop

constexpr uint kLanes = 64;  // number of partial sums, so that those of long rows are exact, as in the pass

RowStatistics row_of(const float* texels, uint width, real brightest, bool signed_colours) {
  std::array<RowStatistics, kLanes> partial;
  partial.fill(empty_statistics(width));
  for (uint x = 0; x < width; ++x) {
    const float* texel = texels + 4 * static_cast<std::size_t>(x);
    RowStatistics& lane = partial[x % kLanes];
    lane = with_texel(lane, {texel[0], texel[1], texel[2]}, texel[3], x, brightest, signed_colours);
  }
  return std::accumulate(partial.begin() + 1, partial.end(), partial.front(), sum_of);
}

}  // namespace
}  // namespace airlight::row_statistics

namespace airlight {
namespace {

using row_statistics::RowStatistics;

}  // namespace

BufferId add_picture_statistics(Plan& plan, const Picture& picture, double brightest, bool signed_colours) {
  const BufferId rows = plan.add_buffer({.name = "picture_statistics",
                                         .bytes = picture.height * sizeof(RowStatistics),
                                         .host_readable = true,
                                         .zeroed = false});
  plan.add_pass({.name = "picture_statistics",
                 .shader = "picture_statistics",
                 .reads = {{"picture", picture.buffer}},
                 .writes = {{"rows_out", rows}},
                 .grid = {256, picture.height, 1},
                 .push_constants = {picture.width, picture.height, push_constant(brightest)},
                 .specialization = {{"kSigned", signed_colours ? 1U : 0U}}});
  return rows;
}

Statistics picture_statistics(const RadianceImage& radiance, const Scene& scene) {
  return summarize(row_statistics_of(radiance, brightest_metered(scene), scene.spectra.has_value()),
                   static_cast<std::uint32_t>(radiance.width));
}

Statistics table_statistics(const RadianceImage& table) {
  return summarize(row_statistics_of(table, static_cast<double>(std::numeric_limits<float>::max()), false),
                   static_cast<std::uint32_t>(table.width));
}

Statistics summarize(std::span<const std::byte> rows, std::uint32_t width) {
  Statistics all;
  double log_sum = 0.0;
  double weight = 0.0;
  for (std::size_t y = 0; y < rows.size() / sizeof(RowStatistics); ++y) {
    RowStatistics row;
    std::memcpy(&row, rows.data() + y * sizeof row, sizeof row);
    if (all.sound() && row.first_bad < width) {
      all.first_bad_x = row.first_bad;
      all.first_bad_y = static_cast<std::uint32_t>(y);
    }
    log_sum += static_cast<double>(row.log_luminance_sum);
    weight += static_cast<double>(row.weight);
    all.max_luminance = std::max(all.max_luminance, static_cast<double>(row.max_luminance));
    all.not_finite += row.not_finite;
    all.negative += row.negative;
    all.outside += row.outside;
  }
  all.metered_luminance = weight > 0.0 ? std::exp(log_sum / weight) : 0.0;
  return all;
}

std::vector<std::byte> row_statistics_of(const RadianceImage& rows, double brightest, bool signed_colours) {
  std::vector<std::byte> bytes(static_cast<std::size_t>(rows.height) * sizeof(RowStatistics));
  for (int y = 0; y < rows.height; ++y) {
    const RowStatistics row = row_statistics::row_of(rows.at(0, y), static_cast<std::uint32_t>(rows.width),
                                                     static_cast<float>(brightest), signed_colours);
    std::memcpy(bytes.data() + static_cast<std::size_t>(y) * sizeof row, &row, sizeof row);
  }
  return bytes;
}

bool bloom_glows(const Scene& scene, bool glares, const Statistics& statistics, double exposure) {
  const Bloom& bloom = scene.bloom;
  if (!bloom.enabled || bloom.intensity <= 0.0) {
    return false;
  }
  return bloom.model == BloomModel::glare ? glares : statistics.max_luminance * exposure > bloom.threshold;
}

std::string no_bloom(const Scene& scene) {
  return scene.bloom.model == BloomModel::glare ? "bloom: no sun before the camera"
                                                : "bloom: nothing is brighter than its threshold";
}

}  // namespace airlight
