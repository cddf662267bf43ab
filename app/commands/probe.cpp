#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>

#include "app/cli/json_writer.h"
#include "app/cli/scene_options.h"
#include "app/cli/terminal.h"
#include "app/commands/commands.h"
#include "core/base/error.h"
#include "core/base/polarisation.h"
#include "core/base/text.h"
#include "core/library/validity.h"
#include "core/library/wavelengths.h"
#include "core/methods/ready.h"
#include "core/render/spectrum.h"
#include "core/scene/angle.h"
#include "core/scene/named_file.h"
#include "core/scene/photometry.h"

namespace airlight::cli {
namespace {

struct ProbeGiven {
  SceneOptions scene;
  std::vector<double> elevations;
  std::vector<double> azimuths;
  std::string csv;
  std::optional<std::string> spectrum;
  bool json = false;
  bool quiet = false;
};

struct ListedDirection {
  double elevation_deg = 0.0;
  double azimuth_deg = 0.0;
};

std::optional<double> stripped_number(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
  return number_from<double>(text);
}

// ELEVATION,AZIMUTH in degrees, a direction a line; empty lines, comments (#) and one line of headings are skipped.
std::vector<ListedDirection> read_csv(std::istream& in, const std::string& name) {
  std::vector<ListedDirection> directions;
  std::string line;
  for (int at = 1; std::getline(in, line); ++at) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') {
      continue;
    }
    const std::vector<std::string> cells = split(line, ',');
    const std::optional<double> e = stripped_number(cells.front());
    const std::optional<double> a = stripped_number(cells.size() > 1 ? cells[1] : std::string());
    const bool heading = !e && !a && directions.empty();
    if (heading) {
      continue;
    }
    const bool more = cells.size() > 3 || (cells.size() == 3 && !cells.back().empty());
    if (!e || !a || more) {
      throw InputError(name + ":" + std::to_string(at) + ": '" + line +
                       "' is not ELEVATION,AZIMUTH; write two numbers in degrees, such as 12.5,90");
    }
    directions.push_back({*e, *a});
  }
  if (directions.empty()) {
    throw InputError(name + ": holds no direction; write ELEVATION,AZIMUTH in degrees, one direction a line");
  }
  return directions;
}

std::vector<ListedDirection> directions_of(const ProbeGiven& given) {
  if (!given.csv.empty()) {
    if (!given.elevations.empty() || !given.azimuths.empty()) {
      throw InputError("probe: --csv and --elevation, --azimuth exclude each other; give one or the other");
    }
    if (given.csv == "-") {
      return read_csv(std::cin, "standard input");
    }
    const NamedText named = read_named_text(given.csv);
    if (!named.problem.empty()) {
      throw InputError(given.csv + ": cannot be read: " + named.problem +
                       "; --csv needs a file of ELEVATION,AZIMUTH lines, or - for standard input");
    }
    std::istringstream lines(named.text);
    return read_csv(lines, given.csv);
  }
  if (given.elevations.size() != given.azimuths.size()) {
    throw InputError("probe: " + std::to_string(given.elevations.size()) + " elevations but " +
                     std::to_string(given.azimuths.size()) + " azimuths; give --elevation and --azimuth in pairs");
  }
  if (given.elevations.empty()) {
    throw InputError("probe: no direction given; write --elevation DEG --azimuth DEG, or --csv FILE");
  }
  std::vector<ListedDirection> directions;
  for (std::size_t i = 0; i < given.elevations.size(); ++i) {
    directions.push_back({given.elevations[i], given.azimuths[i]});
  }
  return directions;
}

void check_directions(const std::vector<ListedDirection>& directions) {
  for (const ListedDirection& direction : directions) {
    if (!(std::abs(direction.elevation_deg) <= 90.0) || !std::isfinite(direction.azimuth_deg)) {
      throw InputError("probe: elevation " + std::to_string(direction.elevation_deg) + ", azimuth " +
                       std::to_string(direction.azimuth_deg) +
                       " is no direction; elevation must be from -90 to 90 degrees and azimuth a number");
    }
  }
}

// cd/m2; none where the preset's sun has no absolute unit.
std::optional<double> luminance_of(const Scene& scene, const ProbeResult& result) {
  const std::optional<double> white = white_luminance(scene.sun.unit);
  return white ? std::optional(*white * bt709_luminance(result.radiance)) : std::nullopt;
}

// Writes Q, U, the degree and the angle that they stand for.
template <class Values>
void add_polarisation(JsonWriter& json, const Values& i, const Values& q, const Values& u) {
  std::vector<double> degrees;
  std::vector<double> angles;
  for (std::size_t k = 0; k < i.size(); ++k) {
    const Polarisation found = polarisation_of(i[k], q[k], u[k]);
    degrees.push_back(found.degree);
    angles.push_back(found.angle_deg);
  }
  json.key("stokes_q").values(q).key("stokes_u").values(u);
  json.key("degree_of_polarisation").values(degrees).key("angle_of_polarisation_deg").values(angles);
}

std::string as_json(const Scene& scene, const std::vector<ListedDirection>& listed,
                    const std::vector<ProbeResult>& results) {
  JsonWriter json;
  json.begin_object().key("radiance_unit").value(radiance_unit(scene.sun.unit)).key("probes").begin_array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    json.begin_object();
    json.key("elevation_deg").value(listed[i].elevation_deg).key("azimuth_deg").value(listed[i].azimuth_deg);
    json.key("radiance").values(results[i].radiance);
    if (const std::optional<double> luminance = luminance_of(scene, results[i])) {
      json.key("luminance_cd_per_m2").value(*luminance);
    }
    json.key("transmittance").values(results[i].transmittance);
    if (results[i].q && results[i].u) {
      add_polarisation(json, results[i].radiance, *results[i].q, *results[i].u);
    }
    json.end_object();
  }
  return json.end_array().end_object().take();
}

std::string polarisation_text(const std::array<double, 3>& i, const std::array<double, 3>& q,
                              const std::array<double, 3>& u) {
  std::array<Polarisation, 3> found;
  for (std::size_t c = 0; c < 3; ++c) {
    found[c] = polarisation_of(i[c], q[c], u[c]);
  }
  char line[160];
  std::snprintf(line, sizeof line, " %12.4f %6.4f %6.4f %12.2f %7.2f %7.2f", found[0].degree, found[1].degree,
                found[2].degree, found[0].angle_deg, found[1].angle_deg, found[2].angle_deg);
  return line;
}

std::string as_text(const Scene& scene, const std::vector<ListedDirection>& listed,
                    const std::vector<ProbeResult>& results) {
  std::string text = "elevation_deg azimuth_deg     radiance R           G           B  transmittance R    G        B";
  text += white_luminance(scene.sun.unit) ? "  luminance cd/m2" : "";
  text += results.front().q ? "  polarised R      G      B  angle_deg R       G       B\n" : "\n";
  for (std::size_t i = 0; i < results.size(); ++i) {
    char line[160];
    const auto& l = results[i].radiance;
    const auto& t = results[i].transmittance;
    std::snprintf(line, sizeof line, "%13.4f %11.4f %14.6e %11.6e %11.6e %13.6f %8.6f %8.6f", listed[i].elevation_deg,
                  listed[i].azimuth_deg, l[0], l[1], l[2], t[0], t[1], t[2]);
    text += line;
    if (const std::optional<double> luminance = luminance_of(scene, results[i])) {
      std::snprintf(line, sizeof line, " %16.6g", *luminance);
      text += line;
    }
    if (results[i].q && results[i].u) {
      text += polarisation_text(l, *results[i].q, *results[i].u);
    }
    text += "\n";
  }
  return text;
}

std::string as_json(const std::vector<ListedDirection>& listed, const SpectralProbes& results) {
  const SpectralImage& at = results.wavelengths;
  JsonWriter json;
  json.begin_object().key("radiance_unit").value(at.unit).key("wavelengths_nm").values(at.nm);
  json.key("sunlight").values(at.sunlight).key("probes").begin_array();
  for (std::size_t i = 0; i < listed.size(); ++i) {
    json.begin_object();
    json.key("elevation_deg").value(listed[i].elevation_deg).key("azimuth_deg").value(listed[i].azimuth_deg);
    json.key("radiance").values(results.directions[i].radiance);
    json.key("transmittance").values(results.directions[i].transmittance);
    if (!results.directions[i].q.empty()) {
      add_polarisation(json, results.directions[i].radiance, results.directions[i].q, results.directions[i].u);
    }
    json.end_object();
  }
  return json.end_array().end_object().take();
}

std::string as_text(const std::vector<ListedDirection>& listed, const SpectralProbes& results) {
  const SpectralImage& at = results.wavelengths;
  const bool polarised = !results.directions.front().q.empty();
  std::string text = "elevation_deg azimuth_deg wavelength_nm       radiance transmittance       sunlight";
  text += polarised ? " polarised angle_deg\n" : "\n";
  for (std::size_t i = 0; i < listed.size(); ++i) {
    for (std::size_t k = 0; k < at.nm.size(); ++k) {
      char line[160];
      const SpectralProbe& found = results.directions[i];
      std::snprintf(line, sizeof line, "%13.4f %11.4f %13.4f %14.6e %13.6f %14.6e", listed[i].elevation_deg,
                    listed[i].azimuth_deg, at.nm[k], found.radiance[k], found.transmittance[k], at.sunlight[k]);
      text += line;
      if (polarised) {
        const Polarisation light = polarisation_of(found.radiance[k], found.q[k], found.u[k]);
        std::snprintf(line, sizeof line, " %9.4f %9.2f", light.degree, light.angle_deg);
        text += line;
      }
      text += "\n";
    }
  }
  return text + "# radiance in " + at.unit + ", sunlight above the air in that times sr\n";
}

[[noreturn]] void refuse_value(const ListedDirection& at, double value) {
  throw RunError("probe: the result at elevation " + std::to_string(at.elevation_deg) + ", azimuth " +
                 std::to_string(at.azimuth_deg) + " holds " + std::to_string(value) +
                 "; this is a mistake in airlight, please report it with the preset");
}

void require_finite(const ListedDirection& at, std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) {
      refuse_value(at, value);
    }
  }
}

void require_sound(const std::vector<ListedDirection>& listed, const SpectralProbes& results) {
  for (std::size_t i = 0; i < listed.size(); ++i) {
    for (const auto* values : {&results.directions[i].radiance, &results.directions[i].transmittance}) {
      for (const double value : *values) {
        if (!std::isfinite(value) || value < 0.0) {
          refuse_value(listed[i], value);
        }
      }
    }
    require_finite(listed[i], results.directions[i].q);
    require_finite(listed[i], results.directions[i].u);
  }
}

// Throws on unsound values. With spectra a colour may have a negative channel, but no negative luminance.
void require_sound(const std::vector<ListedDirection>& listed, const std::vector<ProbeResult>& results,
                   bool signed_colours) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const auto* triple : {&results[i].radiance, &results[i].transmittance}) {
      for (const double value : *triple) {
        const double judged = signed_colours ? bt709_luminance(*triple) : value;
        if (!std::isfinite(value) || judged < 0.0) {
          refuse_value(listed[i], value);
        }
      }
    }
    if (results[i].q && results[i].u) {
      require_finite(listed[i], *results[i].q);
      require_finite(listed[i], *results[i].u);
    }
  }
}

void tell_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    complain("warning: " + warning);
  }
}

int print_spectra(const ProbeGiven& given, const Stage& stage, const std::vector<ListedDirection>& listed,
                  const std::vector<Direction>& directions, const Nodes& nodes) {
  std::unique_ptr<Executor> executor;
  const SpectralProbes results = probe_spectrum(device_on_demand(given.scene, executor), stage, directions, nodes);
  require_valid_vulkan();
  require_sound(listed, results);
  if (!given.quiet) {
    tell_warnings(results.undone);
  }
  print(given.json ? as_json(listed, results) : as_text(listed, results));
  return 0;
}

int run_probe(const ProbeGiven& given) {
  const Stage stage = ready(load_scene(given.scene));
  const Scene& scene = stage.scene();
  std::optional<Nodes> nodes;
  if (given.spectrum) {
    nodes = wavelengths_from(*given.spectrum, "probe: --spectrum");
    require_spectra(scene, "probe: --spectrum");
  }
  const std::vector<ListedDirection> listed = directions_of(given);
  check_directions(listed);
  if (!given.quiet) {
    tell_warnings(scene_warnings(stage));
  }
  std::vector<Direction> directions;
  directions.reserve(listed.size());
  for (const ListedDirection& direction : listed) {
    directions.push_back({radians_from_degrees(direction.elevation_deg), radians_from_degrees(direction.azimuth_deg)});
  }
  if (nodes) {
    return print_spectra(given, stage, listed, directions, *nodes);
  }
  std::unique_ptr<Executor> executor;
  const ProbeResults results = probe(device_on_demand(given.scene, executor), stage, directions);
  require_valid_vulkan();
  require_sound(listed, results.directions, stage.in_colours());
  if (!given.quiet) {
    tell_warnings(results.undone);
  }
  print(given.json ? as_json(scene, listed, results.directions) : as_text(scene, listed, results.directions));
  return 0;
}

}  // namespace

Command probe_command() {
  const auto given = std::make_shared<ProbeGiven>();
  Command command;
  command.name = "probe";
  command.summary = "Print radiance and transmittance in given directions, as seen from the camera's place";
  command.description =
      "airlight prints the light of the sky, and of the ground where the direction meets it. The sun's disc is left "
      "out. Transmittance is that of the air along the direction, to the ground or to space.\n\n"
      "If the preset's sun.unit is W/m2 or lux, airlight also prints the luminance in cd/m2.\n\n"
      "By the method orders airlight prints, for each channel, the share of the light that is polarised, and the angle "
      "between its swing and the plane of direction and zenith, from -90 to 90 degrees. Angles above 0 lean from "
      "downward toward growing azimuth. --json adds the Stokes parameters Q and U: Q is above 0 for light that swings "
      "in that plane, U for light that leans by 45 degrees. Light arrives as told, before any camera.polariser.\n\n"
      "--spectrum needs a preset that has spectra. It prints one line for each wavelength: spectral radiance, "
      "transmittance, and the sunlight above the air. Each value is the mean over a band around the wavelength. The "
      "band is as wide as the step, and at most 10 nm. The last line says the unit. 'airlight render --help' explains "
      "the unit under --spectral.";
  command.examples = {
      {"airlight probe earth-noon --elevation 90 --azimuth 0", "The zenith"},
      {"airlight probe earth-noon --elevation 10 --azimuth 0 --elevation 10 --azimuth 180 --json",
       "Two directions, as JSON"},
      {"airlight probe earth-physical --elevation 90 --azimuth 0", "The zenith in cd/m2"},
      {"airlight probe earth --elevation 90 --azimuth 0 --spectrum 400:700:50",
       "The spectrum of the zenith, every 50 nm; --spectrum alone means every 10 nm from 380 to 780"},
      {"airlight probe earth-sunset --elevation 60 --azimuth 0 --json", "With the Stokes parameters Q and U"},
      {"airlight probe earth-noon --csv directions.csv", "Directions from a file with ELEVATION,AZIMUTH on each line"}};
  command.positionals = {preset_positional(given->scene)};
  command.options = {
      {"--elevation", "DEG", "Angle of a direction above the horizon", &given->elevations, Completes::nothing,
       Range{-90.0, 90.0}},
      {"--azimuth", "DEG", "Azimuth of the same direction, clockwise from north", &given->azimuths},
      {"--csv", "FILE", "Read directions from this file, with ELEVATION,AZIMUTH on each line; - for standard input",
       &given->csv, Completes::file},
      {.names = "--spectrum",
       .metavar = "[FIRST:LAST:STEP]",
       .help = std::string("Print spectra at these wavelengths in nm; --spectrum alone means ") + kUsualWavelengths,
       .target = &given->spectrum,
       .implied = kUsualWavelengths}};
  append(command.options, scene_options(given->scene));
  command.options.push_back({"--json", "", "Print JSON", &given->json});
  command.options.push_back({"-q,--quiet", "", "Print no warnings", &given->quiet});
  command.run = [given] { return run_probe(*given); };
  return command;
}

}  // namespace airlight::cli
