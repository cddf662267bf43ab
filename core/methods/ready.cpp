#include "core/methods/ready.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/air/refraction.h"
#include "core/methods/method.h"
#include "core/scene/thing_kinds.h"
#include "core/stage/lights.h"

namespace airlight {
namespace {

template <class T>
T value_of(const RenderSettings& settings, std::string_view key, T otherwise) {
  const auto found = settings.parameters.find(key);
  const T* value = found == settings.parameters.end() ? nullptr : std::get_if<T>(&found->second);
  return value == nullptr ? otherwise : *value;
}

Shells shells_of(const std::string& wish) {
  return wish == "always" ? Shells::always : wish == "auto" ? Shells::where_needed : Shells::never;
}

// The options that the method's own keys set; a missing key sets none.
AirOptions air_options(const RenderSettings& settings) {
  AirOptions options;
  if (const auto fade = settings.parameters.find("sun_fade"); fade != settings.parameters.end()) {
    const SunFade* const value = std::get_if<SunFade>(&fade->second);
    options.sun_fade = value == nullptr ? std::nullopt : std::optional(*value);
  }
  options.schlick = value_of<std::string>(settings, "phase", "media") == "schlick";
  options.multiple_scattering_scale = value_of(settings, "multiple_scattering_scale", 1.0);
  options.shells = shells_of(value_of<std::string>(settings, "shells", "never"));
  options.moment_rows = value_of(settings, "moments_lut", TableSize{0, options.moment_rows})[1];
  return options;
}

// All wavelengths of a scene are rendered alike.
PartSettings settled(const Part& whole) {
  RenderSettings render = whole.scene.render;
  if (const auto settle = method_of(whole.scene).settle; settle != nullptr) {
    settle(render, whole);
  }
  return {render, air_options(render)};
}

Scene as_rays_go(Scene scene) {
  if (!bends_light(scene)) {
    scene.planet.refraction.reset();
  } else if (stand_at_true_distance(scene)) {
    scene.planet.refraction->scale = scale_for_things(scene.planet, scene.camera.altitude);
  }
  return scene;
}

using NightMaker = std::function<Night(const Air&)>;

Stage made(const Scene& scene, const std::optional<Nodes>& listed, const Stage* like, const std::string& light = {},
           const NightMaker& night = {});

std::vector<Stage> further_lights(const Stage& stage, const std::optional<Nodes>& listed) {
  Scene lit = by_moonlight(stage.scene());
  if (lit.spectra) {
    lit.spectra->wavelengths = static_cast<int>(stage.basis().nodes.nm.size());
  }
  return {made(lit, listed, &stage, " by moonlight")};
}

Stage made(const Scene& given, const std::optional<Nodes>& listed, const Stage* like, const std::string& light,
           const NightMaker& night) {
  const Scene scene = as_rays_go(given);
  const std::vector<Air> known = like == nullptr ? std::vector<Air>() : StageMaker::airs_of(*like);
  const Things::Others others = like == nullptr ? Things::Others() : StageMaker::things_of(*like);
  Part whole{scene, air_like(known, scene, air_options(scene.render)), Things(scene, others)};
  StageMaker maker{method_of(scene), std::move(whole), settled, listed, like};
  maker.light = light;
  maker.night = night;
  if (scene.moon) {
    maker.others = [listed](const Stage& stage) { return further_lights(stage, listed); };
  }
  return maker.make();
}

}  // namespace

bool bends_light(const Scene& scene) {
  return scene.planet.refraction && method_of(scene).info.bends_light;
}

Stage ready(const Scene& scene) {
  return made(scene, std::nullopt, nullptr);
}

Stage ready(const Scene& scene, const Stage& like) {
  return made(scene, std::nullopt, &like);
}

Stage ready_at(const Scene& scene, const Nodes& nodes, const Stage& like) {
  return made(scene, nodes, &like);
}

Stage ready_part(Scene group, const Stage& listed, std::size_t g) {
  const Scene& whole = listed.scene();
  group.night_sky = whole.night_sky;
  group.stars = whole.stars;
  std::array<WaveBand, 3> bands{};
  const std::vector<WaveBand>& all = listed.basis().nodes.bands;
  for (std::size_t c = 0; c < 3; ++c) {
    bands[c] = all[std::min(3 * g + c, all.size() - 1)];
  }
  return made(group, std::nullopt, &listed, {}, [whole, bands](const Air& air) {
    return night_of(whole, {{air}, {}}, bands);
  });
}

}  // namespace airlight
