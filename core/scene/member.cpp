#include "core/scene/member.h"

#include <cmath>

#include "core/scene/angle.h"
#include "core/scene/curve_reader.h"
#include "core/scene/json_format.h"
#include "core/scene/section.h"

namespace airlight {
namespace {

constexpr std::string_view kDegreesUnit = "degrees";
constexpr std::string_view kMetresUnit = "m";
constexpr double kMetresOfKm = 1e3;

double in_scene(const Rule& rule, double value) {
  return rule.unit == kDegreesUnit  ? radians_from_degrees(value)
         : rule.unit == kMetresUnit ? value / kMetresOfKm
                                    : value;
}

// The number of metres that is read back as these km, to the last bit.
double metres(double km) {
  const double near = km * kMetresOfKm;
  for (const double m : {near, std::nextafter(near, 0.0), std::nextafter(near, 1e30)}) {
    if (m / kMetresOfKm == km) {
      return m;
    }
  }
  return near;
}

}  // namespace

void take(const Section& section, std::string_view key, double& out) {
  out = in_scene(section.rule(key), section.number(key));
}

void take(const Section& section, std::string_view key, int& out) {
  out = section.integer(key);
}

void take(const Section& section, std::string_view key, bool& out) {
  out = section.boolean(key);
}

void take(const Section& section, std::string_view key, std::string& out) {
  out = section.text(key);
}

void take(const Section& section, std::string_view key, std::array<double, 2>& out) {
  out = section.pair(key);
}

void take(const Section& section, std::string_view key, SpectralValue& out) {
  out = section.curves().read(section, key);
}

void take(const Section& section, std::string_view key, std::optional<double>& out) {
  out.reset();
  if (section.find(key) != nullptr || !section.rule(key).default_text.empty()) {
    take(section, key, out.emplace());
  }
}

void take_choice(const Section& section, std::string_view key, std::size_t& out) {
  out = section.choice(key).value_or(0);
}

std::string json_of(const Rule& rule, double value) {
  return format_number(rule.unit == kDegreesUnit  ? degrees_from_radians(value)
                       : rule.unit == kMetresUnit ? metres(value)
                                                  : value);
}

std::string json_of(const Rule& /*rule*/, int value) {
  return format_number(value);
}

std::string json_of(const Rule& /*rule*/, bool value) {
  return value ? "true" : "false";
}

std::string json_of(const Rule& /*rule*/, const std::string& value) {
  return json_string(value);
}

std::string json_of(const Rule& /*rule*/, const std::array<double, 2>& value) {
  return json_list({value[0], value[1]});
}

// A curve in a scene that has spectra, in which three channels are refused; else the channels.
std::string json_of(const SpectralValue& value) {
  const Curve& curve = value.curve;
  if (!curve.json.empty()) {
    return curve.json;
  }
  const bool is_number = curve.value != 0.0 || static_cast<const Spectrum&>(value) == Spectrum{};
  return is_number ? format_number(curve.value) : json_list({value.begin(), value.end()});
}

std::string json_of(const Rule& rule, const std::optional<double>& value) {
  return value ? json_of(rule, *value) : std::string();
}

std::string json_of_choice(const Rule& rule, std::size_t index) {
  return json_string(rule.choices[index]);
}

bool is_quiet(const Rule& rule) {
  return rule.quiet;
}

}  // namespace airlight
