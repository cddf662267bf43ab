// Users' errors: each is reported in one line that names it, with exit code 2 and nothing written.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

using WordList = std::vector<std::string>;

// Expects one line that contains all `parts`, and nothing on standard output.
void expect_refused(const Outcome& outcome, const WordList& parts) {
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "") << outcome.err;
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("airlight: ", 0), 0U) << outcome.err;
  for (const std::string& part : parts) {
    EXPECT_TRUE(contains(outcome.err, part)) << "expected '" << part << "' in: " << outcome.err;
  }
}

struct BadArguments {
  WordList arguments;
  WordList parts;  // of the one line
};

const std::vector<BadArguments>& bad_arguments() {
  static const std::vector<BadArguments> rows = {
      {{"rendr", "x"}, {"unknown command 'rendr'", "did you mean 'render'?"}},
      {{"render"}, {"render: no PRESET given", "airlight render [options] PRESET"}},
      {{"render", "a", "b"}, {"unexpected argument 'b'"}},
      {{"render", "--sze", "8x8", "a"}, {"unknown option '--sze'", "did you mean '--size'?", "render --help"}},
      {{"render", "a", "-z"}, {"unknown option '-z'"}},
      {{"render", "a", "--png"}, {"'--png' needs a value", "FILE.png"}},
      {{"render", "a", "--png="}, {"'--png' needs a value", "FILE.png"}},
      {{"render", "a", "--png", "--json"}, {"'--png' needs a value", "'--json' follows"}},
      {{"render", "a", "--json=yes"}, {"'--json' takes no value"}},
      {{"render", "a", "--bits", "9"}, {"--bits: '9' is not one of 8, 16"}},
      {{"render", "a", "--sun-elevation", "high"}, {"--sun-elevation: 'high' is not a number"}},
      {{"render", "earth-noon", "--sun-elevation", "91"}, {"/sun/elevation_deg", "91", "-90 to 90"}},
      {{"render", "earth-noon", "--size", "12"}, {"--size: '12' is not WIDTHxHEIGHT"}},
      {{"render", "earth-noon", "--size", "12x"}, {"--size: '12x' is not WIDTHxHEIGHT"}},
      {{"render", "earth-noon", "--size", "0x8"}, {"/image/width", "0", "1 to 65536"}},
      {{"render", "earth-noon", "--method", "marsh"}, {"marsh", "march"}},
      {{"render", "earth-noon", "--set", "camera=1"}, {"camera", "not a JSON pointer"}},
      {{"render", "earth-noon", "--set", "/clouds/0/cover=0.3"},
       {"--set /clouds/0/cover=0.3: /clouds: the preset has none, so there is no element \"0\"", "/clouds=[...]"}},
      {{"render", "earth-noon", "--checkpoint", "state"}, {"--checkpoint", "orders takes none", "path-trace"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--checkpoint", "state"}, {"--checkpoint", "--tolerance"}},
      {{"render", "earth-noon", "--set", "/camera/pich_deg=1"}, {"/camera/pich_deg", "pitch_deg"}},
      {{"render", "earth-non"}, {"no preset 'earth-non'", "did you mean 'earth-noon'?"}},
      {{"render", "nowhere.json"}, {"nowhere.json", "No such file"}},
      {{"render", "earth-noon", "-o", "sky.jpg"}, {"'sky.jpg' does not end in .exr"}},
      {{"render", "earth-noon", "--png", "sky.exr"}, {"'sky.exr' does not end in .png"}},
      {{"render", "earth-noon", "-o", "nowhere/sky.exr"}, {"nowhere/sky.exr", "does not exist", "mkdir -p"}},
      {{"render", "earth-noon", "-o", "sky.exr", "--luts", "no/where"}, {"does not exist", "mkdir -p"}},
      {{"render", "earth-noon", "--png", "a.png", "--view", "filmic"},
       {"'filmic' is not in ", "config. Choose one of 'ACES"}},
      {{"render", "earth-noon", "--png", "a.png", "--ocio-config", "none.ocio"}, {"none.ocio"}},
      {{"luts", "earth-noon"}, {"no folder given", "-o DIR"}},
      {{"stability"}, {"no folder given", "-o DIR"}},
      {{"stability", "-o", "no/where"}, {"no/where", "does not exist", "mkdir -p"}},
      {{"stability", "-o", "map", "--quick", "--full"}, {"exclude each other"}},
      {{"stability", "-o", "map", "--sweep", "sun"}, {"'sun' is not one of sun-altitude"}},
      {{"probe", "earth-noon"}, {"no direction given"}},
      {{"probe", "earth-noon", "--elevation", "1"}, {"1 elevations but 0 azimuths", "in pairs"}},
      {{"probe", "earth-noon", "--elevation", "91", "--azimuth", "0"}, {"'91' is not a number from -90 to 90"}},
      {{"probe", "earth-noon", "--csv", "none.csv"}, {"none.csv"}},
      {{"presets", "earth-non"}, {"no built-in preset 'earth-non'", "did you mean 'earth-noon'?"}},
      {{"render", "earth-noon", "--tolerance", "much"}, {"--tolerance: 'much' is not a percentage", "0.5%"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--time-limit", "1s"}, {"exclude each other"}},
      {{"render", "earth-noon", "--judge-time", "60s"}, {"--judge-time is for --tolerance"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--judge-time", "0s"}, {"--judge-time: ", "60s"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--judge-time", "60"}, {"--judge-time: '60' has no unit", "60s"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--set", "/render/steps=8"}, {"leave out --set /render/steps=8"}},
      {{"render", "earth-noon", "--tolerance", "1%", "--method", "path-trace"}, {"--target-error"}},
      {{"render", "lesson26", "--tolerance", "1%"}, {"departs by /render/sun_fade"}},
      {{"render", "earth-noon", "--time-limit", "5 parsec"}, {"--time-limit: '5 parsec' is no time", "50ms"}},
      {{"render", "earth-noon", "--time-limit", "0"}, {"'0' has no unit"}},
      {{"chart"}, {"no folder given", "-o DIR"}},
      {{"chart", "-o", "c", "--method", "marsh"}, {"no method 'marsh'", "did you mean 'march'?"}},
      {{"chart", "earth-noon", "earth-noon", "-o", "c"}, {"'earth-noon' is named twice"}},
      {{"chart", "earth-non", "-o", "c"}, {"no preset 'earth-non'"}},
      {{"chart", "-o", "no/where"}, {"does not exist"}},
      {{"chart", "-o", "c", "--truth-error", "0"}, {"--truth-error: '0' is not a percentage"}},
      {{"chart", "-o", "c", "--budget", "0"}, {"--budget"}},
      {{"completion", "tcsh"}, {"'tcsh' is not one of bash, zsh, fish"}},
      {{"--versoin"}, {"unknown option '--versoin'", "did you mean '--version'?"}},
      // The message names the option as typed.
      {{"render", "earth-noon", "--pitch", "91"}, {"--pitch 91: /camera/pitch_deg", "-90 to 90 degrees"}},
      {{"render", "earth-noon", "--fov", "180"}, {"--fov 180: /camera/vertical_fov_deg", "fisheye"}},
      {{"render", "earth-noon", "--altitude", "-1"}, {"--altitude -1: /camera/altitude_km", "inside the planet"}},
      {{"render", "earth-noon", "--azimuth", "inf"}, {"--azimuth: 'inf' is not a number"}},
      {{"render", "earth-noon", "--projection", "latlon"}, {"--projection: 'latlon'", "did you mean 'latlong'?"}},
      {{"render", "earth-noon", "--projection", "latlong", "--pitch", "5"}, {"--pitch 5: ", "cannot be tilted"}},
      {{"render", "earth-noon", "--projection", "cube", "--size", "9x9"}, {"--size 9x9: /image", "1 x 6 square faces"}},
      {{"render", "earth-noon", "--size", "70000x8"}, {"--size 70000x8: /image/width", "1 to 65536"}},
      // Places and times.
      {{"render", "earth", "--date", "2026-06-21"}, {"needs --time, --lat, --lon as well"}},
      {{"render", "earth", "--lat", "91"}, {"--lat: '91' is not a number from -90 to 90"}},
      {{"render", "earth", "--date", "2026-02-30", "--time", "12:00", "--lat", "0", "--lon", "0"},
       {"--date", "2026-02-30"}},
      {{"render", "earth", "--date", "2026-06-21", "--time", "noon", "--lat", "0", "--lon", "0"}, {"--time", "'noon'"}},
      {{"render", "earth", "--date", "2026-06-21", "--time", "9:00", "--lat", "0", "--lon", "0", "--tz", "Europe/Pari"},
       {"--tz: no time zone 'Europe/Pari'", "did you mean 'Europe/Paris'?"}},
      {{"render", "earth", "--date", "2026-06-21", "--time", "9:00", "--lat", "0", "--lon", "0", "--sun-azimuth", "9"},
       {"--sun-azimuth and --date both"}},
      {{"render", "earth", "--pressure", "900"}, {"--pressure", "belong to --refraction"}},
      {{"render", "setting-sun", "--date", "2026-06-21", "--time", "9:00", "--lat", "0", "--lon", "0", "--refraction"},
       {"--refraction", "bends light itself"}},
      {{"sequence", "setting-sun", "-o", "a.#.exr", "--date", "2026-06-21", "--from", "1:00", "--to", "2:00", "--step",
        "1h", "--lat", "0", "--lon", "0", "--refraction"},
       {"--refraction", "bends light itself"}},
      {{"sequence", "earth", "-o", "a.#.exr", "--date", "2026-06-21", "--from", "1:00", "--to", "2:00", "--step", "1h",
        "--lat", "0", "--lon", "0", "--tz", "Mars/Olympus"},
       {"--tz: no time zone 'Mars/Olympus'"}},
      {{"render", "earth", "--date", "2026-06-21", "--time", "9:00", "--lat", "0", "--lon", "0", "--tz", "Nowhere"},
       {"--tz: no time zone 'Nowhere'. Write a name such as"}},
      // Limits.
      {{"render", "earth-noon", "--method", "path-trace", "--samples", "2000000000"}, {"--samples: ", "1 to 1e9"}},
      {{"render", "earth-noon", "--tolerance", "101%"}, {"--tolerance: '101%'", "to 100%"}},
      {{"render", "earth-noon", "--tolerance", "5"}, {"--tolerance: '5' is not a percentage", "0.5%"}},
      {{"render", "earth-noon", "--tolerance", "0"}, {"--tolerance: '0' is not a percentage"}},
      {{"render", "earth-noon", "--time-limit", "50"}, {"--time-limit: '50' has no unit; write 50s, 50ms or 50min"}},
      {{"render", "earth-noon", "--time-limit", "0s"}, {"nothing is rendered in no time"}},
      {{"diff", "a.exr", "b.exr", "--rel-mean", "-1%"}, {"--rel-mean: '-1%'", "at least 0%"}},
      {{"diff", "a.exr", "b.exr", "--failpercent", "101%"}, {"--failpercent: '101%'", "0 to 100"}},
      {{"render", "mountain-clouds", "--layers", "-o", "a.exr"}, {"--layers: ", "where no terrain"}},
      {{"render", "earth-noon", "--size", "4x4", "--device", "none such"},
       {"no Vulkan device is named \"none such\"; there are: "}},
      {{"stability", "-o", "map", "--quick", "--device", "none such"}, {"no Vulkan device is named"}},
      // Files.
      {{"render", "earth-noon", "-o", "a.png", "--png", "b.png"}, {"-o a.png and --png b.png", "-o is for the EXR"}},
      {{"render", "earth-noon", "-o", "-", "--png", "-"}, {"-o -", "standard output too"}},
      {{"render", "earth-noon", "-o", "-", "--json"}, {"-o -", "--json writes to standard output too"}},
      {{"render", "/dev/null"}, {"/dev/null", "empty; expected a JSON object"}},
      {{"render", "."}, {".", "is a directory"}},
      {{"help", "rendr"}, {"no command 'rendr'", "did you mean 'render'?"}},
  };
  return rows;
}

TEST(BadInput, ArgumentsAreOneLineAndExitCodeTwo) {
  const Scratch scratch;
  for (const BadArguments& row : bad_arguments()) {
    expect_refused(airlight(scratch.path(), row.arguments), row.parts);
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));  // no folder either
}

struct BadPreset {
  std::string text;
  WordList parts;
};

// A preset that is valid except for `extra`.
std::string preset_with(const std::string& extra) {
  return R"({"airlight": 1, "extends": "earth", )" + extra + "}";
}

TEST(BadInput, PresetsAreOneLineAndExitCodeTwo) {
  const std::vector<BadPreset> rows = {
      {"", {"empty; expected a JSON object"}},
      {"[]", {"not an object"}},
      {"{\"airlight\": 1,}", {":1:16: not JSON"}},
      {R"({"airlight": 1})", {"/media: missing", "\"extends\": \"earth\""}},
      {R"({"airlight": 2, "extends": "earth"})", {"/airlight: 2 is no format"}},
      {R"({"airlight": 1, "extends": "erth"})", {"/extends: \"erth\"", "did you mean \"earth\"?"}},
      {R"({"airlight": 1, "extends": "air/earth.json"})", {"/extends", "air/earth.json: No such file"}},
      {R"({"airlight": 1, "extends": "preset.json"})", {"makes a circle"}},
      {R"({"$schema": 1, "airlight": 1, "extends": "earth"})", {"/$schema: 1 is not a string"}},
      {preset_with(R"("sun": {"elevation_deg": 100})"), {"/sun/elevation_deg: 100 is outside -90 to 90 degrees"}},
      {preset_with(R"("sun": {"elevation_deg": "low"})"), {"/sun/elevation_deg: \"low\" is not a number"}},
      {preset_with(R"("sun": {"elevation_deg": 1, "elevation_deg": 2})"), {"elevation_deg"}},
      {preset_with(R"("sun": {"elevaton_deg": 1})"), {"unknown key; did you mean \"elevation_deg\"?"}},
      {preset_with(R"("elevation_deg": 1)"), {"did you mean sun.elevation_deg?"}},
      {preset_with(R"("camera": {"altitude_km": -1})"), {"/camera/altitude_km", "inside the planet"}},
      {preset_with(R"("camera": {"projection": "fish-eye"})"), {"/camera/projection: \"fish-eye\" is unknown"}},
      {preset_with(R"("camera": null)"), {"/camera: null is not an object"}},
      {preset_with(R"("image": {"width": 0})"), {"/image/width: 0", "1 to 65536"}},
      {preset_with(R"("image": {"width": 1.5})"), {"/image/width: 1.5", "whole number"}},
      {preset_with(R"("render": {"method": "marsh"})"), {"/render/method", "marsh"}},
      {preset_with(R"("render": {"stpes": 9})"), {"/render/stpes: unknown key"}},
      {preset_with(R"("media": [{"name": "x"}])"), {"/media/"}},
      {preset_with(R"("planet": {"ground_albedo": [1, 2]})"), {"/planet/ground_albedo"}},
      {preset_with(R"("media": {"name": "x"})"), {"/media", "no list of media"}},
      {preset_with(R"("planet": {"radius_km": 1e400})"), {"1e400"}},
      {preset_with(R"("display": {"exposure": "bright"})"), {"/display/exposure"}},
      {preset_with(R"("sequence": {"frames": []})"), {"/sequence/frames"}},
      // What the method cannot render.
      {preset_with("\n"
                   R"("clouds": [{"type": "layer", "optical_depth": 1}, {"type": "cumulus", "base_km": 3, "top_km": 4},
       {"type": "cumulus",
        "base_km": 2.5, "top_km": 3.5}, {"type": "cumulus", "cover": 0, "base_km": 1, "top_km": 9}])"),
       {":2: /clouds/1/base_km: ", "from 3 to 4 km begins below the top of the one from 2.5 to 3.5", "path-trace"}},
  };
  const Scratch scratch;
  for (const BadPreset& row : rows) {
    scratch.write("preset.json", row.text);
    SCOPED_TRACE(row.text);
    WordList parts = row.parts;
    parts.emplace_back("preset.json");  // and where
    expect_refused(airlight(scratch.path(), {"render", "preset.json"}), parts);
    expect_refused(airlight(scratch.path(), {"check", "preset.json"}), parts);
  }
  EXPECT_EQ(scratch.files(), WordList{"preset.json"});
}

}  // namespace
}  // namespace airlight::test
