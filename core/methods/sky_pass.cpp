#include "core/methods/sky_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/air/scene_block.h"
#include "core/plan/bytes.h"
#include "core/things/edge_pixels.h"

namespace airlight {
namespace {

std::vector<std::byte> direction_bytes(const View& view) {
  std::vector<float> xyz0;
  for (const Direction& d : view.directions) {
    const double c = std::cos(d.elevation);
    xyz0.push_back(static_cast<float>(std::sin(d.azimuth) * c));
    xyz0.push_back(static_cast<float>(std::sin(d.elevation)));
    xyz0.push_back(static_cast<float>(-std::cos(d.azimuth) * c));
    xyz0.push_back(0.0f);
  }
  if (xyz0.empty()) {
    xyz0.assign(4, 0.0f);  // the shader declares the buffer whatever the projection
  }
  return bytes_of(xyz0);
}

}  // namespace

BufferDesc radiance_buffer(const View& view, std::size_t bytes) {
  return {.name = "radiance",
          .bytes = bytes,
          .host_readable = true,
          .key = std::string(view.tile ? "" : kRadianceKey),
          .carried = !view.tile,
          .zeroed = false};
}

Tile tile_of(const Scene& scene, const View& view) {
  return view.tile.value_or(Tile{0, 0, scene.image.width, scene.image.height});
}

Extent picture_grid(const Scene& scene, const View& view) {
  const Tile tile = tile_of(scene, view);
  return {static_cast<std::uint32_t>(tile.width), static_cast<std::uint32_t>(tile.height), 1};
}

std::string picture_table_key(const View& view, std::string_view table) {
  return view.kept_as.empty() ? std::string() : view.kept_as + " " + std::string(table);
}

std::size_t vectors_of(const View& view) {
  return view.stokes ? 4 : 2;
}

BufferId add_layer_planes(Plan& plan, const Part& part, const View& view) {
  const Extent grid = picture_grid(part.scene, view);
  const auto layers = static_cast<std::size_t>(std::popcount(part.air.scattering_media())) + (view.stokes ? 5 : 3);
  const std::size_t planes = 3 * layers + (part.scene.clouds.empty() ? 0 : kCloudPlanes);
  return plan.add_buffer({.name = "layers",
                          .bytes = planes * grid.width * grid.height * sizeof(float),
                          .host_readable = true,
                          .zeroed = false});
}

void add_layer_constants(std::vector<Specialization>& constants, const Part& part) {
  constants.push_back({"kProjection", projection_code(part.scene.camera.projection)});
  constants.push_back({"kScatteringMedia", part.air.scattering_media()});
}

SkyTarget add_sky_target(Plan& plan, const Scene& scene, const View& view, const std::optional<Canvas>& canvas) {
  const bool listed = !view.directions.empty();
  const auto count = static_cast<std::uint32_t>(view.directions.size());
  SkyTarget target;
  target.grid = listed ? Extent{count, 1, 1} : picture_grid(scene, view);
  target.projection = listed ? physics::kProjectionListed : projection_code(scene.camera.projection);
  target.vectors = listed ? static_cast<std::uint32_t>(vectors_of(view)) : 1;
  const std::size_t vectors = static_cast<std::size_t>(target.grid.width) * target.grid.height * target.vectors;
  target.radiance = canvas ? canvas->radiance : plan.add_buffer(radiance_buffer(view, vectors * 4 * sizeof(float)));
  target.adds = canvas && !canvas->is_blank;
  target.directions = plan.add_buffer(filled_buffer("directions", direction_bytes(view)));
  return target;
}

namespace {

constexpr std::uint32_t kEdgeColumns = 64;

// The pixels of the tile that the planet's edge crosses, from the tile's upper left one.
std::vector<EdgePixel> edges_in(const Part& part, const Tile& tile) {
  std::vector<EdgePixel> pixels;
  for (const EdgePixel& pixel : part.things.edge_pixels()) {
    const auto x = static_cast<int>(pixel.x) - tile.x;
    const auto y = static_cast<int>(pixel.y) - tile.y;
    if (x >= 0 && y >= 0 && x < tile.width && y < tile.height) {
      pixels.push_back({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)});
    }
  }
  return pixels;
}

// A list in rows of kEdgeColumns. The last row is filled up with a pixel that is already in the list, marked by its z.
BufferId add_edge_list(Plan& plan, const std::vector<EdgePixel>& pixels) {
  const std::size_t count = (pixels.size() + kEdgeColumns - 1) / kEdgeColumns * kEdgeColumns;
  std::vector<float> values;
  values.reserve(4 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const EdgePixel& pixel = pixels[std::min(i, pixels.size() - 1)];
    const float repeats = i < pixels.size() ? 0.0F : 1.0F;
    values.insert(values.end(), {static_cast<float>(pixel.x), static_cast<float>(pixel.y), repeats, 0.0F});
  }
  return plan.add_buffer(filled_buffer("edge_pixels", bytes_of(values)));
}

}  // namespace

void add_pass_with_edges(Plan& plan, const Part& part, const View& view, const SkyTarget& target, PassDesc pass) {
  PassDesc edges = pass;
  pass.specialization.push_back({"kEdges", physics::kEdgesLeftOut});
  plan.add_pass(std::move(pass));
  const std::vector<EdgePixel> pixels = target.projection == physics::kProjectionListed
                                            ? std::vector<EdgePixel>()
                                            : edges_in(part, tile_of(part.scene, view));
  if (pixels.empty()) {
    return;
  }
  const BufferId list = add_edge_list(plan, pixels);
  const auto rows = static_cast<std::uint32_t>((pixels.size() + kEdgeColumns - 1) / kEdgeColumns);
  edges.name += "_edge";
  edges.specialization.push_back({"kEdges", physics::kEdgesListed});
  for (Binding& read : edges.reads) {
    read.resource = read.name == "directions" ? ResourceId(list) : read.resource;
  }
  edges.grid = {kEdgeColumns, rows, 1};
  edges.push_constants[0] = kEdgeColumns;
  edges.push_constants[1] = rows;
  edges.cost *= 8.0;
  plan.add_pass(std::move(edges));
}

}  // namespace airlight
