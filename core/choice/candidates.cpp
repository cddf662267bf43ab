#include "core/choice/candidates.h"

#include <algorithm>
#include <set>

#include "core/luts/moments.h"
#include "core/methods/scene_air.h"

namespace airlight::choice {
namespace {

// The scene's passes and tables. A plan without the scene block cannot be run; it says what it costs.
Plan plan_of(const Scene& scene) {
  Plan plan;
  find_method(scene.render.method)->add_passes(plan, scene, air_of(scene), View{});
  return plan;
}

bool claims(const Validity& validity, const Scene& scene, double optical_depth) {
  return scene.sun.elevation >= validity.sun_elevation_min && scene.camera.altitude <= validity.altitude_max &&
         optical_depth <= validity.optical_depth_max;
}

// What this choice leaves out of the picture, a line each.
std::vector<std::string> left_out(const Scene& scene, const SkyMethod& method, const Plan& plan) {
  std::vector<std::string> lines =
      method.left_out == nullptr ? std::vector<std::string>() : method.left_out(scene, plan);
  if (std::ranges::all_of(plan.images(), [](const ImageDesc& image) { return image.key.empty(); })) {
    lines.push_back("tables kept from picture to picture: the method needs none");
  }
  return lines;
}

Candidate make(Scene scene, std::string quality, const IsKept& is_there, const Plan& plan) {
  Candidate candidate;
  candidate.method = scene.render.method;
  candidate.left_out = left_out(scene, *find_method(candidate.method), plan);
  candidate.scene = std::move(scene);
  candidate.quality = std::move(quality);
  candidate.cost = predicted_cost(plan, is_there);
  return candidate;
}

}  // namespace

Candidate reference(const Scene& scene, bool fine) {
  constexpr int kSteps = 192;
  Quality quality{"192 steps", {{"steps", kSteps}, {"tabulate", std::string("never")}}};
  if (fine) {
    quality.label = "192 steps, degree 6 or more, large tables";
    quality.parameters.insert(quality.parameters.end(),
                              {{"moments_lut", TableSize{96, 24}}, {"transmittance_lut", TableSize{512, 128}}});
    const Air air = air_of(with_quality(scene, *find_method("orders"), {}));
    if (moment_settings(air, {.size = {96, 24}}).degree < kMostClearDegree) {
      quality.parameters.emplace_back("degree", std::to_string(kMostClearDegree));
    }
  }
  Scene near_truth = with_quality(scene, *find_method("orders"), quality);
  const Plan plan = plan_of(near_truth);
  return make(std::move(near_truth), std::string(quality.label), kNothingIsKept, plan);
}

Candidate default_candidate(const Scene& scene) {
  Scene with = with_quality(scene, *find_method("orders"), {});
  const Plan plan = plan_of(with);
  return make(std::move(with), "default", kNothingIsKept, plan);
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
  const auto add = [&](Scene with, std::string label) {
    const Plan plan = plan_of(with);
    const IsKept is_there = [&](ResourceId id) {
      return is_table(plan, id) && keys.contains(plan.images()[std::get<ImageId>(id).index].key);
    };
    all.push_back(make(std::move(with), std::move(label), is_there, plan));
  };
  for (const SkyMethod& method : methods()) {
    const bool wanted = only.empty() || method.info.name == only;
    const bool draws = method.add_passes != nullptr && (!scene.terrain || method.info.knows_terrain) &&
                       (scene.spheres.empty() || method.info.knows_spheres) &&
                       (!scene.ground || method.info.knows_ground_maps);
    if (!wanted || !draws || !claims(method.validity, scene, depths.extinction)) {
      continue;
    }
    for (const Quality& quality : method.sweep) {
      if (!quality.may_be_chosen) {
        continue;
      }
      const Scene with = with_quality(scene, method, quality);
      add(with, std::string(quality.label));
      if (!method.single_scattering.empty() && depths.scattering < 2.0 * tolerance) {
        Scene single = with;
        for (const auto& [key, value] : method.single_scattering) {
          single.render.parameters.insert_or_assign(std::string(key), value);
        }
        add(std::move(single), std::string(quality.label) + ", single scattering");
      }
    }
  }
  std::ranges::stable_sort(all, {}, [](const Candidate& c) { return c.cost.total(); });
  return all;
}

}  // namespace airlight::choice
