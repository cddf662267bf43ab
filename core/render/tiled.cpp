#include "core/render/tiled.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <optional>
#include <utility>

#include "core/plan/bytes.h"
#include "core/post/host_post.h"
#include "core/render/band_passes.h"
#include "core/render/picture_key.h"
#include "core/render/sky.h"
#include "core/render/timings.h"

namespace airlight {
namespace {

constexpr std::size_t kUsualTilePixels = std::size_t{1} << 21;

std::size_t layer_planes(const Stage& stage) {
  return 3 * (static_cast<std::size_t>(std::popcount(stage.scattering_media())) + 3);
}

// Copies rows of a tile to their columns of the band.
void put(RadianceImage& band, std::span<const std::byte> tile_bytes, const Tile& tile) {
  const std::size_t row = 4 * static_cast<std::size_t>(tile.width);
  for (int y = 0; y < tile.height; ++y) {
    float* to = band.rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(band.width) +
                                        static_cast<std::size_t>(tile.x));
    std::memcpy(to, tile_bytes.data() + static_cast<std::size_t>(y) * row * sizeof(float), row * sizeof(float));
  }
}

void put(std::vector<Layer>& band, const std::vector<Layer>& tile_layers, const Tile& tile, int width) {
  for (std::size_t i = 0; i < band.size(); ++i) {
    const std::size_t pixels = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
    const std::size_t plane = static_cast<std::size_t>(width) * static_cast<std::size_t>(tile.height);
    band[i].planes.resize(plane * band[i].channels.size());
    for (std::size_t k = 0; k < band[i].channels.size() * static_cast<std::size_t>(tile.height); ++k) {
      const std::size_t c = k / static_cast<std::size_t>(tile.height);
      const std::size_t y = k % static_cast<std::size_t>(tile.height);
      const float* from = tile_layers[i].planes.data() + c * pixels + y * static_cast<std::size_t>(tile.width);
      std::copy(
          from, from + tile.width,
          band[i].planes.data() + c * plane + y * static_cast<std::size_t>(width) + static_cast<std::size_t>(tile.x));
    }
  }
}

// One round through the picture: to measure it, or to deliver it.
enum class Round { measuring, delivering };

class TiledRender {
 public:
  TiledRender(const DeviceOnDemand& device, const Stage& stage, const TiledRequest& request)
      : device_(device), stage_(stage), scene_(stage_.scene()), request_(request), kept_as_(picture_key()) {}

  Rendering run();

 private:
  bool wants_bloom() const { return request_.picture.bloom && scene_.bloom.enabled; }
  bool stops() const { return !request_.past_faults && !out_.fault().empty(); }
  Tile whole_rows(int y, int rows) const { return {0, y, scene_.image.width, rows}; }
  bool in_columns() const { return host_.radiance.rgba.empty() && request_.tile.width < scene_.image.width; }

  void go_through(Round round, double from, double to);
  void deliver(Band& band);
  void render_band(Band& band, int rows, const BandWork& work);
  Sky add_tile(Plan& plan, const Tile& tile);
  void run_rows(Plan& plan, const Picture& rows, const BandWork& work, Band& band);
  void add_statistics(std::span<const std::byte> rows);
  void measure(const Band& band);
  void take_host_rows(const Tile& rows, const BandWork& work, Band& band);
  void render_tile(Band& band, const Tile& tile);
  Picture add_upload(Plan& plan, const RadianceImage& image, int first_row, const Tile& rows) const;
  void add_layers(Band& band, int rows);
  RunResult run_plan(const Plan& plan);
  void make_bloom();
  Statistics statistics() const { return summarize(rows_, static_cast<std::uint32_t>(scene_.image.width)); }

  const DeviceOnDemand& device_;
  const Stage stage_;
  const Scene& scene_;
  const TiledRequest& request_;
  std::string kept_as_;
  HostPicture host_;  // of a method on the host
  Rendering out_;
  std::vector<std::byte> rows_;  // statistics of all rows so far
  bool two_rounds_ = false;
  std::vector<physics::GlarePoint> glare_;  // empty: none

  std::optional<TableReads> table_reads_;  // of the first tile's plan, which makes the tables
  bool tables_seen_ = false;
};

RunResult TiledRender::run_plan(const Plan& plan) {
  RunResult result = device_().run(plan);
  Timings{out_.passes, out_.host}.add(result);
  if (table_reads_) {
    table_reads_->take(result, out_.tables_statistics, out_.tables);
    table_reads_.reset();
  }
  return result;
}

// Sky and disc of a tile, by a method on the device.
Sky TiledRender::add_tile(Plan& plan, const Tile& tile) {
  const Sky sky = add_sky(plan, stage_, {.directions = {}, .tile = tile, .kept_as = kept_as_}, true);
  if (!std::exchange(tables_seen_, true)) {
    table_reads_.emplace(plan, sky, request_.picture.tables);
  }
  return sky;
}

void TiledRender::render_tile(Band& band, const Tile& tile) {
  Plan plan;
  const Sky sky = add_tile(plan, tile);
  const RunResult result = run_plan(plan);
  put(band.rows.radiance, result.contents(sky.radiance), tile);
}

// Uploads rows of an image of the host's; `rows` is their place in the picture.
Picture TiledRender::add_upload(Plan& plan, const RadianceImage& image, int first_row, const Tile& rows) const {
  const std::size_t row = 4 * static_cast<std::size_t>(rows.width);
  BufferDesc buffer = filled_buffer("radiance", bytes_of(std::span(image.rgba)
                                                             .subspan(static_cast<std::size_t>(first_row) * row,
                                                                      row * static_cast<std::size_t>(rows.height))));
  buffer.host_readable = true;
  return picture_of(plan.add_buffer(std::move(buffer)), rows);
}

// Runs the plan that makes or holds these rows, and takes the rows and all results of them.
void TiledRender::run_rows(Plan& plan, const Picture& rows, const BandWork& work, Band& band) {
  const bool host_measures_them = work.statistics && host_measures(device_());
  BandWork on_device = work;
  on_device.statistics = work.statistics && !host_measures_them;
  const BandPasses passes(plan, scene_, rows, on_device);
  const RunResult result = run_plan(plan);
  const Tile tile = whole_rows(band.y, static_cast<int>(rows.height));
  put(band.rows.radiance, result.contents(rows.buffer), tile);
  passes.take(result, band.rows);
  if (host_measures_them) {
    measure(band);
  } else {
    add_statistics(passes.statistics(result));
  }
}

void TiledRender::add_statistics(std::span<const std::byte> rows) {
  rows_.insert(rows_.end(), rows.begin(), rows.end());
}

// Measures the band on the host.
void TiledRender::measure(const Band& band) {
  add_statistics(row_statistics_of(band.rows.radiance, brightest_metered(scene_), stage_.in_colours()));
}

// Takes rows without a device.
void TiledRender::take_host_rows(const Tile& rows, const BandWork& work, Band& band) {
  if (work.statistics) {
    measure(band);
  }
  if (work.glare != nullptr && work.bloom_picture) {
    band.rows.bloom = glare_picture(scene_, *work.glare, rows);
  }
}

// Sums over rows are taken over whole rows, whatever tiles make them up, as in a picture rendered at once.
void TiledRender::render_band(Band& band, int rows, const BandWork& work) {
  const int width = scene_.image.width;
  const Tile whole = whole_rows(band.y, rows);
  band.rows.radiance = {width, rows,
                        std::vector<float>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(rows))};
  Plan plan;
  if (!host_.radiance.rgba.empty()) {
    band.rows.radiance = rows_of(host_.radiance, band.y, rows);
    draw_disc_over(band.rows.radiance, stage_, whole);
    if (work.gpu_tone) {
      plan.scene_data = device_scene_bytes(stage_.whole().air, scene_, whole);
      run_rows(plan, add_upload(plan, band.rows.radiance, 0, whole), work, band);
    } else {
      take_host_rows(whole, work, band);
    }
  } else if (in_columns()) {
    for (int x = 0; x < width; x += request_.tile.width) {
      render_tile(band, {x, band.y, std::min(request_.tile.width, width - x), rows});
    }
    plan.scene_data = device_scene_bytes(stage_.whole().air, scene_, whole);
    run_rows(plan, add_upload(plan, band.rows.radiance, 0, whole), work, band);
  } else {
    const Sky sky = add_tile(plan, whole);
    run_rows(plan, picture_of(sky.radiance, whole), work, band);
  }
}

void TiledRender::add_layers(Band& band, int rows) {
  const int width = scene_.image.width;
  band.rows.layers = layers_of(stage_);
  for (int x = 0; x < width; x += request_.tile.width) {
    const Tile tile{x, band.y, std::min(request_.tile.width, width - x), rows};
    put(band.rows.layers, render_layers(device_(), stage_, tile, kept_as_, {out_.passes, out_.host}), tile, width);
  }
  for (const Layer& layer : band.rows.layers) {
    Statistics found = layer_statistics(layer, width, stage_.in_colours());
    found.first_bad_y += static_cast<std::uint32_t>(band.y);
    if (!found.sound() || band.y == 0) {
      out_.layer_statistics.push_back({layer.name, found});
    }
  }
}

void TiledRender::deliver(Band& band) {
  if (request_.picture.layers && out_.picture_fault().empty()) {
    add_layers(band, band.rows.radiance.height);
  }
  if (!host_.standard_error.rgba.empty()) {
    band.rows.standard_error = rows_of(host_.standard_error, band.y, band.rows.radiance.height);
  }
  if (!stops()) {
    request_.sink(band);
  }
}

void TiledRender::go_through(Round round, double from, double to) {
  BandWork work;
  work.statistics = !two_rounds_ || round == Round::measuring;
  if (round == Round::delivering) {
    work.glare = glare_.empty() ? nullptr : &glare_;
    work.bloom_picture = request_.picture.bloom_picture;
    work.gpu_tone = request_.picture.gpu_tone;
    work.exposure = out_.exposure;
  }
  const int height = scene_.image.height;
  const std::size_t row =
      band_pixel_bytes(stage_, request_.picture.layers) * static_cast<std::size_t>(scene_.image.width);
  const int most_rows = std::max(1, static_cast<int>(kBandBytes / row));
  for (int y = 0; y < height && !stops();) {
    const int rows = std::min({request_.tile.height, most_rows, height - y});
    Band band;
    band.y = y;
    render_band(band, rows, work);
    out_.picture = statistics();
    if (round == Round::delivering) {
      band.rows.exposure = out_.exposure;
      band.rows.left_out = out_.left_out;
      deliver(band);
    }
    y += rows;
    if (request_.report) {
      request_.report(from + (to - from) * y / height);
    }
  }
}

// Called before the picture is delivered.
void TiledRender::make_bloom() {
  if (!wants_bloom()) {
    return;
  }
  if (!bloom_glows(stage_.whole(), out_.picture, out_.exposure)) {
    out_.left_out.push_back(no_bloom(scene_));
    return;
  }
  glare_ = glare_points_of(stage_);
}

Rendering TiledRender::run() {
  if (samples(stage_)) {
    host_ = stage_.method().render_on_host(stage_, View{}, request_.picture.host);
    out_.undone = host_.notes;
  }
  out_.left_out = spared_by(stage_);
  Plan whole;  // never run
  if (!add_sun_disc(whole, stage_.whole(), std::nullopt, picture_of(BufferId{}, whole_rows(0, scene_.image.height)))) {
    out_.left_out.push_back("sun disc: switched off, outside the picture or behind the planet");
  }
  two_rounds_ = request_.exposure_first && !scene_.display.exposure;
  out_.exposure = scene_.display.exposure ? exposure_for(scene_, {}) : 1.0;
  if (two_rounds_) {
    go_through(Round::measuring, 0.0, 0.5);
    out_.exposure = exposure_for(scene_, out_.picture);
  }
  if (out_.fault().empty()) {
    make_bloom();
  }
  go_through(Round::delivering, two_rounds_ ? 0.5 : 0.0, 1.0);
  out_.exposure = exposure_for(scene_, out_.picture);
  return std::move(out_);
}

}  // namespace

bool needs_whole_picture(const Scene& scene, const RenderRequest& request) {
  return request.bloom && scene.bloom.enabled && scene.bloom.model == BloomModel::chain;
}

std::size_t tile_pixel_bytes(const Stage& stage, bool layers) {
  return sizeof(float) * std::max<std::size_t>(4, layers ? layer_planes(stage) : 0);
}

std::size_t band_pixel_bytes(const Stage& stage, bool layers) {
  return sizeof(float) * (4 + (layers ? layer_planes(stage) + 3 + 1 + 3 : 0));
}

ImageSize usual_tile(const Stage& stage, bool layers) {
  const std::size_t pixels = kUsualTilePixels * 4 * sizeof(float) / band_pixel_bytes(stage, layers);
  const auto rows = static_cast<int>(pixels / static_cast<std::size_t>(stage.scene().image.width));
  return {stage.scene().image.width, std::max(1, rows)};
}

RadianceImage rows_of(const RadianceImage& whole, int first, int count) {
  const std::size_t row = 4 * static_cast<std::size_t>(whole.width);
  const auto begin = whole.rgba.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(first));
  return {whole.width, count, {begin, begin + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(count))}};
}

Rendering rows_of(const Rendering& whole, int first, int count) {
  const auto cut = [&](const RadianceImage& image) { return rows_of(image, first, count); };
  Rendering rows;
  rows.radiance = cut(whole.radiance);
  rows.standard_error = whole.standard_error ? std::optional(cut(*whole.standard_error)) : std::nullopt;
  rows.bloom = whole.bloom ? std::optional(cut(*whole.bloom)) : std::nullopt;
  const auto width = static_cast<std::size_t>(whole.radiance.width);
  const std::size_t from = width * static_cast<std::size_t>(first);
  const std::size_t pixels = width * static_cast<std::size_t>(count);
  if (!whole.encoded.empty()) {
    const auto begin = whole.encoded.begin() + static_cast<std::ptrdiff_t>(4 * from);
    rows.encoded.assign(begin, begin + static_cast<std::ptrdiff_t>(4 * pixels));
  }
  for (const Layer& layer : whole.layers) {
    Layer part = layer.like();
    const std::size_t plane = layer.planes.size() / layer.channels.size();
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
      const auto begin = layer.planes.begin() + static_cast<std::ptrdiff_t>(c * plane + from);
      part.planes.insert(part.planes.end(), begin, begin + static_cast<std::ptrdiff_t>(pixels));
    }
    rows.layers.push_back(std::move(part));
  }
  rows.exposure = whole.exposure;
  rows.picture = whole.picture;
  rows.tables_statistics = whole.tables_statistics;
  rows.layer_statistics = whole.layer_statistics;
  rows.left_out = whole.left_out;
  return rows;
}

Rendering render_tiled(const DeviceOnDemand& device, const Stage& stage, const TiledRequest& request) {
  assert(request.tile.width > 0 && request.tile.height > 0);
  assert(!needs_whole_picture(stage.scene(), request.picture));
  return TiledRender(device, stage, request).run();
}

}  // namespace airlight
