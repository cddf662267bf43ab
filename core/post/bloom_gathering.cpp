#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/plan/bytes.h"
#include "core/post/bloom_grid.h"
#include "core/post/post.h"

namespace airlight {
namespace {

constexpr std::size_t kTexel = 4 * sizeof(float);
// Most bytes of sums in one buffer on the way to the device.
constexpr std::size_t kFillBytes = std::size_t{32} << 20;

}  // namespace

BloomGathering::BloomGathering(const Scene& scene)
    : picture_{static_cast<std::uint32_t>(scene.image.width), static_cast<std::uint32_t>(scene.image.height), 1},
      grid_(bloom_grid(scene)) {}

// One row more on either side than the shader, which computes in floats, may touch; that row adds nothing.
BloomGathering::Rows BloomGathering::touched(const Picture& band) const {
  const double scale = static_cast<double>(picture_.height) / grid_.height;
  const double first = std::floor(band.y / scale) - 1.0;
  const double last = std::floor((band.y + band.height) / scale) + 1.0;
  const double most = grid_.height - 1.0;
  const auto low = static_cast<std::uint32_t>(std::clamp(first, 0.0, most));
  const auto high = static_cast<std::uint32_t>(std::clamp(last, 0.0, most));
  return {low, high - low + 1};
}

BufferId BloomGathering::add_band(Plan& plan, const Picture& band) const {
  const Rows rows = touched(band);
  const std::size_t row = 4 * static_cast<std::size_t>(grid_.width);
  const std::size_t bytes = rows.count * row * sizeof(float);
  std::vector<std::byte> so_far(bytes);
  const std::size_t from = rows.first * row;
  if (sums_.size() > from) {
    std::memcpy(so_far.data(), sums_.data() + from, std::min(bytes, (sums_.size() - from) * sizeof(float)));
  }
  const BufferId sums = plan.add_buffer(
      {.name = "bloom_sums", .bytes = bytes, .host_readable = true, .contents = std::move(so_far), .key = {}});
  plan.add_pass({.name = "bloom_gather",
                 .shader = "bloom_gather",
                 .reads = {{"picture", band.buffer}},
                 .writes = {{"sums_out", sums}},
                 .grid = {grid_.width, rows.count, 1},
                 .push_constants = {picture_.width, picture_.height, grid_.width, grid_.height, band.y,
                                    band.y + band.height, rows.first, rows.count}});
  return sums;
}

void BloomGathering::take(const Picture& band, std::span<const std::byte> sums) {
  const std::size_t from = touched(band).first * 4 * static_cast<std::size_t>(grid_.width);
  sums_.resize(std::max(sums_.size(), from + sums.size() / sizeof(float)));
  std::memcpy(sums_.data() + from, sums.data(), sums.size());
}

ImageId BloomGathering::add_base(Plan& plan) const {
  const ImageId base = plan.add_image({.name = "bloom_base", .extent = grid_, .key = {}});
  const std::size_t row = kTexel * grid_.width;
  const auto at_once = static_cast<std::uint32_t>(std::clamp<std::size_t>(kFillBytes / row, 1, grid_.height));
  for (std::uint32_t y = 0; y < grid_.height; y += at_once) {
    const std::uint32_t rows = std::min(at_once, grid_.height - y);
    const auto these = std::span(sums_).subspan(y * row / sizeof(float), rows * row / sizeof(float));
    const BufferId sums = plan.add_buffer(filled_buffer("bloom_sums_" + std::to_string(y), bytes_of(these)));
    plan.add_pass({.name = "bloom_fill_" + std::to_string(y),
                   .shader = "bloom_fill",
                   .reads = {{"sums", sums}},
                   .writes = {{"base_out", base}},
                   .grid = {grid_.width, rows, 1},
                   .push_constants = {picture_.width, picture_.height, y, rows}});
  }
  return base;
}

}  // namespace airlight
