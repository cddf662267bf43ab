#include "core/render/layers.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <set>

#include "core/methods/method.h"
#include "core/methods/scene_air.h"
#include "core/methods/spectral_sums.h"
#include "core/plan/bytes.h"
#include "core/render/picture_key.h"
#include "core/render/sky.h"
#include "core/render/timings.h"
#include "core/scene/photometry.h"
#include "core/text.h"

namespace airlight {
namespace {

using physics::vec3;

// Names of the layers that no medium gives its name to, and of the EXR's other channels.
const std::set<std::string>& taken_names() {
  static const std::set<std::string> names{"multiple", "sun", "ground", "transmittance", "depth",         "N", "R",
                                           "G",        "B",   "A",      "bloom",         "standard_error"};
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

std::size_t pixels_of(const Tile& tile) {
  return static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
}

Layer& find(std::vector<Layer>& layers, std::string_view name) {
  const auto found = std::ranges::find_if(layers, [&](const Layer& layer) { return layer.name == name; });
  assert(found != layers.end());
  return *found;
}

std::vector<float> floats(std::span<const std::byte> bytes, std::size_t first, std::size_t count) {
  return values_of<float>(bytes.subspan(first * sizeof(float), count * sizeof(float)));
}

// Reads the device's planes, which are in the order of layers_of() without the sun.
void take_planes(std::vector<Layer>& layers, std::span<const std::byte> bytes, std::size_t pixels) {
  std::size_t first = 0;
  for (Layer& layer : layers) {
    if ((layer.is_light && layer.name != "sun") || layer.name == "transmittance") {
      layer.planes = floats(bytes, first, 3 * pixels);
      first += 3 * pixels;
    }
  }
  assert(first * sizeof(float) == bytes.size());
}

void take_disc(Layer& sun, std::span<const std::byte> bytes, std::size_t pixels) {
  sun.planes.assign(3 * pixels, 0.0F);
  if (bytes.empty()) {
    return;
  }
  const std::vector<float> rgba = floats(bytes, 0, 4 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      sun.planes[c * pixels + i] = rgba[4 * i + c];
    }
  }
}

// Depth and normals in double, from the geometry alone.
void add_geometry(std::vector<Layer>& layers, const Scene& scene, const Tile& tile) {
  physics::Physics p = geometry_of(scene);
  const std::size_t pixels = pixels_of(tile);
  std::vector<float>& depth = find(layers, "depth").planes;
  std::vector<float>& normal = find(layers, "N").planes;
  depth.assign(pixels, 0.0F);
  normal.assign(3 * pixels, 0.0F);
  const physics::PlanetData planet = p.scene.planet;
  const double h = scene.camera.altitude;
  const physics::uint projection = projection_code(scene.camera.projection);
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto width = static_cast<std::size_t>(tile.width);
    const auto ray = p.view_ray(p.scene.camera, projection, tile.x + 0.5 + static_cast<double>(i % width),
                                tile.y + 0.5 + static_cast<double>(i / width));
    if (!ray.inside) {
      continue;
    }
    const double distance = p.distance_to_end(planet, h, ray.direction.y);
    depth[i] = distance < 0.0 ? kNoDistance : static_cast<float>(distance);
    if (p.meets_ground(planet, h, ray.direction.y)) {
      const vec3 up = physics::normalize(ray.direction * distance + vec3(0.0, planet.ground_radius + h, 0.0));
      normal[i] = static_cast<float>(up.x);
      normal[pixels + i] = static_cast<float>(up.y);
      normal[2 * pixels + i] = static_cast<float>(up.z);
    }
  }
}

// Number of rows in a band whose device buffers take at most kLayerBandBytes.
int band_rows(const Scene& scene) {
  const std::size_t layers = static_cast<std::size_t>(std::popcount(scattering_media_of(scene))) + 3;
  const std::size_t row = (3 * layers + 4) * sizeof(float) * static_cast<std::size_t>(scene.image.width);
  return static_cast<int>(
      std::clamp<std::size_t>(kLayerBandBytes / row, 1, static_cast<std::size_t>(scene.image.height)));
}

void put_band(Layer& whole, const Layer& band, const Tile& tile, int height) {
  const std::size_t plane = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(height);
  const std::size_t first = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.y);
  const std::size_t pixels = pixels_of(tile);
  whole.planes.resize(whole.channels.size() * plane);
  for (std::size_t c = 0; c < whole.channels.size(); ++c) {
    const float* from = band.planes.data() + c * pixels;
    std::copy(from, from + pixels, whole.planes.data() + c * plane + first);
  }
}

LayerPasses add_layer_passes(Plan& plan, const Scene& scene, const Tile& tile, const std::string& kept_as) {
  assert(method_of(scene).add_layer_passes != nullptr);
  return method_of(scene).add_layer_passes(plan, scene, air_of(scene),
                                           {.directions = {}, .tile = tile, .kept_as = kept_as});
}

BufferId add_dark(Plan& plan, std::size_t pixels) {
  return plan.add_buffer({.name = "disc", .bytes = 4 * pixels * sizeof(float), .host_readable = true});
}

void render_channels(std::vector<Layer>& layers, Executor& executor, const Scene& scene, const Tile& tile,
                     const std::string& kept_as, const Timings& timings) {
  const Air air = air_of(scene);
  Plan plan;
  plan.scene_data = device_scene_bytes(air, scene, tile);
  const LayerPasses passes = add_layer_passes(plan, scene, tile, kept_as);
  const std::size_t pixels = pixels_of(tile);
  const BufferId disc = add_dark(plan, pixels);
  const bool shines = add_sun_disc(plan, scene, air, passes.transmittance, picture_of(disc, tile));
  const RunResult result = executor.run(plan);
  timings.add(result);
  take_planes(layers, result.contents(passes.planes), pixels);
  take_disc(find(layers, "sun"), shines ? result.contents(disc) : std::span<const std::byte>(), pixels);
}

// Adds three channels as colours to a layer.
void add_channels(Layer& layer, std::span<const float> channels, const std::array<Rgb, 3>& colours,
                  std::size_t pixels) {
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = static_cast<double>(layer.planes[c * pixels + i]);
      for (std::size_t k = 0; k < 3; ++k) {
        sum += colours[k][c] * static_cast<double>(channels[k * pixels + i]);
      }
      layer.planes[c * pixels + i] = static_cast<float>(sum);
    }
  }
}

// The layers of one group of wavelengths at a time, and their sum over the groups on the host, which needs them anyway.
void render_in_colours(std::vector<Layer>& layers, Executor& executor, const Scene& scene, const Tile& tile,
                       const std::string& kept_as, const Timings& timings) {
  const SpectralScene spectral = spectral_scene(scene);
  const std::uint32_t all = scattering_media(spectral);
  const std::size_t pixels = pixels_of(tile);
  const std::size_t lights = static_cast<std::size_t>(std::popcount(all)) + 3;  // in the order of layers_of()
  for (std::size_t i = 0; i < lights; ++i) {
    layers[i].planes.assign(3 * pixels, 0.0F);
  }
  for (std::size_t g = 0; g < spectral.groups.size(); ++g) {
    const WavelengthGroup& group = spectral.groups[g];
    Plan plan;
    begin_group(plan, spectral, g, tile);
    const LayerPasses passes = add_layer_passes(plan, group.scene, tile, kept_as);
    plan.end_scene();
    const RunResult result = executor.run(plan);
    timings.add(result);
    const std::span<const std::byte> bytes = result.contents(passes.planes);
    const std::uint32_t own = air_of(group.scene).scattering_media();
    std::size_t plane = 0;
    std::uint32_t medium = 0;
    for (std::size_t i = 0; i < lights; ++i, ++medium) {
      while (i + 3 < lights && (all >> medium & 1u) == 0) {
        ++medium;
      }
      if (i + 3 < lights && (own >> medium & 1u) == 0) {
        continue;
      }
      const bool is_share = layers[i].name == "transmittance";
      add_channels(layers[i], floats(bytes, plane, 3 * pixels),
                   is_share ? over_the_sun(group.colours, spectral.sun) : group.colours, pixels);
      plane += 3 * pixels;
    }
  }
  Plan plan;
  plan.scene_data = device_scene_bytes(air_of(scene), scene, tile);
  const BufferId disc = add_dark(plan, pixels);
  const bool shines = add_disc_over(plan, scene, disc, tile);
  const RunResult result = shines ? executor.run(plan) : RunResult{};
  timings.add(result);
  take_disc(find(layers, "sun"), shines ? result.contents(disc) : std::span<const std::byte>(), pixels);
}

}  // namespace

std::uint32_t scattering_media_of(const Scene& scene) {
  return scene.spectra ? scattering_media(spectral_scene(scene)) : air_of(scene).scattering_media();
}

std::vector<Layer> layers_of(const Scene& scene) {
  std::vector<Layer> layers;
  const std::uint32_t scattering = scattering_media_of(scene);
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
  layers.push_back({"sun", "RGB", true});
  layers.push_back({"depth", "Z"});
  layers.push_back({"N", "XYZ"});
  return layers;
}

std::string layers_refusal(const Scene& scene) {
  const auto refusal = method_of(scene).layers_refusal;
  return refusal == nullptr ? std::string() : refusal(scene);
}

Scene kept_apart(Scene scene) {
  if (const auto keep_apart = method_of(scene).keep_apart; keep_apart != nullptr) {
    keep_apart(scene.render);
  }
  return scene;
}

std::string methods_with_layers() {
  return joined_of(methods(), [](const SkyMethod& method) {
    return method.add_layer_passes != nullptr ? method.info.name : std::string_view();
  });
}

std::vector<Layer> render_layers(Executor& executor, const Scene& scene, const Tile& tile, const std::string& kept_as,
                                 const Timings& timings) {
  std::vector<Layer> layers = layers_of(scene);
  if (scene.spectra) {
    render_in_colours(layers, executor, scene, tile, kept_as, timings);
  } else {
    render_channels(layers, executor, scene, tile, kept_as, timings);
  }
  add_geometry(layers, scene, tile);
  return layers;
}

std::vector<Layer> render_layers(Executor& executor, const Scene& scene, const Timings& timings) {
  std::vector<Layer> layers = layers_of(scene);
  const std::string key = picture_key();
  const int rows = band_rows(scene);
  for (int y = 0; y < scene.image.height; y += rows) {
    const Tile tile{0, y, scene.image.width, std::min(rows, scene.image.height - y)};
    const std::vector<Layer> band = render_layers(executor, scene, tile, key, timings);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      put_band(layers[i], band[i], tile, scene.image.height);
    }
  }
  return layers;
}

Statistics layer_statistics(const Layer& layer, int width, bool signed_colours) {
  Statistics found;
  const bool is_signed = layer.name == "N";
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
    if (finite && (!(value < 0.0) || is_signed)) {
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
