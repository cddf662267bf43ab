#include "core/choice/candidates.h"

#include <algorithm>
#include <set>

#include "core/choice/leave_out.h"
#include "core/luts/moments.h"
#include "core/methods/scene_air.h"

namespace airlight::choice {
namespace {

constexpr std::string_view kScale = "multiple_scattering_scale";

// Its passes and tables; without the scene block it is not to be run.
Plan plan_of(const Scene& scene) {
  Plan plan;
  find_method(scene.render.method)->add_passes(plan, scene, air_of(scene), View{});
  return plan;
}

bool claims(const Validity& validity, const Scene& scene, double optical_depth) {
  return scene.sun.elevation >= validity.sun_elevation_min && scene.camera.altitude <= validity.altitude_max &&
         optical_depth <= validity.optical_depth_max;
}

std::string words(int pixels) {
  return "the picture's " + std::to_string(pixels) + " pixels are too few to pay for it";
}

// What the picture does without by this choice.
std::vector<std::string> left_out(const Scene& scene, const Plan& plan) {
  std::vector<std::string> lines;
  if (scene.render.parameters.contains(kScale) && scene.render.get<double>(kScale) == 0.0) {
    lines.push_back("multiple scattering: the air is so thin that it adds less than the tolerance");
  }
  if (scene.render.method == "nested") {
    lines.push_back("multiple scattering: it adds less than the tolerance");
  }
  const bool tables = std::ranges::any_of(plan.images(), [](const ImageDesc& image) { return !image.key.empty(); });
  const int pixels = scene.image.width * scene.image.height;
  if (!tables) {
    lines.push_back("tables kept from picture to picture: the method needs none");
  }
  const bool factors =
      std::ranges::any_of(plan.images(), [](const ImageDesc& image) { return image.name == "sky_factors"; });
  if (scene.render.method == "orders" && !factors && scene.camera.altitude <= scene.planet.atmosphere_height &&
      scene.render.get<std::string>("tabulate") == "auto") {
    lines.push_back("table of the picture's light: " + words(pixels));
  }
  return lines;
}

Candidate make(Scene scene, const std::string& method, std::string quality, const IsKept& is_there, const Plan& plan) {
  Candidate candidate;
  candidate.left_out = left_out(scene, plan);
  candidate.scene = std::move(scene);
  candidate.method = method;
  candidate.quality = std::move(quality);
  candidate.cost = predicted_cost(plan, is_there);
  return candidate;
}

}  // namespace

Candidate reference(const Scene& scene, bool fine) {
  constexpr int kSteps = 192;
  Quality quality{"192 steps", {{"steps", kSteps}, {"tabulate", std::string("never")}}};
  if (fine) {
    quality.label = "192 steps, degree 4 or more, large tables";
    quality.parameters.insert(quality.parameters.end(),
                              {{"moments_lut", TableSize{96, 24}}, {"transmittance_lut", TableSize{512, 128}}});
    if (moment_settings(air_of(with_quality(scene, *find_method("orders"), {})), -1, 0, {96, 24}).degree < 4) {
      quality.parameters.emplace_back("degree", std::string("4"));
    }
  }
  Scene near_truth = with_quality(scene, *find_method("orders"), quality);
  const Plan plan = plan_of(near_truth);
  return make(
      std::move(near_truth), "orders", std::string(quality.label), [](ResourceId) { return false; }, plan);
}

std::vector<Candidate> candidates(const Scene& scene, double tolerance, const std::string& only,
                                  const std::vector<Candidate>& made) {
  std::set<std::string> keys;
  for (const Candidate& candidate : made) {
    const Plan plan = plan_of(candidate.scene);
    for (const ImageDesc& image : plan.images()) {
      if (!image.key.empty()) {
        keys.insert(image.key);
      }
    }
  }
  const OpticalDepths depths = air_of(scene).depths();
  std::vector<Candidate> all;
  const auto add = [&](Scene with, const SkyMethod& method, std::string label) {
    const Plan plan = plan_of(with);
    const IsKept is_there = [&](ResourceId id) {
      return is_table(plan, id) && keys.contains(plan.images()[std::get<ImageId>(id).index].key);
    };
    all.push_back(make(std::move(with), std::string(method.info.name), std::move(label), is_there, plan));
  };
  for (const SkyMethod& method : methods()) {
    const bool wanted = only.empty() || method.info.name == only;
    if (!wanted || method.add_passes == nullptr || !claims(method.validity, scene, depths.extinction)) {
      continue;
    }
    for (const Quality& quality : method.sweep) {
      if (!quality.may_be_chosen) {
        continue;
      }
      const Scene with = with_quality(scene, method, quality);
      add(with, method, std::string(quality.label));
      if (with.render.parameters.contains(kScale) && depths.scattering < 2.0 * tolerance) {
        Scene single = with;
        single.render.parameters.insert_or_assign(std::string(kScale), 0.0);
        add(std::move(single), method, std::string(quality.label) + ", single scattering");
      }
    }
  }
  std::ranges::stable_sort(all, {}, [](const Candidate& c) { return c.cost.total(); });
  return all;
}

}  // namespace airlight::choice
