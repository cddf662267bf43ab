#include "core/render/tiled.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "core/methods/scene_air.h"
#include "core/render/picture_key.h"
#include "core/render/timings.h"

namespace airlight {
namespace {

constexpr std::size_t kUsualTilePixels = std::size_t{1} << 21;

std::size_t layer_planes(const Scene& scene) {
  return 3 * (static_cast<std::size_t>(std::popcount(air_of(scene).scattering_media())) + 3);
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

class TiledRender {
 public:
  TiledRender(Executor& executor, const Scene& scene, const TiledRequest& request)
      : executor_(executor),
        scene_(scene),
        request_(request),
        method_(*find_method(scene.render.method)),
        air_(air_of(scene)),
        kept_as_(picture_key()) {}

  Rendering run();

 private:
  void render_band(Band& band, int rows);
  void render_tile(Band& band, const Tile& tile);
  void add_layers(Band& band, const Tile& tile);
  void take_tables(const Plan& plan, const std::vector<ImageId>& tables, const std::vector<BufferId>& rows,
                   const RunResult& result);
  void measure_rows(const RadianceImage& band);
  void append_rows(std::span<const std::byte> rows) { rows_.insert(rows_.end(), rows.begin(), rows.end()); }
  Statistics statistics() const { return summarize(rows_, static_cast<std::uint32_t>(scene_.image.width)); }

  Executor& executor_;
  const Scene& scene_;
  const TiledRequest& request_;
  const SkyMethod& method_;
  const Air air_;
  std::string kept_as_;
  Rendering out_;
  std::vector<std::byte> rows_;  // statistics of all rows so far
};

void TiledRender::take_tables(const Plan& plan, const std::vector<ImageId>& tables, const std::vector<BufferId>& rows,
                              const RunResult& result) {
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const ImageDesc& image = plan.images()[tables[i].index];
    out_.tables_statistics.push_back({image.name, summarize(result.contents(rows[i]), image.extent.width)});
  }
}

// The tables are made, and looked at, with the first tile.
void TiledRender::render_tile(Band& band, const Tile& tile) {
  Plan plan;
  plan.scene_data = device_scene_bytes(air_, scene_, tile);
  const SkyPasses sky = method_.add_passes(plan, scene_, air_, {.directions = {}, .tile = tile, .kept_as = kept_as_});
  const Picture picture = picture_of(sky.radiance, tile);
  add_sun_disc(plan, scene_, air_, sky.tables.empty() ? std::nullopt : std::optional(sky.tables.front()), picture);
  const bool first = tile.x == 0 && tile.y == 0;
  std::vector<BufferId> table_rows;
  if (first) {
    for (const ImageId table : sky.tables) {
      table_rows.push_back(add_table_statistics(plan, table));
    }
  }
  const bool whole_rows = tile.width == scene_.image.width;
  const BufferId rows = whole_rows ? add_picture_statistics(plan, picture) : BufferId{};
  const RunResult result = executor_.run(plan);
  add_timings(out_.passes, result.passes);
  add_timings(out_.host, result.host);
  if (first) {
    take_tables(plan, sky.tables, table_rows, result);
  }
  if (whole_rows) {
    append_rows(result.contents(rows));
  }
  put(band.radiance, result.contents(sky.radiance), tile);
}

void TiledRender::add_layers(Band& band, const Tile& tile) {
  put(band.layers, render_layers(executor_, scene_, tile, kept_as_, {out_.passes, out_.host}), tile,
      scene_.image.width);
}

// Sums over rows as they are taken of the whole picture, whatever tiles a row was made of.
void TiledRender::measure_rows(const RadianceImage& band) {
  Plan plan;
  std::vector<std::byte> bytes(band.rgba.size() * sizeof(float));
  std::memcpy(bytes.data(), band.rgba.data(), bytes.size());
  const std::size_t size = bytes.size();
  const BufferId radiance = plan.add_buffer(
      {.name = "radiance", .bytes = size, .host_readable = false, .contents = std::move(bytes), .key = {}});
  const BufferId rows = add_picture_statistics(plan, picture_of(radiance, {0, 0, band.width, band.height}));
  const RunResult result = executor_.run(plan);
  add_timings(out_.passes, result.passes);
  add_timings(out_.host, result.host);
  append_rows(result.contents(rows));
}

void TiledRender::render_band(Band& band, int rows) {
  const int width = scene_.image.width;
  band.radiance = {width, rows,
                   std::vector<float>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(rows))};
  if (request_.layers) {
    band.layers = layers_of(scene_);
  }
  for (int x = 0; x < width; x += request_.tile.width) {
    const Tile tile{x, band.y, std::min(request_.tile.width, width - x), rows};
    render_tile(band, tile);
    if (request_.layers) {
      add_layers(band, tile);
    }
  }
  if (request_.tile.width < width) {
    measure_rows(band.radiance);
  }
  for (const Layer& layer : band.layers) {
    Statistics found = layer_statistics(layer, width);
    found.first_bad_y += static_cast<std::uint32_t>(band.y);
    if (!found.sound() || band.y == 0) {
      out_.layer_statistics.push_back({layer.name, found});
    }
  }
}

Rendering TiledRender::run() {
  const int width = scene_.image.width;
  const int height = scene_.image.height;
  Plan whole;  // never run
  if (!add_sun_disc(whole, scene_, air_, std::nullopt, picture_of(BufferId{}, {0, 0, width, height}))) {
    out_.left_out.push_back("sun disc: switched off, outside the picture or behind the planet");
  }
  const std::size_t band_row = band_pixel_bytes(scene_, request_.layers) * static_cast<std::size_t>(width);
  const int most_rows = std::max(1, static_cast<int>(kBandBytes / band_row));
  for (int y = 0; y < height && out_.fault().empty();) {
    const int rows = std::min({request_.tile.height, most_rows, height - y});
    Band band{y, {}, {}, out_.left_out};
    render_band(band, rows);
    out_.picture = statistics();
    if (out_.fault().empty()) {
      request_.sink(band);
    }
    y += rows;
    if (request_.report) {
      request_.report(static_cast<double>(y) / height);
    }
  }
  out_.exposure = exposure_for(scene_.display, out_.picture);
  return std::move(out_);
}

}  // namespace

std::size_t tile_pixel_bytes(const Scene& scene, bool layers) {
  return sizeof(float) * std::max<std::size_t>(4, layers ? layer_planes(scene) : 0);
}

std::size_t band_pixel_bytes(const Scene& scene, bool layers) {
  return sizeof(float) * (4 + (layers ? layer_planes(scene) + 3 + 1 + 3 : 0));
}

ImageSize usual_tile(const Scene& scene, bool layers) {
  const std::size_t pixels = kUsualTilePixels * 4 * sizeof(float) / band_pixel_bytes(scene, layers);
  const auto rows = static_cast<int>(pixels / static_cast<std::size_t>(scene.image.width));
  return {scene.image.width, std::max(1, rows)};
}

Rendering render_tiled(const DeviceOnDemand& device, const Scene& scene, const TiledRequest& request) {
  assert(request.tile.width > 0 && request.tile.height > 0);
  assert(find_method(scene.render.method)->add_passes != nullptr);
  return TiledRender(device(), scene, request).run();
}

}  // namespace airlight
