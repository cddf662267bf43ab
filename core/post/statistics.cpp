#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/physics/vector.h"
#include "core/post/host_post.h"
#include "core/post/post.h"

// The passes' text on double.
namespace airlight::physics::row_statistics {
namespace {

#include "shaders/shared/statistics.h"

bool is_finite(real x) {
  return std::isfinite(x);
}

#include "shaders/post/luminance.glsl"
#include "shaders/post/row_statistics.glsl"

}  // namespace
}  // namespace airlight::physics::row_statistics

namespace airlight {
namespace {

using real = float;
using uint = std::uint32_t;
#include "shaders/shared/statistics.h"

std::uint32_t bits(double x) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(x));
}

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
                 .grid = {64, picture.height, 1},
                 .push_constants = {picture.width, picture.height, bits(brightest)},
                 .specialization = {{"kSigned", signed_colours ? 1U : 0U}}});
  return rows;
}

Statistics table_statistics(const RadianceImage& table) {
  return summarize(row_statistics_of(table, std::numeric_limits<double>::max(), false),
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
  namespace host = physics::row_statistics;
  std::vector<std::byte> bytes(static_cast<std::size_t>(rows.height) * sizeof(RowStatistics));
  for (int y = 0; y < rows.height; ++y) {
    host::RowStatistics sum = host::empty_statistics(static_cast<physics::uint>(rows.width));
    for (int x = 0; x < rows.width; ++x) {
      const float* pixel = rows.at(x, y);
      const auto channel = [&](int c) { return static_cast<double>(pixel[c]); };
      sum = host::with_texel(sum, {channel(0), channel(1), channel(2)}, channel(3), static_cast<physics::uint>(x),
                             brightest, signed_colours);
    }
    const RowStatistics row{static_cast<float>(sum.weight),
                            static_cast<float>(sum.log_luminance_sum),
                            static_cast<float>(sum.max_luminance),
                            sum.not_finite,
                            sum.negative,
                            sum.outside,
                            sum.first_bad};
    std::memcpy(bytes.data() + static_cast<std::size_t>(y) * sizeof row, &row, sizeof row);
  }
  return bytes;
}

bool bloom_glows(const Scene& scene, const Air& air, const Statistics& statistics, double exposure) {
  const Bloom& bloom = scene.bloom;
  if (!bloom.enabled || bloom.intensity <= 0.0) {
    return false;
  }
  return bloom.model == BloomModel::glare ? sun_glares(scene, air)
                                          : statistics.max_luminance * exposure > bloom.threshold;
}

std::string no_bloom(const Scene& scene) {
  return scene.bloom.model == BloomModel::glare ? "bloom: no sun before the camera"
                                                : "bloom: nothing is brighter than its threshold";
}

}  // namespace airlight
