#include "core/choice/candidates.h"

#include <algorithm>
#include <set>

#include "core/luts/moments.h"
#include "core/methods/ready.h"
#include "core/scene/thing_kinds.h"

namespace airlight::choice {
namespace {

// The scene's passes and tables. A plan without the scene block cannot be run; it says what it costs.
Plan plan_of(const Stage& stage) {
  Plan plan;
  stage.method().add_passes(plan, stage.whole(), View{});
  return plan;
}

bool claims(const Validity& validity, const Scene& scene, double optical_depth) {
  return scene.sun.elevation >= validity.sun_elevation_min && scene.camera.altitude <= validity.altitude_max &&
         optical_depth <= validity.optical_depth_max;
}

// What this choice leaves out of the picture, a line each.
std::vector<std::string> left_out(const Stage& stage, const Plan& plan) {
  const auto left_out = stage.method().left_out;
  std::vector<std::string> lines = left_out == nullptr ? std::vector<std::string>() : left_out(stage.scene(), plan);
  if (std::ranges::all_of(plan.images(), [](const ImageDesc& image) { return image.key.empty(); })) {
    lines.push_back("tables kept from picture to picture: the method needs none");
  }
  return lines;
}

Candidate make(const Stage& stage, std::string quality, const IsKept& is_there, const Plan& plan) {
  return {stage, stage.scene().render.method, std::move(quality), left_out(stage, plan),
          predicted_cost(plan, is_there)};
}

// Nothing is made yet.
Candidate alone(const Stage& stage, std::string quality) {
  const auto none = [](ResourceId) { return false; };
  return make(stage, std::move(quality), none, plan_of(stage));
}

}  // namespace

Candidate reference(const Stage& stage, bool fine) {
  constexpr int kSteps = 192;
  const SkyMethod& orders = *find_method("orders");
  Quality quality{"192 steps", {{"steps", kSteps}, {"tabulate", std::string("never")}}};
  if (fine) {
    quality.label = "192 steps, degree 6 or more, large tables";
    quality.parameters.insert(quality.parameters.end(),
                              {{"moments_lut", TableSize{96, 24}}, {"transmittance_lut", TableSize{512, 128}}});
    const Air air = ready(with_quality(stage.scene(), orders, {}), stage).whole().air;
    if (moment_settings(air, {.size = {96, 24}}).degree < kMostClearDegree) {
      quality.parameters.emplace_back("degree", std::to_string(kMostClearDegree));
    }
  }
  return alone(ready(with_quality(stage.scene(), orders, quality), stage), std::string(quality.label));
}

Candidate default_candidate(const Stage& stage) {
  return alone(ready(with_quality(stage.scene(), *find_method("orders"), {}), stage), "default");
}

std::vector<Candidate> candidates(const Stage& stage, double tolerance, const std::string& only,
                                  const std::vector<Candidate>& made) {
  const Scene& scene = stage.scene();
  std::set<std::string> keys;
  for (const Candidate& candidate : made) {
    const Plan plan = plan_of(candidate.stage);
    for (const ImageDesc& image : plan.images()) {
      if (!image.key.empty()) {
        keys.insert(image.key);
      }
    }
  }
  const OpticalDepths depths = stage.whole().air.depths();
  std::vector<Candidate> all;
  const auto add = [&](const Scene& scene_with, std::string label) {
    const Stage with = ready(scene_with, stage);
    const Plan plan = plan_of(with);
    const IsKept is_there = [&](ResourceId id) {
      return is_table(plan, id) && keys.contains(plan.images()[std::get<ImageId>(id).index].key);
    };
    all.push_back(make(with, std::move(label), is_there, plan));
  };
  for (const SkyMethod& method : methods()) {
    const bool wanted = only.empty() || method.info.name == only;
    const bool draws = method.add_passes != nullptr && knows_things_of(method.info, scene);
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
        add(single, std::string(quality.label) + ", single scattering");
      }
    }
  }
  std::ranges::stable_sort(all, {}, [](const Candidate& c) { return c.cost.total(); });
  return all;
}

}  // namespace airlight::choice
