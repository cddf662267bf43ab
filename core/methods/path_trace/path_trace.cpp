// `path-trace`: an unbiased estimate of every order of scattering on the processor, with its standard error. It shares
// with the shaders only the medium and the phase functions: no march, no segment integral, no table.

#include <algorithm>
#include <array>

#include "core/air/scene_block.h"
#include "core/methods/methods.h"
#include "core/methods/path_trace/sampling.h"
#include "core/methods/path_trace/tracer.h"
#include "core/scene/parameters.h"

namespace airlight {
namespace {

using physics::vec3;

using parameter::kMostInt;
using parameter::kNoLimit;
constexpr int kUsualSamples = 64;

const std::array<ParameterInfo, 5> kParameters{
    parameter::whole_number(
        "samples", 0, kMostInt, 0,
        "samples a pixel, in batches of 16, at least 32; 0: 64, or as many as time_limit_s and target_error ask for"),
    parameter::number("time_limit_s", 0.0,
                      "stop after so many seconds, but not before the first 32 samples of each pixel; 0: no limit"),
    parameter::number("target_error", 0.0,
                      "stop when the mean over pixels of standard error / radiance is this small (0.005 is half a "
                      "percent); 0: no target"),
    parameter::whole_number("seed", 0, kMostInt, 1,
                            "of the random numbers: one seed gives one picture, whatever the number of threads"),
    parameter::whole_number(
        "max_orders", 0, kMostInt, 0,
        "scatterings and ground reflections on a path, at most; 1: single scattering, without noise; 0: 5000")};

StopRules rules_of(const RenderSettings& settings) {
  StopRules rules;
  rules.time_limit_s = settings.get<double>("time_limit_s");
  rules.target_error = settings.get<double>("target_error");
  int samples = settings.get<int>("samples");
  if (samples == 0 && rules.time_limit_s == 0.0 && rules.target_error == 0.0) {
    samples = kUsualSamples;
  }
  const auto batches = (static_cast<std::uint64_t>(samples) + kBatch - 1) / kBatch;
  rules.batches = samples == 0 ? 0 : std::max<std::uint64_t>(batches, 2);
  return rules;
}

RadianceImage blank(int width, int height) {
  return {width, height, std::vector<float>(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
}

void set_pixel(RadianceImage& image, std::size_t k, vec3 value) {
  image.rgba[4 * k + 0] = static_cast<float>(value.x);
  image.rgba[4 * k + 1] = static_cast<float>(value.y);
  image.rgba[4 * k + 2] = static_cast<float>(value.z);
  image.rgba[4 * k + 3] = 1.0f;
}

// The rays to sample; `ids` are places in the picture.
struct Targets {
  int width = 0;
  int height = 1;
  std::vector<Pixel> pixels;
  std::vector<std::uint64_t> ids;

  void add(std::uint64_t id, std::vector<SampledRay> rays) {
    pixels.push_back({.rays = std::move(rays)});
    ids.push_back(id);
  }
};

Targets targets_of(const PathTracer& tracer, const Scene& scene, const View& view) {
  Targets targets;
  if (!view.directions.empty()) {
    targets.width = static_cast<int>(view.directions.size());
    for (std::uint64_t id = 0; id < view.directions.size(); ++id) {
      targets.add(id, {{tracer.direction(view.directions[id].elevation, view.directions[id].azimuth)}});
    }
    return targets;
  }
  targets.width = scene.image.width;
  targets.height = scene.image.height;
  std::uint64_t id = 0;
  for (int y = 0; y < scene.image.height; ++y) {
    for (int x = 0; x < scene.image.width; ++x, ++id) {
      std::vector<SampledRay> rays = tracer.pixel_rays(x, y);
      if (!rays.empty()) {
        targets.add(id, std::move(rays));
      }
    }
  }
  return targets;
}

// `all`, `identity`: as for PathTracer and Sampling.
HostPicture trace(const Part& part, const Wavelengths* all, const View& view, const HostOptions& options,
                  const std::string& identity) {
  const Scene& scene = part.scene;
  const RenderSettings& settings = scene.render;
  const PathTracer tracer(part, all, static_cast<std::uint64_t>(settings.get<int>("seed")),
                          settings.get<int>("max_orders"), view.wall.value_or(kNoLimit));
  Targets targets = targets_of(tracer, scene, view);
  HostPicture picture;
  picture.radiance = blank(targets.width, targets.height);
  picture.standard_error = blank(targets.width, targets.height);
  if (!view.directions.empty()) {
    picture.transmittance = blank(targets.width, targets.height);
    for (std::size_t k = 0; k < targets.pixels.size(); ++k) {
      set_pixel(picture.transmittance, k, tracer.transmittance(tracer.start(targets.pixels[k].rays.front().direction)));
    }
  }
  Sampling sampling(tracer, rules_of(settings), options, std::move(targets.pixels), targets.ids, identity);
  sampling.run();
  const vec3 irradiance = vector_of(scene.sun.irradiance) * (scene.sun.uncovered * light_passed(scene.camera));
  for (std::size_t k = 0; k < targets.ids.size(); ++k) {
    set_pixel(picture.radiance, targets.ids[k], sampling.radiance(k) * irradiance);
    set_pixel(picture.standard_error, targets.ids[k], sampling.standard_error(k) * irradiance);
  }
  picture.samples = sampling.fewest_batches() * kBatch;
  if (const std::string overrun = sampling.overrun(); !overrun.empty()) {
    picture.notes.push_back(overrun);
  }
  if (tracer.cut_paths() > 0) {
    picture.notes.push_back(std::to_string(tracer.cut_paths()) + " paths were ended after " +
                            std::to_string(Walk::kMostScatterings) +
                            " scatterings: the light that they would have brought is missing");
  }
  if (tracer.cut_rays() > 0) {
    picture.notes.push_back("light scattered once was not found to 1e-6 along " + std::to_string(tracer.cut_rays()) +
                            " rays, which cross more edges than there was time for");
  }
  return picture;
}

HostPicture render(const Stage& stage, const View& view, const HostOptions& options) {
  const std::string identity = checkpoint_identity(stage, view);
  if (!stage.in_colours()) {
    return trace(stage.whole(), nullptr, view, options, identity);
  }
  const Wavelengths all(stage);
  return trace(all.steering(), &all, view, options, identity);
}

Quality with_samples(std::string_view label, int samples) {
  return {label, {{"samples", samples}}};
}

}  // namespace

SkyMethod path_trace_method() {
  SkyMethod method;
  method.info = {"path-trace", "unbiased Monte Carlo of all orders on the processor, with standard error", kParameters};
  method.info.knows_terrain = true;
  method.info.knows_bodies = true;
  method.info.knows_ground_maps = true;
  method.info.knows_polarisers = true;
  method.info.knows_clouds = true;
  method.info.bends_light = true;
  method.validity.leaves_out =
      "polarisation by other media than molecules, the sun's disc in the picture, sunlight that mirrors throw into the "
      "air, and among clouds on things";
  method.sweep = {with_samples("32", 32), with_samples("128", 128), with_samples("512", 512)};
  method.render_on_host = render;
  return method;
}

}  // namespace airlight
