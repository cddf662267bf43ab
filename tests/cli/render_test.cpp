// render, luts, probe: the files they write and what they print.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>

#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

Start with_input(const std::string& text) {
  Start start;
  start.input = text;
  return start;
}

class Cli : public SmallSky {};

TEST_F(Cli, DefaultFilesGoToTheFolderOut) {
  const Outcome outcome = tool({"render", "sky.json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "out/sky.exr\nout/sky.png\n");
  EXPECT_EQ(scratch_.files(), (Names{"out/sky.exr", "out/sky.png", "sky.json"}));
  EXPECT_EQ(scratch_.read("out/sky.exr").substr(0, 4), "\x76\x2f\x31\x01");
  EXPECT_EQ(scratch_.read("out/sky.png").substr(1, 3), "PNG");
}

TEST_F(Cli, OnlyTheFilesAskedFor) {
  EXPECT_EQ(tool({"render", "sky.json", "-q", "-o", "a.exr"}).err, "");
  EXPECT_EQ(scratch_.files(), (Names{"a.exr", "sky.json"}));
  EXPECT_EQ(tool({"render", "sky.json", "-q", "--png", "b.png"}).err, "");
  EXPECT_EQ(scratch_.files(), (Names{"a.exr", "b.png", "sky.json"}));
}

TEST_F(Cli, AnExrRendersItselfAgain) {
  ASSERT_EQ(
      tool({"render", "sky.json", "-o", "a.exr", "--sun-elevation", "3", "--set", "/camera/pitch_deg=5"}).exit_code, 0);
  ASSERT_EQ(tool({"render", "a.exr", "-o", "b.exr"}).exit_code, 0);
  EXPECT_EQ(scratch_.read("a.exr"), scratch_.read("b.exr"));
  ASSERT_EQ(tool({"render", "sky.json", "-o", "c.exr"}).exit_code, 0);
  EXPECT_NE(scratch_.read("a.exr"), scratch_.read("c.exr"));
}

TEST_F(Cli, BuiltInPresetsAndStandardInput) {
  EXPECT_EQ(tool({"render", "earth-sunset", "--size", "16x9", "-o", "a.exr"}).exit_code, 0);
  const Outcome outcome = tool({"render", "-", "-o", "b.exr"}, with_input(small_preset()));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"a.exr", "b.exr", "sky.json"}));
}

TEST_F(Cli, EveryBuiltInPresetIsGoodAndDescribed) {
  const Outcome list = tool({"presets"});
  ASSERT_EQ(list.exit_code, 0) << list.err;
  std::size_t on_disk = 0;
  for (const auto& entry : std::filesystem::directory_iterator(AIRLIGHT_SOURCE_DIR "/presets")) {
    const bool is_list = entry.path().stem() == "chart";  // of presets
    on_disk += entry.path().extension() == ".json" && !is_list ? 1U : 0U;
  }
  const Names lines = lines_of(list.out);
  EXPECT_EQ(lines.size(), on_disk);
  for (const std::string& line : lines) {
    const std::string name = line.substr(0, line.find(' '));
    EXPECT_GT(line.size(), name.size() + 10) << "no description: " << line;
    const Outcome printed = tool({"presets", name});
    EXPECT_EQ(printed.exit_code, 0) << printed.err;
    const Outcome checked = tool({"check", "-"}, with_input(printed.out));
    EXPECT_EQ(checked.exit_code, 0) << name << ": " << checked.err;
  }
}

TEST_F(Cli, JsonTellsWhatWasDone) {
  const Outcome outcome = tool({"render", "sky.json", "-o", "a.exr", "--png", "a.png", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["files"], (Json{"a.exr", "a.png"}));
  EXPECT_EQ(json["method"], "orders");
  EXPECT_EQ(json["width"], 32);
  EXPECT_EQ(json["height"], 18);
  EXPECT_EQ(json["non_finite"], 0);
  EXPECT_EQ(json["negative"], 0);
  EXPECT_FALSE(json["device"].get<std::string>().empty());
  ASSERT_FALSE(json["passes"].empty());
  for (const Json& pass : json["passes"]) {
    EXPECT_FALSE(pass["name"].get<std::string>().empty());
    EXPECT_GE(pass["milliseconds"].get<double>(), 0.0);
  }
  ASSERT_FALSE(json["tables"].empty());
  EXPECT_EQ(json["tables"][0]["name"], "transmittance");
  EXPECT_EQ(json["tables"][0]["width"], 256);
  EXPECT_EQ(json["tables"][0]["height"], 64);
  EXPECT_GT(json["total"]["milliseconds"].get<double>(), 0.0);
}

TEST_F(Cli, TimingsNameEveryPartAndAddUp) {
  const Outcome outcome =
      tool({"render", "sky.json", "-o", "a.exr", "--png", "a.png", "--timings", "--json", "--no-cache"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  // The whole name of a row; the figures follow after at least two spaces.
  for (const char* name :
       {"process start", "preset and checks", "OCIO config", "render", "instance", "device", "pipelines",
        "pass transmittance", "pass sky", "submission and waiting", "readback", "EXR, encoding",
        "PNG, transform and encoding", "EXR, writing", "PNG, writing", "total", "peak resident MiB"}) {
    EXPECT_TRUE(std::regex_search(outcome.err, std::regex("\n *" + std::string(name) + "  +[0-9]")))
        << name << " is missing in\n"
        << outcome.err;
  }
  const Json json = Json::parse(outcome.out);
  double sum = 0.0;
  for (const Json& lap : json["laps"]) {
    sum += lap["milliseconds"].get<double>();
  }
  EXPECT_NEAR(sum, json["total"]["milliseconds"].get<double>(), 1e-6);
}

TEST_F(Cli, DryRunOpensNoDeviceAndWritesNothing) {
  // Without a driver a device could not be opened.
  const Outcome outcome = tool({"render", "sky.json", "--dry-run"}, without_driver());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* part : {"8 km", "degrees", "transmittance, 256x64 threads", "sky_orders"}) {
    EXPECT_TRUE(contains(outcome.out, part)) << outcome.out;
  }
  EXPECT_EQ(scratch_.files(), Names{"sky.json"});
}

TEST_F(Cli, NoVulkanDeviceNamesThePackage) {
  const Outcome outcome = tool({"render", "sky.json", "-o", "a.exr"}, without_driver());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(contains(outcome.err, "mesa-vulkan-drivers")) << outcome.err;
  EXPECT_EQ(scratch_.files(), Names{"sky.json"});
}

TEST_F(Cli, AnUnknownDeviceListsTheKnownOnes) {
  const Outcome outcome = tool({"render", "sky.json", "-o", "a.exr", "--device", "no-such-device"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "no-such-device")) << outcome.err;
  const std::string known = lines_of(tool({"devices"}).out).at(0);
  EXPECT_TRUE(contains(outcome.err, known)) << outcome.err;
}

TEST_F(Cli, ViewsAndBits) {
  const auto bit_depth = [&](const Names& options) {
    Names arguments = {"render", "sky.json", "-q", "--png", "v.png"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = tool(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return static_cast<int>(scratch_.read("v.png").at(24));  // IHDR: bit depth
  };
  EXPECT_EQ(bit_depth({}), 8);
  const std::string by_ocio = scratch_.read("v.png");
  EXPECT_EQ(bit_depth({"--bits", "16"}), 16);
  EXPECT_EQ(bit_depth({"--view", "gpu"}), 8);
  EXPECT_NE(scratch_.read("v.png"), by_ocio);
  EXPECT_EQ(bit_depth({"--view", "gpu", "--bits", "16"}), 16);
  EXPECT_EQ(bit_depth({"--view", "diagnostic"}), 8);
}

TEST_F(Cli, FloatExrHoldsMore) {
  ASSERT_EQ(tool({"render", "sky.json", "-q", "-o", "half.exr"}).exit_code, 0);
  ASSERT_EQ(tool({"render", "sky.json", "-q", "-o", "float.exr", "--float"}).exit_code, 0);
  EXPECT_NE(scratch_.read("half.exr"), scratch_.read("float.exr"));
}

TEST_F(Cli, ValuesTooLargeForHalfAreCountedInAWarning) {
  const Outcome outcome = tool({"render", "sky.json", "--half", "-o", "a.exr", "--set", "/sun/irradiance=1e7"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "warning: ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "65504")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "leave out --half")) << outcome.err;
}

// Too bright, too dark, and neither; whole and in tiles.
TEST_F(Cli, ThirtyTwoBitsComeWhereHalvesHoldLess) {
  for (const Names& tiles : {Names{}, Names{"--tile", "16x16"}}) {
    const auto format = [&](Names more) {
      Names words = {"render", "sky.json", "-o", "a.exr", "--json"};
      words.insert(words.end(), more.begin(), more.end());
      words.insert(words.end(), tiles.begin(), tiles.end());
      const Outcome outcome = tool(words);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      const std::string said = Json::parse(outcome.out)["exr"]["format"];
      EXPECT_EQ(contains(outcome.err, "note: the EXR has 32-bit floats"), said == "float") << outcome.err;
      return said;
    };
    EXPECT_EQ(format({}), "half");
    EXPECT_EQ(format({"--sun-elevation", "1"}), "half");
    EXPECT_EQ(format({"--sun-elevation", "-11"}), "float");
    EXPECT_EQ(format({"--sun-elevation", "-17"}), "float");
    EXPECT_EQ(format({"--set", "/sun/irradiance=1e7"}), "float");
    EXPECT_EQ(format({"--set", "/sun/irradiance=0"}), "half");  // black is black
    EXPECT_EQ(format({"--sun-elevation", "-17", "--half"}), "half");
  }
  const Outcome both = tool({"render", "sky.json", "--half", "--float", "-o", "b.exr"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_TRUE(contains(both.err, "--half and --float exclude each other")) << both.err;
  EXPECT_EQ(lines_of(both.err).size(), 1U);
}

TEST_F(Cli, LutsWritesEveryTableTwice) {
  const Outcome outcome = tool({"luts", "sky.json", "--method", "march", "-o", "tables"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json", "tables/multiple_scattering.exr", "tables/multiple_scattering.png",
                                     "tables/transmittance.exr", "tables/transmittance.png"}));
  for (const char* attribute : {"airlight:axis:x", "airlight:axis:y", "airlight:quantity"}) {
    EXPECT_TRUE(contains(scratch_.read("tables/transmittance.exr"), attribute)) << attribute;
  }
  ASSERT_EQ(tool({"render", "sky.json", "-q", "--method", "march", "-o", "a.exr", "--luts", "more"}).exit_code, 0);
  EXPECT_EQ(scratch_.read("more/transmittance.exr"), scratch_.read("tables/transmittance.exr"));
}

TEST_F(Cli, ProbeByOptionsAndByCsvAgree) {
  const Names pairs = {"probe", "sky.json",    "--json", "--elevation", "90", "--azimuth",
                       "0",     "--elevation", "12.5",   "--azimuth",   "200"};
  const Outcome by_options = tool(pairs);
  ASSERT_EQ(by_options.exit_code, 0) << by_options.err;
  const Json json = Json::parse(by_options.out);
  ASSERT_EQ(json["probes"].size(), 2U);
  const Json& zenith = json["probes"][0];
  EXPECT_EQ(zenith["elevation_deg"], 90);
  ASSERT_EQ(zenith["radiance"].size(), 3U);
  EXPECT_GT(zenith["radiance"][2].get<double>(), zenith["radiance"][0].get<double>());  // the sky is blue
  EXPECT_LT(zenith["transmittance"][2].get<double>(), zenith["transmittance"][0].get<double>());
  scratch_.write("d.csv", "elevation,azimuth\n# a comment\n90, 0\n\n12.5,200\n");
  EXPECT_EQ(tool({"probe", "sky.json", "--json", "--csv", "d.csv"}).out, by_options.out);
  EXPECT_EQ(tool({"probe", "sky.json", "--json", "--csv", "-"}, with_input("90,0\n12.5,200\n")).out, by_options.out);
  EXPECT_EQ(lines_of(tool({"probe", "sky.json", "--csv", "d.csv"}).out).size(), 3U);
}

TEST_F(Cli, ProbeTellsPolarisationWhereTheMethodDoes) {
  const Names zenith = {"probe", "sky.json", "-q", "--sun-elevation", "30", "--elevation", "60", "--azimuth", "180"};
  const auto probed = [&](const Names& more) {
    Names words = zenith;
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const Json light = Json::parse(probed({"--json"}))["probes"][0];
  const double i = light["radiance"][1].get<double>();
  const double q = light["stokes_q"][1].get<double>();
  const double u = light["stokes_u"][1].get<double>();
  EXPECT_NEAR(light["degree_of_polarisation"][1].get<double>(), std::hypot(q, u) / i, 1e-9);
  EXPECT_NEAR(light["angle_of_polarisation_deg"][1].get<double>(), std::atan2(u, q) * 90.0 / std::numbers::pi, 1e-9);
  EXPECT_GT(std::hypot(q, u), 0.1 * i);
  EXPECT_TRUE(contains(probed({}), "angle_deg R"));
  // Light is told before the filter.
  EXPECT_EQ(Json::parse(probed({"--json", "--set", "/camera/polariser={}"}))["probes"][0], light);
  EXPECT_FALSE(contains(probed({"--json", "--method", "march"}), "stokes_q"));
  EXPECT_FALSE(contains(probed({"--json", "--set", "/render/polarisation=false"}), "stokes_q"));
}

TEST_F(Cli, BadCsvNamesTheLine) {
  scratch_.write("d.csv", "90,0\n12.5;200\n");
  const Outcome outcome = tool({"probe", "sky.json", "--csv", "d.csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "d.csv:2")) << outcome.err;
}

}  // namespace
}  // namespace airlight::test
