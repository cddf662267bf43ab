#include "tests/choice/honesty.h"

#include <map>

#include "core/chart/pixels.h"
#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/scene/random_preset.h"

namespace airlight::test {
namespace {

constexpr std::uint64_t kSameKinds = 8;
constexpr int kColumns = 96;  // by 32 x 24 a row of pixels at the horizon could be a tenth of a picture
constexpr int kRows = 72;

Scene random_scene(std::uint64_t seed) {
  const RandomPresetOptions options{.largest_side = 200, .method_keys = false};
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

std::vector<Honesty> judge_honesty(Executor& executor, const Scene& scene, const std::vector<double>& tolerances,
                                   double* of_reference) {
  std::map<std::string, std::vector<float>> known;
  const auto device = [&]() -> Executor& { return executor; };
  const choice::ProbeFunction probe = [&](const Scene& candidate, const choice::Probes& probes) {
    std::vector<float>& values = known[to_json(candidate)];
    if (values.empty()) {
      values = probe_picture(device, candidate, probes.directions);
    }
    return values;
  };
  const choice::Candidate fine = choice::reference(scene, true);
  if (of_reference != nullptr) {
    const choice::Probes probes = choice::choose_probes(scene, 256);
    *of_reference = probes.directions.empty()
                        ? 0.0
                        : measure::sample_error(probe(choice::reference(scene, false).scene, probes),
                                                probe(fine.scene, probes), probes.weights)
                              .mean;
  }
  const chart::PixelSet pixels = chart::lattice(scene, kColumns, kRows);
  const std::vector<float> truth = probe_picture(device, fine.scene, pixels.directions);
  std::vector<Honesty> results;
  for (const double tolerance : tolerances) {
    const choice::Choice choice = choice::choose_for_tolerance(scene, tolerance, "", probe);
    Honesty result;
    result.tolerance = tolerance;
    result.refused = !choice.chosen;
    if (choice.chosen) {
      result.method = choice.chosen->method;
      result.quality = choice.chosen->quality;
      result.estimated = choice.error;
      result.measured =
          measure::sample_error(lattice_values(executor, choice.chosen->scene, kColumns, kRows), truth, {}, choice.dark)
              .mean;
    } else if (choice.best) {
      result.estimated = choice.best->error;
    }
    result.known = choice.reference_error;
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace airlight::test
