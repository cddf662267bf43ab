#include "core/methods/scene_air.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <string>
#include <variant>

namespace airlight {
namespace {

constexpr std::size_t kRememberedAirs = 16;

template <class T>
T value_of(const RenderSettings& settings, std::string_view key, T otherwise) {
  const auto found = settings.parameters.find(key);
  const T* value = found == settings.parameters.end() ? nullptr : std::get_if<T>(&found->second);
  return value == nullptr ? otherwise : *value;
}

Shells shells_of(const std::string& wish) {
  return wish == "always" ? Shells::always : wish == "auto" ? Shells::where_needed : Shells::never;
}

// The latest first.
class Shelf {
 public:
  Air find(const Scene& scene, const AirOptions& options) {
    const std::lock_guard lock(mutex_);
    const auto same_matter = [&](const Air& air) { return air.media() == scene.media && air.planet() == scene.planet; };
    auto found =
        std::ranges::find_if(airs_, [&](const Air& air) { return air.options() == options && same_matter(air); });
    if (found == airs_.end()) {
      found = std::ranges::find_if(airs_, same_matter);
      airs_.push_front(found == airs_.end() ? Air(scene.media, scene.planet, options) : found->with(options));
      if (airs_.size() > kRememberedAirs) {
        airs_.pop_back();
      }
      return airs_.front();
    }
    return *found;
  }

 private:
  std::mutex mutex_;
  std::deque<Air> airs_;
};

}  // namespace

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

Air air_of(const Scene& scene) {
  static Shelf shelf;
  return shelf.find(scene, air_options(scene.render));
}

physics::Physics make_physics(const Scene& scene) {
  return formulas_of(air_of(scene), scene);
}

}  // namespace airlight
