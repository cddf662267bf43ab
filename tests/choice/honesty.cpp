#include "tests/choice/honesty.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "core/chart/pixels.h"
#include "core/chart/truth.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/choice/of_scene.h"
#include "tests/scene/random_preset.h"

namespace airlight::test {
namespace {

constexpr std::uint64_t kSameKinds = 8;
constexpr int kColumns = 96;  // by 32 x 24 a row of pixels at the horizon could be a tenth of a picture
constexpr int kRows = 72;

Scene random_scene(std::uint64_t seed) {
  const RandomPresetOptions options{.largest_side = 200, .method_keys = false, .bends_light = true};
  return resolve(parse_preset(random_preset(seed, options), "random " + std::to_string(seed), {}), method_infos());
}

}  // namespace

Scene honesty_scene(std::uint64_t seed) {
  Scene scene = random_scene(seed);
  const std::vector<Medium> own = scene.media;
  scene.media = random_scene(seed - seed % kSameKinds).media;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const Medium& from = own[i % own.size()];
    scene.media[i].scattering = from.scattering;
    scene.media[i].absorption = from.absorption;
    scene.media[i].phase_g = from.phase_g;
  }
  return scene;
}

std::vector<float> lattice_values(Executor& executor, const Scene& scene, int columns, int rows) {
  Scene picture = scene;
  picture.sun.disc.visible = false;
  const Rendering rendering = render([&]() -> Executor& { return executor; }, picture, {});
  return chart::values_at(rendering.radiance.rgba, chart::lattice(scene, columns, rows));
}

std::vector<float> picture_values(Executor& executor, const Scene& scene, const choice::Probes& probes) {
  return probe_picture([&]() -> Executor& { return executor; }, scene, probes.directions);
}

Traced trace(const Scene& scene, const std::filesystem::path& folder) {
  constexpr std::size_t kTracedPixels = 200;                        // not those that a choice looks at
  const char* seconds = std::getenv("AIRLIGHT_TOLERANCE_SECONDS");  // of tracing, each scene
  const chart::TruthRules rules{.target_error = 0.005, .time_limit_s = seconds == nullptr ? 5.0 : std::atof(seconds)};
  Traced traced;
  traced.probes = choice::choose_probes(scene, kTracedPixels);
  chart::PixelSet pixels;
  pixels.directions = traced.probes.directions;
  pixels.places.resize(pixels.directions.size());
  if (pixels.directions.empty()) {
    return traced;
  }
  const chart::Truth truth = chart::find_truth(ready(scene), pixels, folder, rules, {});
  traced.radiance = truth.radiance;
  traced.noise = measure::sample_noise(truth.radiance, truth.standard_error, traced.probes.weights);
  return traced;
}

double error_against(const Traced& truth, const std::vector<float>& radiance, double dark) {
  const double error = measure::sample_error(radiance, truth.radiance, truth.probes.weights, dark).mean;
  const double noise = measure::kMeanOfNormal * truth.noise;
  return std::sqrt(std::max(error * error - noise * noise, 0.0));
}

std::vector<Honesty> judge_honesty(Executor& executor, const Scene& scene, const std::vector<double>& tolerances,
                                   double* of_reference, const Traced* traced) {
  std::map<std::pair<std::string, std::size_t>, std::vector<float>> known;  // by scene and count of probes
  const auto device = [&]() -> Executor& { return executor; };
  const auto probe = [&](const Stage& candidate, const choice::Probes& probes) {
    std::vector<float>& values = known[{to_json(candidate.scene()), probes.directions.size()}];
    if (values.empty()) {
      values = probe_picture(device, candidate, probes.directions);
    }
    return values;
  };
  const choice::Looks looks{probe,
                            [](const Stage& whole, const choice::Probes& probes, const choice::TraceOrder& order) {
                              return choice::trace_probes(whole, probes, order);
                            }};
  const choice::Candidate fine = choice::reference(scene, true);
  if (of_reference != nullptr) {
    const choice::Probes probes = choice::choose_probes(scene, 256);
    *of_reference = probes.directions.empty()
                        ? 0.0
                        : measure::sample_error(probe(choice::reference(scene, false).stage, probes),
                                                probe(fine.stage, probes), probes.weights)
                              .mean;
  }
  const chart::PixelSet pixels = chart::lattice(scene, kColumns, kRows);
  const std::vector<float> truth =
      traced != nullptr ? std::vector<float>() : probe_picture(device, fine.stage, pixels.directions);
  const auto error_of = [&](const Scene& chosen, double dark) {
    if (traced != nullptr) {
      return error_against(*traced, picture_values(executor, chosen, traced->probes),
                           std::max(dark, choice::dark_radiance(scene, traced->radiance)));
    }
    return measure::sample_error(lattice_values(executor, chosen, kColumns, kRows), truth, {}, dark).mean;
  };
  std::vector<Honesty> results;
  for (const double tolerance : tolerances) {
    const choice::Choice choice = choice::choose_for_tolerance(scene, tolerance, "", looks);
    Honesty result;
    result.tolerance = tolerance;
    result.refused = !choice.chosen;
    if (choice.chosen) {
      result.method = choice.chosen->method;
      result.quality = choice.chosen->quality;
      result.estimated = choice.error;
      result.measured = error_of(choice.chosen->stage.scene(), choice.dark);
    } else {
      result.estimated = choice.best ? choice.best->error : 0.0;
      result.measured = error_of(choice::default_candidate(scene).stage.scene(), choice.dark);
    }
    result.noise = traced != nullptr ? measure::kMeanOfNormal * traced->noise : 0.0;
    result.known = choice.reference_error;
    result.sees_light = traced == nullptr || std::ranges::any_of(traced->radiance, [](float x) { return x > 0.0F; });
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace airlight::test
