#include "tests/fuzz/any_preset.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

#include "core/methods/method.h"
#include "core/scene/json_format.h"
#include "core/scene/render_settings.h"
#include "core/scene/rules.h"
#include "core/spectra/phase_table.h"

namespace airlight::fuzz {
namespace {

constexpr double kMostSteps = 64;
constexpr double kLargestTable = 96;
constexpr int kLargestTracedCube = 2;

double number_of(std::string_view text, double otherwise) {
  double value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// A usual value of a key without a default.
double usual(std::string_view key) {
  if (key.ends_with("scale_height_km") || key.ends_with("below_km") || key.ends_with("half_width_km")) {
    return 8.0;
  }
  return key.ends_with("center_km") ? 20.0 : key.ends_with("per_km") ? 0.01 : 1.0;
}

double within(Random& random, Range range, double middle) {
  range.minimum = std::max(range.minimum, -1e9);
  range.maximum = std::min(range.maximum, 1e9);
  if (range.minimum_excluded || range.maximum_excluded) {
    const double inset = 1e-6 * (range.maximum - range.minimum);
    range = {.minimum = range.minimum + inset, .maximum = range.maximum - inset};
  }
  const double kind = random.uniform(0.0, 1.0);
  double value = middle;
  if (kind < 0.1) {
    value = random.chance(0.5) ? range.minimum : range.maximum;
  } else if (kind < 0.2) {
    value = random.uniform(range.minimum, range.maximum);
  } else if (kind < 0.4) {
    const double least = std::max(range.minimum, range.maximum * 1e-18);
    value =
        range.minimum < 0.0 ? random.uniform(range.minimum, range.maximum) : random.log_uniform(least, range.maximum);
  } else if (middle != 0.0) {
    value = middle * random.log_uniform(0.1, 10.0);
  } else {
    value = random.uniform(-1.0, 1.0) * std::min(1.0, range.maximum);
  }
  return std::clamp(value, range.minimum, range.maximum);
}

// The things on the planet besides its air.
struct Things {
  bool spheres = false;
  bool terrain = false;
  bool ground_maps = false;
  bool clouds = false;
};

class Writer {
 public:
  explicit Writer(Random& random) : random_(random) {}

  std::string preset() {
    const Things things = any_things();
    const SkyMethod& method = any_method(things);
    std::string text = "{\"airlight\": 1, \"name\": \"any\"";
    for (const std::string_view section : {"planet", "sun", "camera", "bloom", "display"}) {
      const std::string own = object(section);
      text += ", " + quoted(section) + ": " +
              (section == "planet"   ? planet(own, things)
               : section == "camera" ? camera(own, method)
                                     : own);
    }
    text += night();
    text += things.spheres ? ", \"scene\": {\"spheres\": [" + spheres() + "]}" : "";
    text += things.clouds ? ", \"clouds\": [" + clouds() + "]" : "";
    const bool square = projection_ == "octahedral";
    const int any_side = 1 + static_cast<int>(random_.below(9));
    // Small cubes for a method on the host: all pixels cost it the same, and nine a side in thick air is a minute of
    // paths.
    const int side =
        projection_ == "cube" && method.render_on_host != nullptr ? std::min(any_side, kLargestTracedCube) : any_side;
    const int columns = projection_ == "cube" ? side * cube_cells_[0] : side;
    const int rows = projection_ == "cube" ? side * cube_cells_[1]
                     : square              ? side
                                           : 1 + static_cast<int>(random_.below(6));
    text += ", \"image\": {\"width\": " + std::to_string(columns) + ", \"height\": " + std::to_string(rows) + "}";
    text += ", \"media\": [" + media() + "], \"render\": " + render(method) + "}";
    return text;
  }

 private:
  static std::string quoted(std::string_view text) { return json_string(text); }

  std::string number(const Range& range, double middle) { return format_number(within(random_, range, middle)); }

  std::string spectrum(const Rule& rule) {
    const double middle = number_of(rule.default_text, 0.0);
    const double around = middle != 0.0 ? middle : usual(rule.key);
    // Coefficients from their whole range mostly give air that is refused.
    const bool mild = rule.key.ends_with("per_km") && random_.chance(0.8);
    const auto one = [&] {
      return mild ? format_number(random_.chance(0.1) ? 0.0 : around * random_.log_uniform(0.01, 100.0))
                  : number(rule.range, around);
    };
    if (random_.chance(0.4)) {
      return one();
    }
    return "[" + one() + ", " + one() + ", " + one() + "]";
  }

  std::string value(const Rule& rule) {
    switch (rule.type) {
      case RuleType::boolean:
        return random_.chance(0.5) ? "true" : "false";
      case RuleType::integer:
        return std::to_string(static_cast<int>(within(random_, rule.range, number_of(rule.default_text, 1.0))));
      case RuleType::number:
        return number(rule.range, rule.default_text.empty() ? usual(rule.key) : number_of(rule.default_text, 0.0));
      case RuleType::spectrum:
      case RuleType::curve:
        return spectrum(rule);
      case RuleType::pair:
        return "[" + number(rule.range, 10.0) + ", " + number(rule.range, -10.0) + "]";
      case RuleType::choice: {
        const std::string_view picked = random_.pick(rule.choices);
        return picked == "table" ? std::string() : quoted(picked);  // tables are written by table()
      }
      case RuleType::exposure:
        return random_.chance(0.5) ? "\"auto\"" : number(rule.range, 1.0);
      case RuleType::layers:
        return layers(rule);
      default:
        return {};
    }
  }

  // The keys of one object and of the objects in it; `choice`: its type, profile, projection or function.
  std::string object(std::string_view section, std::string choice = {}) {
    for (const Rule& rule : rules()) {
      if (choice.empty() && rule.key.starts_with(std::string(section) + ".") && rule.type == RuleType::choice &&
          rule.only_for.empty() &&
          (rule.key.ends_with(".projection") || rule.key.ends_with(".profile") || rule.key.ends_with(".function"))) {
        do {
          choice = random_.pick(rule.choices);
        } while (choice == "table");  // those are written by table()
      }
    }
    if (section == "camera") {
      projection_ = choice;
    }
    std::string text;
    std::string last;
    for (const Rule& rule : rules()) {
      const std::string prefix = std::string(section) + ".";
      if (!rule.key.starts_with(prefix) || rule.key == last) {
        continue;
      }
      const std::string key(rule.key.substr(prefix.size()));
      const bool fits = rule.only_for.empty() || std::ranges::find(rule.only_for, choice) != rule.only_for.end();
      const bool upright = projection_ != "perspective" && projection_ != "fisheye" &&
                           (key == "pitch_deg" || key == "roll_deg" || key == "vertical_fov_deg");
      // Not texts, which are no numbers to try; not bloom where the map is cut.
      const bool left_out = key == "display" || key == "view" || key == "enabled" || (section == "camera" && upright);
      if (key.find_first_of(".[") != std::string::npos || !fits || left_out) {
        continue;
      }
      const bool wanted = rule.required || random_.chance(0.8);
      const bool is_choice = key == "projection" || key == "profile" || key == "type" || key == "function";
      std::string what = is_choice ? quoted(choice) : wanted ? value(rule) : std::string();
      if (what.empty()) {
        continue;
      }
      if (key == "cube_layout") {
        cube_cells_ = what == "\"strip\""   ? std::array{6, 1}
                      : what == "\"cross\"" ? std::array{3, 4}
                                            : std::array{1, 6};
      }
      last = rule.key;
      text += (text.empty() ? "" : ", ") + quoted(key) + ": " + what;
    }
    if (section == "sun") {
      text += std::string(text.empty() ? "" : ", ") + "\"disc\": " + object("sun.disc");
    }
    return "{" + text + "}";
  }

  Things any_things() {
    if (random_.chance(0.6)) {
      return {};
    }
    const bool any_clouds = random_.chance(0.25);
    // Mostly clouds alone: few methods take them among other things.
    const bool alone = any_clouds && random_.chance(0.7);
    return {!alone && random_.chance(0.4), !alone && random_.chance(0.4), !alone && random_.chance(0.5), any_clouds};
  }

  // Moon, stars and the sky beyond the air, now and then.
  std::string night() {
    std::string text;
    if (random_.chance(0.2)) {
      const std::string lit = random_.chance(0.5) ? "\"phase_deg\": " + format_number(random_.uniform(-180.0, 180.0))
                                                  : "\"illuminated\": " + format_number(random_.uniform(0.0, 1.0));
      text += ", \"moon\": {\"elevation_deg\": " + format_number(random_.uniform(-90.0, 90.0)) +
              ", \"azimuth_deg\": " + format_number(random_.uniform(-180.0, 180.0)) + ", " + lit + "}";
    }
    text += random_.chance(0.1) ? ", \"night_sky\": " + object("night_sky") : "";
    text += random_.chance(0.1) ? ", \"stars\": " + object("stars") : "";
    return text;
  }

  // A method that supports these things.
  const SkyMethod& any_method(Things things) {
    for (;;) {
      const SkyMethod& method = random_.pick(methods());
      const MethodInfo& info = method.info;
      if ((!things.spheres || info.knows_bodies) && (!things.terrain || info.knows_terrain) &&
          (!things.ground_maps || info.knows_ground_maps) && (!things.clouds || info.knows_clouds)) {
        return method;
      }
    }
  }

  // The camera's own keys, now and then with a filter before it.
  std::string camera(const std::string& own, const SkyMethod& method) {
    const bool has_up = projection_ == "perspective" || projection_ == "fisheye";
    if (!method.info.knows_polarisers || !has_up || !random_.chance(0.3)) {
      return own;
    }
    return own.substr(0, own.size() - 1) + (own == "{}" ? "" : ", ") + "\"polariser\": " + object("camera.polariser") +
           "}";
  }

  // The planet's own keys, those of bent light and of its ground. Maps are only names: the caller that renders the
  // scene fills them.
  std::string planet(const std::string& own, Things things) {
    std::string more;
    const auto add = [&](const std::string& key) { more += (more.empty() ? "" : ", ") + key; };
    if (random_.chance(0.2)) {
      add("\"refraction\": {\"n_minus_1\": " + format_number(random_.log_uniform(1e-8, 1e-3)) +
          ", \"scale_height_km\": " + format_number(random_.log_uniform(0.5, 100.0)) + "}");
    }
    if (things.terrain) {
      const bool map = random_.chance(0.5);
      const std::string keys = object("planet.terrain");
      const bool sized = keys.find("width_km") != std::string::npos;
      add("\"terrain\": {" +
          std::string(map ? "\"height_map\": \"heights\"" : "\"ridge\": " + object("planet.terrain.ridge")) +
          (sized ? "" : ", \"width_km\": 40") + (map && random_.chance(0.5) ? ", \"albedo_map\": \"colours\"" : "") +
          (keys == "{}" ? "}" : ", " + keys.substr(1)));
    }
    if (things.ground_maps) {
      const bool ocean = random_.chance(0.6);
      if (!ocean || random_.chance(0.5)) {
        add("\"albedo_map\": \"colours\"");
      }
      if (ocean) {
        const std::string keys = object("planet.ocean");
        const std::string mask = random_.chance(0.5) ? "\"mask_map\": \"water\"" : "";
        add("\"ocean\": {" + mask + (mask.empty() || keys == "{}" ? "" : ", ") + keys.substr(1));
      }
    }
    return more.empty() ? own : own.substr(0, own.size() - 1) + (own == "{}" ? "" : ", ") + more + "}";
  }

  std::string spheres() {
    std::string text;
    for (std::uint64_t count = 1 + random_.below(random_.chance(0.1) ? 16 : 3); count > 0; --count) {
      const std::string_view material = random_.pick(kMaterialNames);
      const double distance = random_.log_uniform(1e-3, random_.chance(0.1) ? 1e7 : 100.0);
      const double radius = distance * (random_.chance(0.1) ? 1.5 : random_.uniform(0.01, 0.9));
      text += (text.empty() ? "{" : ", {") + std::string("\"azimuth_deg\": ") +
              format_number(random_.uniform(-60, 60)) +
              ", \"elevation_deg\": " + format_number(random_.uniform(-30, 30)) +
              ", \"distance_m\": " + format_number(distance) +
              ", \"radius_m\": " + format_number(std::clamp(radius, 1e-4, 1e6)) + ", \"material\": " + quoted(material);
      const bool own = material == "matte" || material == "mirror" || material == "translucent";
      text += own ? ", \"albedo\": " + format_number(random_.uniform(0.0, 1.0)) + "}" : "}";
    }
    return text;
  }

  std::string clouds() {
    constexpr std::array<std::string_view, 3> kFields{"cumulus", "stratocumulus", "cirrus"};
    std::string text;
    for (std::uint64_t count = random_.chance(0.8) ? 1 : 1 + random_.below(3); count > 0; --count) {
      const std::string_view kind = random_.pick(kFields);
      // Any number of any key mostly gives clouds above the air or of too many cells.
      const std::string keys = random_.chance(0.3)
                                   ? object("clouds[]", std::string(kind))
                                   : "{\"type\": " + quoted(kind) +
                                         ", \"cover\": " + format_number(random_.uniform(0.0, 1.0)) +
                                         ", \"detail_m\": " + format_number(random_.log_uniform(80.0, 1000.0)) +
                                         ", \"seed\": " + std::to_string(random_.below(1000)) + "}";
      const std::string phase = random_.chance(0.3) ? ", \"phase\": " + object("clouds[].phase") : "";
      text += (text.empty() ? "" : ", ") + keys.substr(0, keys.size() - 1) + phase + "}";
    }
    return text;
  }

  std::string layers(const Rule& rule) {
    std::string text;
    double altitude = random_.chance(0.5) ? 0.0 : random_.log_uniform(1e-6, 10.0);
    for (std::uint64_t count = 1 + random_.below(31); count > 0; --count) {
      text += (text.empty() ? "[" : ", [") + format_number(altitude) + ", " + number(rule.range, 1.0) + "]";
      altitude += random_.chance(0.2) ? random_.log_uniform(1e-6, 100.0) : random_.uniform(0.1, 8.0);
    }
    return "[" + text + "]";
  }

  // A phase function of any shape, with the required integral.
  std::string table() {
    PhaseTable made;
    made.rows.emplace_back();
    const auto last = static_cast<double>(1 + random_.below(30));
    for (double i = 0.0; i <= last; i += 1.0) {
      made.angles_deg.push_back(180.0 * i / last);
      made.rows[0].push_back(random_.log_uniform(1e-3, 1e3));
    }
    const double integral = sphere_integral(made, 0);
    std::string angles;
    std::string values;
    for (std::size_t k = 0; k < made.angles_deg.size(); ++k) {
      angles += (k == 0 ? "" : ", ") + format_number(made.angles_deg[k]);
      values += (k == 0 ? "" : ", ") + format_number(made.rows[0][k] / integral);
    }
    return "{\"function\": \"table\", \"angles_deg\": [" + angles + "], \"values\": [" + values + "]}";
  }

  std::string media() {
    std::string text;
    const std::uint64_t count = random_.chance(0.15) ? 8 : 1 + random_.below(3);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::string own = object("media[]");  // the coefficients; the name is a text
      text += (text.empty() ? "{" : ", {") + std::string("\"name\": \"m") + std::to_string(i) + "\", " +
              (own == "{}" ? "" : own.substr(1, own.size() - 2) + ", ") + "\"density\": " + object("media[].density") +
              ", \"phase\": " + (random_.chance(0.1) ? table() : object("media[].phase")) + "}";
    }
    return text;
  }

  std::string parameter(const ParameterInfo& info) {
    switch (info.kind) {
      case ParameterKind::boolean:
        return random_.chance(0.5) ? "true" : "false";
      case ParameterKind::choice:
        return quoted(random_.pick(info.choices));
      case ParameterKind::integer: {
        const double most = info.key == "seed" ? info.maximum : std::min(info.maximum, kMostSteps);
        return std::to_string(static_cast<int>(random_.uniform(info.minimum, std::min(most, 2e9))));
      }
      case ParameterKind::number:
        // A fuzzer's results must not depend on a clock.
        return info.key.ends_with("_s") || info.key == "target_error" ? "0" : number(rule_of(info).range, 1.0);
      case ParameterKind::table_size: {
        const double most = std::min(info.maximum, kLargestTable);
        const auto side = [&] { return std::to_string(static_cast<int>(random_.log_uniform(info.minimum, most))); };
        return "[" + side() + ", " + side() + "]";
      }
      case ParameterKind::sun_fade:
        return "{\"scale\": " + number(rule_of(info).range, 1.0) + ", \"bias\": " + number(rule_of(info).range, 0.1) +
               "}";
    }
    return {};
  }

  std::string render(const SkyMethod& method) {
    std::string text = "{\"method\": " + quoted(method.info.name);
    for (const ParameterInfo& info : method.info.parameters) {
      if (info.key == "samples") {
        text += ", \"samples\": 32";
      } else if (random_.chance(0.3) && !(info.key == "max_orders" && random_.chance(0.5))) {
        text += ", " + quoted(info.key) + ": " + parameter(info);
      }
    }
    return text + "}";
  }

  Random& random_;
  std::string projection_ = "perspective";
  std::array<int, 2> cube_cells_{1, 6};
};

}  // namespace

std::string any_preset(Random& random) {
  return Writer(random).preset();
}

}  // namespace airlight::fuzz
