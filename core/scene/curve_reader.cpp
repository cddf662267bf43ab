#include "core/scene/curve_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/base/text.h"
#include "core/scene/json_format.h"
#include "core/scene/json_text.h"
#include "core/scene/named_file.h"
#include "core/spectra/data.h"

namespace airlight {
namespace {

// Wavelengths that the eye sees, nm.
constexpr double kVisibleFrom = 380.0;
constexpr double kVisibleTo = 780.0;

constexpr std::string_view kForms =
    "{\"wavelengths_nm\": [...], \"values\": [...]}, {\"file\": ...}, {\"at_nm\": ..., \"value\": ..., \"exponent\": "
    "...}, {\"named\": ...} or {\"black_body_k\": ...}";

std::string sampled_json(const Curve& curve) {
  return "{\"wavelengths_nm\": " + json_list(curve.wavelengths) + ", \"values\": " + json_list(curve.values) + "}";
}

// One curve object, from its site.
class Form {
 public:
  Form(const Site& site, double column)
      : site_(site), object_(std::get<PresetObject>(site.value.data)), column_(column) {}

  Curve read() {
    const bool known = has("wavelengths_nm") || has("values") ? read_samples()
                       : has("file")                          ? read_file()
                       : has("at_nm") || has("exponent")      ? read_power()
                       : has("named")                         ? read_named()
                       : has("black_body_k")                  ? read_black_body()
                                                              : false;
    if (!known) {
      site_.complain("an object that is no curve; expected " + std::string(kForms));
    }
    if (curve_.json.empty() && curve_.is_sampled()) {
      curve_.json = sampled_json(curve_);
    }
    return curve_;
  }

 private:
  bool has(std::string_view key) const { return object_.contains(key); }
  std::string pointer(std::string_view key) const { return pointer_below(site_.pointer, key); }
  void complain(std::string_view key, const std::string& message) const {
    site_.problems.add(has(key) ? object_.find(key)->second : site_.value, pointer(key), message);
  }

  void only(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, value] : object_) {
      if (std::ranges::find(keys, key) == keys.end()) {
        site_.problems.add(value, pointer(key), "unknown key in this form of a curve; expected " + joined(keys));
      }
    }
  }

  double number(std::string_view key, const Range& range, std::string_view unit, std::optional<double> fallback = {}) {
    double value = fallback.value_or(range.minimum);
    const auto found = object_.find(key);
    if (found == object_.end()) {
      if (!fallback) {
        complain(key, "missing; expected a number, " + range_text(range, unit));
      }
      return value;
    }
    const Rule rule{.key = {}, .range = range, .unit = unit};
    read_number({site_.problems, found->second, pointer(key), rule}, value);
    return value;
  }

  // The range of a value of this key.
  const Range& values() const { return site_.rule.type == RuleType::shape ? kShapeValue : site_.rule.range; }

  std::vector<double> numbers(std::string_view key, const Range& range, std::string_view unit) {
    const auto found = object_.find(key);
    if (found == object_.end()) {
      complain(key, "missing; expected an array of as many numbers as its neighbour has");
      return {};
    }
    const auto* array = std::get_if<PresetArray>(&found->second.data);
    if (array == nullptr) {
      complain(key, quoted(found->second) + " is not an array; expected [" + range_text(range, unit) + ", ...]");
      return {};
    }
    const Rule rule{.key = {}, .range = range, .unit = unit};
    std::vector<double> all;
    for (std::size_t i = 0; i < array->size(); ++i) {
      double value = range.minimum;
      read_number({site_.problems, (*array)[i], pointer_below(pointer(key), std::to_string(i)), rule}, value);
      all.push_back(value);
    }
    return all;
  }

  bool read_samples() {
    only({"wavelengths_nm", "values"});
    curve_.wavelengths = numbers("wavelengths_nm", kWavelength, "nm");
    curve_.values = numbers("values", values(), site_.rule.unit);
    if (has("wavelengths_nm") && has("values")) {
      check_samples("wavelengths_nm", {});
    }
    return true;
  }

  // `place`: place in a file; empty: none.
  void check_samples(std::string_view key, const std::string& place) {
    const std::vector<double>& x = curve_.wavelengths;
    const auto descent = std::ranges::adjacent_find(x, [](double a, double b) { return b <= a; });
    if (x.size() != curve_.values.size()) {
      complain(key, place + std::to_string(x.size()) + " wavelengths for " + std::to_string(curve_.values.size()) +
                        " values; expected as many of both");
    } else if (x.size() < 2 || x.size() > kMaxCurveSamples) {
      complain(key, place + std::to_string(x.size()) + " points; expected 2 to " + std::to_string(kMaxCurveSamples) +
                        ": a curve that is the same everywhere is a number");
    } else if (descent != x.end()) {
      complain(key, place + format_number(descent[1]) + " nm does not follow " + format_number(descent[0]) +
                        "; expected ascending wavelengths");
    } else if (site_.rule.type == RuleType::shape &&
               std::ranges::count(curve_.values, 0.0) == std::ssize(curve_.values)) {
      complain(key, place + "0 at all wavelengths; expected light at some");
    } else {
      return;
    }
    curve_ = constant_curve(values().minimum);
  }

  bool read_file() {
    only({"file", "scale"});
    const auto* name = std::get_if<std::string>(&object_.find("file")->second.data);
    if (name == nullptr) {
      complain("file", quoted(object_.find("file")->second) + " is not a string; expected a file name");
      return true;
    }
    const double scale = number("scale", {.minimum = 0.0, .maximum = 1e30}, {}, 1.0);
    const std::filesystem::path file = file_beside(site_.value, *name);
    const NamedText named = read_named_text(file);
    if (!named.problem.empty()) {
      complain("file", file.string() + " cannot be read: " + named.problem + "; expected lines of nm,value");
      return true;
    }
    std::istringstream stream(named.text);
    read_lines(stream, file.string(), scale);
    return true;
  }

  // A line of words, such as "wavelength,albedo". One that begins with a number is a sample, good or bad.
  static bool is_heading(std::string_view line) {
    double number = 0.0;
    line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
    return line.find_first_of("+-.") != 0 &&
           std::from_chars(line.data(), line.data() + line.size(), number).ec == std::errc::invalid_argument;
  }

  // One line: two numbers separated by a comma, a semicolon, a tab or spaces.
  static bool parse(std::string_view line, double& nm, double& value) {
    const auto take = [&](double& number) {
      line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
      const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
      line.remove_prefix(static_cast<std::size_t>(end - line.data()));
      const bool ends = line.empty() || kBetween.find(line.front()) != std::string_view::npos;
      return error == std::errc() && ends && std::isfinite(number);
    };
    return take(nm) && take(value) && line.find_first_not_of(kBetween) == std::string_view::npos;
  }

  void read_lines(std::istream& stream, const std::string& file, double scale) {
    std::string line;
    int number = 0;
    bool may_be_heading = true;
    while (std::getline(stream, line)) {
      ++number;
      const std::size_t first = line.find_first_not_of(" \t\r");
      if (first == std::string::npos || line[first] == '#') {
        continue;
      }
      const std::string place = file + ":" + std::to_string(number) + ": ";
      double nm = 0.0;
      double value = 0.0;
      if (!parse(line, nm, value)) {
        if (!may_be_heading || !is_heading(line)) {
          complain("file", place + json_string(line.substr(0, 40)) + " is not nm,value; expected two numbers");
          curve_ = constant_curve(values().minimum);
          return;
        }
        may_be_heading = false;
        continue;
      }
      may_be_heading = false;
      value *= scale;
      const Rule wavelength{.key = {}, .range = kWavelength, .unit = "nm"};
      const Rule rule{.key = {}, .range = values(), .unit = site_.rule.unit};
      if (!wavelength.range.contains(nm) || !rule.range.contains(value)) {
        complain("file",
                 place + (wavelength.range.contains(nm) ? out_of_range(value, rule) : out_of_range(nm, wavelength)));
        curve_ = constant_curve(values().minimum);
        return;
      }
      curve_.wavelengths.push_back(nm);
      curve_.values.push_back(value);
    }
    check_samples("file", file + ": ");
  }

  bool read_power() {
    only({"at_nm", "value", "exponent"});
    curve_.at_nm = number("at_nm", kWavelength, "nm");
    curve_.value = number("value", values(), site_.rule.unit);
    curve_.exponent = number("exponent", kExponent, {});
    for (const double nm : {fine_bands().front().low, fine_bands().back().high}) {
      if (!values().contains(value_at(curve_, nm))) {
        const Rule rule{.key = {}, .range = values(), .unit = site_.rule.unit};
        complain("exponent", "at " + format_number(nm) + " nm the value " + out_of_range(value_at(curve_, nm), rule));
        return true;
      }
    }
    curve_.json = "{\"at_nm\": " + format_number(curve_.at_nm) + ", \"value\": " + format_number(curve_.value) +
                  ", \"exponent\": " + format_number(curve_.exponent) + "}";
    return true;
  }

  // Samples a law every 5 nm over the range of the fine bands.
  template <class Law>
  void sample(Law law) {
    for (double nm = fine_bands().front().low; nm <= fine_bands().back().high; nm += 5.0) {
      curve_.wavelengths.push_back(nm);
      curve_.values.push_back(law(nm));
    }
  }

  bool read_named() {
    const auto* name = std::get_if<std::string>(&object_.find("named")->second.data);
    std::vector<std::string> names(kPlainCurveNames.begin(), kPlainCurveNames.end());
    names.emplace_back("ozone");
    if (name == nullptr || std::ranges::find(names, *name) == names.end()) {
      complain("named", quoted(object_.find("named")->second) +
                            " is no named curve; expected one of \"air\", \"solar\", \"ozone\"" +
                            (name != nullptr ? did_you_mean(*name, names) : ""));
      return true;
    }
    if (*name == "ozone") {
      read_ozone();
      return true;
    }
    only({"named", "scale"});
    const double scale = number("scale", {.minimum = 0.0, .maximum = 1e9}, {}, 1.0);
    if (*name == "air") {
      sample([&](double nm) { return scale * rayleigh_scattering(nm); });
    } else {
      curve_ = scaled(solar_irradiance(), scale);
    }
    curve_.json =
        "{\"named\": " + json_string(*name) + (scale == 1.0 ? "" : ", \"scale\": " + format_number(scale)) + "}";
    return true;
  }

  void read_ozone() {
    only({"named", "dobson_units"});
    const double units = number("dobson_units", kDobsonUnits, "Dobson units");
    if (!(column_ > 0.0)) {
      complain("named",
               "ozone is given by its column over a medium; expected it as a medium's absorption_per_km, of a "
               "density that is not 0 everywhere");
      return;
    }
    curve_ = scaled(ozone_cross_section(), units * kMoleculesPerDobsonUnit / column_);
    curve_.json = "{\"named\": \"ozone\", \"dobson_units\": " + format_number(units) + "}";
  }

  bool read_black_body() {
    only({"black_body_k"});
    const double kelvin = number("black_body_k", kKelvin, "K");
    if (site_.rule.type != RuleType::shape) {
      complain("black_body_k", "a black body is light; expected it as sun.spectrum");
      return true;
    }
    sample([&](double nm) { return black_body(kelvin, nm); });
    curve_.json = "{\"black_body_k\": " + format_number(kelvin) + "}";
    return true;
  }

  static constexpr std::string_view kBetween = " ,;\t\r";  // numbers of a line

  const Site& site_;
  const PresetObject& object_;
  double column_;
  Curve curve_;
};

void warn_of(std::vector<std::string>& lines, const std::string& pointer, const Curve& curve) {
  if (!curve.is_sampled() || (curve.wavelengths.front() <= kVisibleFrom && curve.wavelengths.back() >= kVisibleTo)) {
    return;
  }
  lines.push_back(pointer + ": the curve has samples from " + format_number(curve.wavelengths.front()) + " to " +
                  format_number(curve.wavelengths.back()) + " nm and is held constant to " +
                  format_number(kVisibleFrom) + " and " + format_number(kVisibleTo) + " nm");
}

}  // namespace

std::filesystem::path file_beside(const PresetValue& value, const std::string& name) {
  const std::filesystem::path file(name);
  const bool in_preset = value.line > 0;
  return file.is_absolute() || !in_preset ? file : std::filesystem::path(value.source).parent_path() / file;
}

SpectralValue CurveReader::read(const Section& section, std::string_view key, double column) {
  const PresetValue* value = section.value_of(key);
  const bool takes_curves = section.rule(key).type == RuleType::curve;
  if (value != nullptr && !takes_curves && std::holds_alternative<PresetObject>(value->data)) {
    section.complain(key, *value, "a curve is no amount; give its shape as sun.spectrum, and a number here");
    return {};
  }
  SpectralValue read;
  if (value != nullptr && std::holds_alternative<PresetObject>(value->data)) {
    const Site site = section.site(key, *value);
    read.curve = Form(site, column).read();
    add(site.pointer);
    return read;
  }
  read = section.spectrum(key);
  const auto* array = value == nullptr ? nullptr : std::get_if<PresetArray>(&value->data);
  if (array != nullptr && array->size() == 3) {  // another number of them is told of by itself
    channels_.push_back({&section.problems(), value, section.pointer_to(key)});
  }
  read.curve = constant_curve(read[0]);
  return read;
}

Curve CurveReader::read_shape(const Section& section, std::string_view key) {
  const PresetValue* value = section.value_of(key);
  if (value == nullptr) {
    return solar_irradiance();
  }
  const Site site = section.site(key, *value);
  add(site.pointer);
  if (!std::holds_alternative<PresetObject>(value->data)) {
    site.complain(quoted(*value) + " is no curve; expected " + std::string(kForms));
    return solar_irradiance();
  }
  return Form(site, 0.0).read();
}

void CurveReader::add(const std::string& pointer) {
  first_ = any_ ? first_ : pointer;
  any_ = true;
}

void CurveReader::refuse_channels() const {
  if (!any_) {
    return;
  }
  for (const Channels& channels : channels_) {
    channels.problems->add(*channels.value, channels.pointer,
                           "three channels in a scene whose " + first_ +
                               " is a curve over the wavelength; write a number or a curve here as well, e.g. "
                               "{\"at_nm\": 550, \"value\": ..., \"exponent\": ...}");
  }
}

std::vector<std::string> curve_warnings(const Scene& scene) {
  std::vector<std::string> lines;
  if (scene.spectra) {
    for (std::size_t i = 0; i < scene.media.size(); ++i) {
      const std::string pointer = "/media/" + std::to_string(i);
      warn_of(lines, pointer + "/scattering_per_km", scene.media[i].scattering.curve);
      warn_of(lines, pointer + "/absorption_per_km", scene.media[i].absorption.curve);
    }
    warn_of(lines, "/planet/ground_albedo", scene.planet.ground_albedo.curve);
    warn_of(lines, "/sun/spectrum", scene.spectra->sun);
  }
  return lines;
}

}  // namespace airlight
