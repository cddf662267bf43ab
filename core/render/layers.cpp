#include "core/render/layers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "core/air/refraction.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/spectral_sums.h"
#include "core/plan/bytes.h"
#include "core/render/pixels.h"
#include "core/render/sky.h"
#include "core/render/timings.h"
#include "core/scene/photometry.h"
#include "core/stage/sums.h"

namespace airlight {
namespace {

using physics::vec3;

// Names of the layers that no medium gives its name to, and of the EXR's other channels.
const std::set<std::string>& taken_names() {
  static const std::set<std::string> names{
      "multiple", "sun", "moon", "night_sky", "ground", "transmittance",  "depth", "N",           "Q",          "U",
      "R",        "G",   "B",    "A",         "bloom",  "standard_error", "cloud", "cloud_alpha", "cloud_depth"};
  return names;
}

constexpr std::size_t kLongestName = 200;  // a channel's is at most 255 bytes

// A dot would begin a channel's name. Characters that some program takes for an operator or a space become underscores.
std::string channel_name(const std::string& medium, std::size_t index) {
  std::string name = medium.substr(0, kLongestName);
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    c = plain ? c : '_';
  }
  return name.empty() ? "medium" + std::to_string(index + 1) : name;
}

std::string unlike(const std::set<std::string>& taken, const std::string& name) {
  std::string other = name;
  for (int i = 2; taken.contains(other); ++i) {
    other = name + "_" + std::to_string(i);
  }
  return other;
}

Layer& find(std::vector<Layer>& layers, std::string_view name) {
  const auto found = std::ranges::find_if(layers, [&](const Layer& layer) { return layer.name == name; });
  assert(found != layers.end());
  return *found;
}

std::vector<float> floats(std::span<const std::byte> bytes, std::size_t first, std::size_t count) {
  return values_of<float>(bytes.subspan(first * sizeof(float), count * sizeof(float)));
}

// Depth and normals in double, from the geometry alone.
void add_geometry(std::vector<Layer>& layers, const Scene& scene, const Things& things, const Tile& tile) {
  physics::Physics p = geometry_of(scene);
  things.put_into(p);
  const std::size_t pixels = pixels_of(tile);
  std::vector<float>& depth = find(layers, "depth").planes;
  std::vector<float>& normal = find(layers, "N").planes;
  const physics::PlanetData planet = p.scene.planet;
  const double h = p.scene.camera.altitude;
  const physics::uint projection = projection_code(scene.camera.projection);
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto width = static_cast<std::size_t>(tile.width);
    const auto ray = p.view_ray(p.scene.camera, projection, tile.x + 0.5 + static_cast<double>(i % width),
                                tile.y + 0.5 + static_cast<double>(i / width));
    if (!ray.inside) {
      continue;
    }
    const auto sight = p.sight_of(ray.direction);
    const auto hit = p.nearest_thing(planet, sight, physics::kNoBody);
    const double distance = hit.what == p.kMeetsSky ? p.distance_to_end(planet, h, ray.direction.y) : hit.distance_;
    const double length = p.hits_thing(hit) ? distance : true_length(p, ray.direction.y, distance);
    depth[i] = distance < 0.0 ? kNoDistance : static_cast<float>(length);
    if (hit.what != p.kMeetsSky) {
      const vec3 n = p.surface_at(planet, h, sight, hit, 0.0).normal;
      normal[i] = static_cast<float>(n.x);
      normal[pixels + i] = static_cast<float>(n.y);
      normal[2 * pixels + i] = static_cast<float>(n.z);
    }
  }
}

// Adds three channels as colours to a layer: channel k of pixel i stands at k plane + i step.
void add_channels(Layer& layer, std::span<const float> channels, std::size_t plane, std::size_t step,
                  const std::array<Rgb, 3>& colours) {
  const std::size_t pixels = layer.planes.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto channel = [&](std::size_t k) { return double{channels[k * plane + i * step]}; };
    for (std::size_t c = 0; c < 3; ++c) {
      float& sum = layer.planes[c * pixels + i];
      sum = static_cast<float>(add_colour(double{sum}, colours, c, channel(0), channel(1), channel(2)));
    }
  }
}

// Adds the device's planes of a part: those of layers_of() up to transmittance or U, without the media that do not
// scatter in this part. `media`: those that scatter in any; `lets_through`: whether the transmittance counts.
void add_planes(std::vector<Layer>& layers, std::span<const std::byte> bytes, const Part& part, std::uint32_t media,
                bool stokes, std::size_t pixels, bool lets_through) {
  std::size_t layer = 0;
  std::size_t plane = 0;
  const auto add = [&](bool is_there, const std::array<Rgb, 3>& colours) {
    if (is_there) {
      add_channels(layers[layer], floats(bytes, plane, 3 * pixels), pixels, 1, colours);
      plane += 3 * pixels;
    }
    ++layer;
  };
  for (std::uint32_t medium = 0; media >> medium != 0; ++medium) {
    if ((media >> medium & 1u) != 0) {
      add((part.air.scattering_media() >> medium & 1u) != 0, part.colours);
    }
  }
  add(true, part.colours);  // multiple
  add(true, part.colours);  // ground
  if (lets_through) {
    add(true, part.shares);  // transmittance
  } else {
    ++layer;
    plane += 3 * pixels;
  }
  add(stokes, part.colours);  // Q
  add(stokes, part.colours);  // U
  if (!part.scene.clouds.empty()) {
    add_channels(find(layers, "cloud"), floats(bytes, plane, 3 * pixels), pixels, 1, part.colours);
    plane += kCloudPlanes * pixels;
  }
  assert(plane * sizeof(float) == bytes.size());
}

// Alpha and depth of the clouds, which drops make alike at all wavelengths: of the first part.
void put_cloud_shape(std::vector<Layer>& layers, std::span<const std::byte> bytes, std::size_t pixels) {
  const std::size_t planes = bytes.size() / sizeof(float) / pixels;
  std::vector<float>& alpha = find(layers, "cloud_alpha").planes;
  std::vector<float>& depth = find(layers, "cloud_depth").planes;
  alpha = floats(bytes, (planes - 2) * pixels, pixels);
  depth = floats(bytes, (planes - 1) * pixels, pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    depth[i] = alpha[i] > 0.0F ? depth[i] / alpha[i] : kNoDistance;
  }
}

// One part's share of all layers. Returns what clouds leave of a beam along each pixel's ray; empty: there are none.
std::vector<float> render_part(std::vector<Layer>& layers, Executor& executor, const Stage& stage, const Part& part,
                               const View& view, const Timings& timings) {
  const std::size_t pixels = pixels_of(*view.tile);
  const bool is_sun = stage.light().empty();
  Plan plan;
  begin_part(plan, part, *view.tile);
  const LayerPasses passes = stage.method().add_layer_passes(plan, part, view);
  const BufferId disc = plan.add_buffer({.name = "disc", .bytes = 4 * pixels * sizeof(float), .host_readable = true});
  const std::optional<BufferId> past_clouds = cloud_transmittance(plan, 0);
  const BufferId bare =
      past_clouds ? plan.add_buffer({.name = "bare_disc", .bytes = 4 * pixels * sizeof(float)}) : disc;
  const bool shines = add_sun_disc(plan, part, passes.transmittance, picture_of(bare, *view.tile));
  if (shines && past_clouds) {
    add_behind_clouds(plan, bare, *past_clouds, picture_of(disc, *view.tile));
  }
  plan.end_scene();
  const RunResult result = executor.run(plan);
  timings.add(result);
  add_planes(layers, result.contents(passes.planes), part, stage.scattering_media(), view.stokes, pixels, is_sun);
  if (shines) {
    add_channels(find(layers, is_sun ? "sun" : "moon"), floats(result.contents(disc), 0, 4 * pixels), 1, 4,
                 part.colours);
  }
  if (!past_clouds) {
    return {};
  }
  if (is_sun && &part == &stage.parts().front()) {
    put_cloud_shape(layers, result.contents(passes.planes), pixels);
  }
  return floats(result.contents(*past_clouds), 0, pixels);
}

// The night sky's layer, behind clouds (render_part()).
void render_night(Layer& layer, Executor& executor, const Stage& stage, const Tile& tile,
                  const std::vector<float>& past_clouds, const Timings& timings) {
  Plan plan;
  const BufferId night = add_night_picture(plan, stage, tile);
  const RunResult result = executor.run(plan);
  timings.add(result);
  const std::size_t pixels = pixels_of(tile);
  add_channels(layer, floats(result.contents(night), 0, 4 * pixels), 1, 4, kAsTheyAre);
  for (std::size_t i = 0; i < layer.planes.size() && !past_clouds.empty(); ++i) {
    layer.planes[i] *= past_clouds[i % pixels];
  }
}

}  // namespace

std::vector<Layer> layers_of(const Stage& stage, LayerSet set) {
  const Scene& scene = stage.scene();
  std::vector<Layer> layers;
  const std::uint32_t scattering = stage.scattering_media();
  std::set<std::string> taken = taken_names();
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    if ((scattering >> i & 1u) != 0) {
      layers.push_back({unlike(taken, channel_name(scene.media[i].name, i)), "RGB", true});
      taken.insert(layers.back().name);
    }
  }
  layers.push_back({"multiple", "RGB", true});
  layers.push_back({"ground", "RGB", true});
  layers.push_back({"transmittance", "RGB"});
  if (set == LayerSet::stokes) {
    layers.push_back({.name = "Q", .channels = "RGB", .is_signed = true});
    layers.push_back({.name = "U", .channels = "RGB", .is_signed = true});
  }
  if (!scene.clouds.empty()) {
    layers.push_back({"cloud", "RGB", true});
    layers.push_back({"cloud_alpha", "A"});
    layers.push_back({"cloud_depth", "Z"});
  }
  layers.push_back({"sun", "RGB", true});
  if (scene.moon) {
    layers.push_back({"moon", "RGB", true});
  }
  if (scene.night_sky || scene.stars) {
    layers.push_back({"night_sky", "RGB", true});
  }
  layers.push_back({"depth", "Z"});
  layers.push_back({.name = "N", .channels = "XYZ", .is_signed = true});
  return layers;
}

std::string methods_with_layers() {
  return joined_of(methods(), [](const SkyMethod& method) {
    return method.add_layer_passes != nullptr ? method.info.name : std::string_view();
  });
}

std::vector<Layer> render_layers(Executor& executor, const Stage& stage, LayerSet set, const Tile& tile,
                                 const std::string& kept_as, const Timings& timings) {
  std::vector<Layer> layers = layers_of(stage, set);
  const View view{.directions = {}, .tile = tile, .stokes = set == LayerSet::stokes, .kept_as = kept_as};
  for (Layer& layer : layers) {
    layer.planes.assign(layer.channels.size() * pixels_of(tile), 0.0F);
  }
  std::vector<float> past_clouds;
  const auto render_light = [&](const Stage& lit) {
    const std::string kept = kept_as.empty() ? "" : kept_as + lit.light();
    for (const Part& part : lit.parts()) {
      View of_light = view;
      of_light.kept_as = kept;
      past_clouds = render_part(layers, executor, lit, part, of_light, timings);
    }
  };
  render_light(stage);
  std::ranges::for_each(stage.others(), render_light);
  if (stage.night() != nullptr) {
    render_night(find(layers, "night_sky"), executor, stage, tile, past_clouds, timings);
  }
  add_geometry(layers, stage.scene(), stage.whole().things, tile);
  return layers;
}

Statistics layer_statistics(const Layer& layer, int width, bool signed_colours) {
  Statistics found;
  const std::size_t pixels = layer.planes.size() / layer.channels.size();
  const bool in_colours = signed_colours && layer.channels == "RGB";
  for (std::size_t i = 0; i < layer.planes.size(); ++i) {
    const std::size_t at = i % pixels;
    const bool finite = std::isfinite(layer.planes[i]);
    // The first channel of a colour counts for all three.
    const auto plane = [&](std::size_t c) { return static_cast<double>(layer.planes[c * pixels + at]); };
    const double value = !in_colours  ? static_cast<double>(layer.planes[i])
                         : i < pixels ? bt709_luminance({plane(0), plane(1), plane(2)})
                                      : 0.0;
    if (finite && (!(value < 0.0) || layer.is_signed)) {
      continue;
    }
    if (found.sound()) {
      found.first_bad_x = static_cast<std::uint32_t>(at % static_cast<std::size_t>(width));
      found.first_bad_y = static_cast<std::uint32_t>(at / static_cast<std::size_t>(width));
    }
    ++(finite ? found.negative : found.not_finite);
  }
  return found;
}

}  // namespace airlight
