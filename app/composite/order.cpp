#include "app/composite/order.h"

#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/member.h"
#include "core/base/text.h"

namespace airlight::cli {
namespace {

using composite::Fog;
using composite::FogKind;

std::optional<double> non_negative(const std::string& text) {
  const std::optional<double> value = number_from<double>(text);
  return value && *value >= 0.0 ? value : std::nullopt;
}

// A parameter of the fogs: one number or three.
struct Parameter {
  std::string name;
  std::string kinds;  // fogs that have it
  MemberOf<Fog, double> value = nullptr;
  MemberOf<Fog, physics::vec3> colour = nullptr;
};

const std::array<Parameter, 8>& parameters() {
  static const std::array<Parameter, 8> all{{
      {"colour", "exponential, sun-tinted, height, extinction-inscatter", nullptr, &Fog::colour},
      {"density", "exponential, sun-tinted", &Fog::density, nullptr},
      {"sun-colour", "sun-tinted", nullptr, &Fog::sun_colour},
      {"sun-power", "sun-tinted", &Fog::sun_power, nullptr},
      {"a", "height", &Fog::amount, nullptr},
      {"b", "height", &Fog::falloff, nullptr},
      {"extinction", "extinction-inscatter", nullptr, &Fog::extinction},
      {"inscatter", "extinction-inscatter", nullptr, &Fog::inscatter},
  }};
  return all;
}

void set(Fog& fog, const std::string& kind, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string key = assignment.substr(0, equals);
  if (kind == "height" && assignment == "exact") {
    fog.exact = true;
    return;
  }
  std::string names = kind == "height" ? "exact" : "";
  for (const Parameter& parameter : parameters()) {
    if (parameter.kinds.find(kind) == std::string::npos) {
      continue;
    }
    names += (names.empty() ? "" : ", ") + parameter.name;
    if (parameter.name != key || equals == std::string::npos) {
      continue;
    }
    const std::vector<std::string> words = split(assignment.substr(equals + 1), ',');
    std::vector<double> values;
    for (const std::string& word : words) {
      if (const std::optional<double> value = non_negative(word)) {
        values.push_back(*value);
      }
    }
    const std::size_t wanted = parameter.value != nullptr ? 1 : 3;
    if (values.size() != words.size() || values.size() != wanted) {
      throw InputError("composite: --fog-set " + assignment + ": " + key + " takes " +
                       (wanted == 1 ? "one number" : "three numbers, such as 0.5,0.6,0.7,") + " from 0 up");
    }
    if (parameter.value != nullptr) {
      fog.*parameter.value = values[0];
    } else {
      fog.*parameter.colour = {values[0], values[1], values[2]};
    }
    return;
  }
  throw InputError("composite: --fog-set " + assignment + ": --fog " + kind + " has " + names + "; write for example " +
                   names.substr(names.rfind(' ') + 1) + "=0.1");
}

}  // namespace

ExtraLayers extra_layers(const std::string& text) {
  ExtraLayers layers;
  for (const std::string& word : text.empty() ? std::vector<std::string>() : split(text, ',')) {
    if (word == "inscatter") {
      layers.inscatter = true;
    } else if (word == "transmittance") {
      layers.transmittance = true;
    } else {
      throw InputError("composite: --layers: '" + word + "' is neither inscatter nor transmittance");
    }
  }
  return layers;
}

std::optional<double> unit_km(const std::string& text) {
  if (text == "auto") {
    return std::nullopt;
  }
  struct Unit {
    const char* name;
    double km;
  };
  constexpr std::array<Unit, 6> kUnits{
      {{"mm", 1e-6}, {"cm", 1e-5}, {"m", 1e-3}, {"km", 1.0}, {"ft", 3.048e-4}, {"in", 2.54e-5}}};
  for (const Unit& unit : kUnits) {
    if (text == unit.name) {
      return unit.km;
    }
  }
  const std::optional<double> metres = non_negative(text);
  if (!metres || *metres == 0.0) {
    throw InputError("composite: --depth-unit: '" + text +
                     "' is no unit; write mm, cm, m, km, in, ft or the unit's length in metres");
  }
  return *metres * 1e-3;
}

std::optional<Fog> fog_of(const CompositeOrder& order) {
  if (order.fog.empty()) {
    if (!order.fog_parameters.empty()) {
      throw InputError("composite: --fog-set " + order.fog_parameters.front() + " without --fog; name the fog");
    }
    return std::nullopt;
  }
  Fog fog;
  fog.kind = composite::fog_kind(order.fog).value_or(FogKind::exponential);
  for (const std::string& assignment : order.fog_parameters) {
    set(fog, order.fog, assignment);
  }
  return fog;
}

void check(const CompositeOrder& order) {
  if (order.beauty.empty()) {
    throw InputError("composite: no picture given; write --beauty FILE.exr");
  }
  if (order.output.empty()) {
    throw InputError("composite: no output given; write -o FILE.exr");
  }
  if (!(order.scale > 0.0) || !std::isfinite(order.scale)) {
    throw InputError("composite: --scale must be above 0; it multiplies the beauty");
  }
  if (order.full_float && order.half) {
    throw InputError("composite: --float and --half exclude each other; give one");
  }
  if (order.tolerance && !order.aerial.empty()) {
    throw InputError("composite: --tolerance chooses between what --aerial names; give one of the two");
  }
  if (!order.fog.empty() && (order.tolerance || !order.aerial.empty())) {
    throw InputError(
        "composite: --fog takes the place of the air that --aerial and --tolerance are about; leave them out");
  }
  static_cast<void>(extra_layers(order.layers));
  static_cast<void>(unit_km(order.unit));
  static_cast<void>(fog_of(order));
}

}  // namespace airlight::cli
