// The words that people try first: names of files and pipes, projections, places, percentages; --json for programs.
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/output/provenance.h"
#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

class Words : public SmallSky {
 protected:
  Json dry_run(Names arguments) const {
    arguments.insert(arguments.begin(), {"render", "--dry-run", "--json"});
    const Outcome outcome = tool(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out, nullptr, false);
  }
};

TEST_F(Words, AMapIsUprightAndOfASizeThatSuits) {
  Json latlong = dry_run({"sky.json", "--projection", "latlong"});
  EXPECT_EQ(latlong["preset"]["camera"]["projection"], "equirectangular");
  EXPECT_EQ(latlong["preset"]["camera"]["pitch_deg"], 0);
  EXPECT_EQ(latlong["width"], 32);
  EXPECT_EQ(latlong["height"], 16);
  EXPECT_EQ(dry_run({"sky.json", "--projection", "latlong", "--size", "20x16"})["width"], 20);
  const Json cube = dry_run({"sky.json", "--projection", "cube"});
  EXPECT_EQ(cube["width"], 8);
  EXPECT_EQ(cube["height"], 48);
  EXPECT_EQ(dry_run({"sky.json", "--projection", "octahedral"})["height"], 16);
}

TEST_F(Words, AnotherProjectionLeavesTheFieldOfView) {
  scratch_.write("narrow.json", R"({"airlight": 1, "extends": "sky.json", "camera": {"vertical_fov_deg": 20}})");
  const auto fov = [&](const Names& arguments) { return dry_run(arguments)["preset"]["camera"]["vertical_fov_deg"]; };
  EXPECT_EQ(fov({"narrow.json", "--projection", "perspective"}), 20);
  EXPECT_EQ(fov({"narrow.json", "--projection", "fisheye"}), 180);
  EXPECT_EQ(fov({"narrow.json", "--projection", "fisheye", "--fov", "90"}), 90);
}

TEST_F(Words, TheCameraByOptions) {
  const Json camera =
      dry_run({"sky.json", "--azimuth", "-20", "--pitch", "5", "--altitude", "12", "--fov", "30"})["preset"]["camera"];
  EXPECT_EQ(camera["azimuth_deg"], -20);
  EXPECT_EQ(camera["pitch_deg"], 5);
  EXPECT_EQ(camera["altitude_km"], 12);
  EXPECT_EQ(camera["vertical_fov_deg"], 30);
}

// An equirectangular picture is tagged as OpenEXR's latlong if it is twice as wide as high; otherwise a message says
// so.
TEST_F(Words, OnlyTwoToOneIsTaggedAsALatlong) {
  const Outcome good = tool({"render", "sky.json", "--projection", "latlong", "-o", "good.exr"});
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_FALSE(contains(good.err, "not tagged")) << good.err;
  EXPECT_TRUE(contains(scratch_.read("good.exr"), "envmap"));
  const Outcome odd = tool({"render", "sky.json", "--projection", "latlong", "--size", "20x16", "-o", "odd.exr"});
  EXPECT_EQ(odd.exit_code, 0);
  EXPECT_TRUE(contains(odd.err, "20x16 is not twice as wide as high")) << odd.err;
  EXPECT_FALSE(contains(scratch_.read("odd.exr"), "envmap"));
}

// By the almanac, at Greenwich on the equinox of 2026 (20 March, 14:46 UTC) the sun stands over the equator; at noon of
// mean time it is 7.5 minutes before the meridian.
TEST_F(Words, TheSunOfAPlace) {
  const Json sun = dry_run(
      {"sky.json", "--date", "2026-03-20", "--time", "12:00", "--lat", "51.4779", "--lon", "0"})["preset"]["sun"];
  EXPECT_NEAR(sun["elevation_deg"].get<double>(), 90.0 - 51.4779, 0.15);
  EXPECT_NEAR(sun["azimuth_deg"].get<double>(), 180.0 - 7.5 / 4.0 / std::sin(51.4779 * M_PI / 180.0), 0.15);
  // The same moment on another clock.
  EXPECT_EQ(dry_run({"sky.json", "--date", "2026-03-20", "--time", "13:00", "--lat", "51.4779", "--lon", "0", "--tz",
                     "Europe/Paris"})["preset"]["sun"],
            sun);
}

TEST_F(Words, ANameInPngAfterOIsThePng) {
  const Outcome outcome = tool({"render", "sky.json", "-o", "a.png"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"a.png", "sky.json"}));
  EXPECT_EQ(scratch_.read("a.png").substr(1, 3), "PNG");
  EXPECT_EQ(tool({"render", "sky.json", "-o=b.png", "-q"}).exit_code, 0);
  EXPECT_EQ(scratch_.files(), (Names{"a.png", "b.png", "sky.json"}));
}

TEST_F(Words, ADashIsStandardOutput) {
  const Outcome exr = tool({"render", "sky.json", "-o", "-"});
  EXPECT_EQ(exr.exit_code, 0) << exr.err;
  EXPECT_EQ(exr.out.substr(0, 4), "\x76\x2f\x31\x01");
  EXPECT_EQ(tool({"render", "sky.json", "-o", "sky.exr", "-q"}).exit_code, 0);
  EXPECT_EQ(exr.out.size(), scratch_.read("sky.exr").size());
  EXPECT_EQ(tool({"render", "sky.json", "--png", "-"}).out.substr(1, 3), "PNG");
  // A file that the shell appends to keeps its contents.
  EXPECT_EQ(shell("echo first > all; airlight render sky.json -o - -q >> all").exit_code, 0);
  EXPECT_EQ(scratch_.read("all").substr(0, 10), "first\n\x76\x2f\x31\x01");
}

TEST_F(Words, PresetsAndPicturesFromAnyPipe) {
  ASSERT_EQ(tool({"render", "sky.json", "-o", "sky.exr", "-q"}).exit_code, 0);
  for (const char* line :
       {"cat sky.json | airlight check -q -", "cat sky.exr | airlight check -q -",
        "cat sky.json | airlight check -q /dev/fd/0", "cat sky.exr | airlight check -q /dev/stdin",
        "airlight check -q <(cat sky.json)", "airlight check -q <(cat sky.exr)",
        "mkfifo pipe; cat sky.json > pipe & airlight check -q pipe; r=$?; rm pipe; exit $r",
        "airlight check -q < sky.exr -", "echo '{\"airlight\": 1, \"extends\": \"sky.json\"}' | airlight check -q -",
        "echo '{\"airlight\": 1, \"extends\": \"earth\"}' | airlight check -q -",
        "airlight diff -q <(cat sky.exr) sky.exr", "cat sky.exr | airlight diff -q - <(cat sky.exr)",
        "airlight render sky.json -o - -q | airlight diff -q sky.exr -"}) {
    const Outcome outcome = shell(line);
    EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.err;
    EXPECT_EQ(outcome.err, "") << line;
  }
  const Outcome bad = shell("echo nonsense | airlight diff - sky.exr");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_TRUE(contains(bad.err, "standard input: is not an EXR file")) << bad.err;
}

TEST_F(Words, LimitsMayBePercentages) {
  ASSERT_EQ(tool({"render", "sky.json", "-o", "a.exr", "-q"}).exit_code, 0);
  ASSERT_EQ(tool({"render", "sky.json", "-o", "b.exr", "-q", "--set", "/sun/irradiance=1.008"}).exit_code, 0);
  EXPECT_EQ(tool({"diff", "b.exr", "a.exr", "--rel-mean", "1%"}).exit_code, 0);
  EXPECT_EQ(tool({"diff", "b.exr", "a.exr", "--rel-mean", "0.01"}).exit_code, 0);
  EXPECT_EQ(tool({"diff", "b.exr", "a.exr", "--rel-mean", "0.5%"}).exit_code, 1);
  EXPECT_EQ(tool({"diff", "b.exr", "a.exr", "--fail", "1e-9", "--failpercent", "100%"}).exit_code, 0);
}

TEST_F(Words, WhatDoesNotExistIsNamed) {
  ASSERT_EQ(run(scratch_.path(), {"mkdir", "a"}).exit_code, 0);
  scratch_.write("a/x.exr", "x");
  for (const Names& pair : {Names{"a", "nonexist"}, Names{"nonexist", "a"}}) {
    const Outcome outcome = tool({"diff", pair[0], pair[1]});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "airlight: nonexist: does not exist; expected a folder to compare with\n");
  }
}

TEST_F(Words, MethodsNameTheThingsThatTheyRefuse) {
  const std::string methods = tool({"methods"}).out;
  const std::string of_analytic = methods.substr(methods.find("analytic\n"));
  EXPECT_TRUE(contains(of_analytic.substr(0, of_analytic.find("leaves out")),
                       "    refuses: terrain, spheres, clouds, maps of the ground, polarising filters\n"))
      << methods;
  const std::string trace = methods.substr(methods.find("path-trace\n"));
  EXPECT_TRUE(contains(trace, "    holds for: any sun, height and air\n    leaves out: ")) << methods;
}

// Standard output is one object and nothing else.
TEST_F(Words, JsonFromEveryCommandThatAnswers) {
  const std::vector<std::pair<Names, std::string>> commands = {
      {{"render", "sky.json", "-o", "a.exr", "--json"}, "files"},
      {{"render", "sky.json", "--json", "--dry-run"}, "passes"},
      {{"luts", "sky.json", "-o", "tables", "--json"}, "files"},
      {{"probe", "sky.json", "--elevation", "9", "--azimuth", "0", "--json"}, "probes"},
      {{"check", "sky.json", "--json"}, "presets"},
      {{"methods", "--json"}, "methods"},
      {{"devices", "--json"}, "devices"},
      {{"presets", "--json"}, "presets"},
      {{"diff", "a.exr", "a.exr", "--json"}, "pairs"},
      {{"sequence", "sky.json", "-o", "f.#.exr", "--sun-elevation", "1:1:1", "--dry-run", "--json"}, "keys"},
  };
  for (const auto& [arguments, key] : commands) {
    const Outcome outcome = tool(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out, nullptr, false);
    EXPECT_TRUE(json.is_object() && json.contains(key)) << arguments.front() << ": " << outcome.out;
  }
  const Outcome bad = tool({"check", "sky.json", "--json", "--set", "/sun/elevation_deg=100"});
  EXPECT_EQ(bad.exit_code, 2);
  const Json json = Json::parse(bad.out);
  EXPECT_EQ(json["presets"][0]["good"], false);
  EXPECT_EQ(json["presets"][0]["problems"].size(), 1U);
}

TEST_F(Words, CheckKnowsDisplaysAndViews) {
  const auto problem = [&](const std::string& display) {
    scratch_.write("shown.json", "{\"airlight\": 1, \"extends\": \"sky.json\",\n\"display\": " + display + "}");
    const Outcome outcome = tool({"check", "shown.json"});
    EXPECT_EQ(outcome.exit_code, outcome.err.empty() ? 0 : 2);
    return outcome.err;
  };
  EXPECT_EQ(problem(R"({"view": "gpu"})"), "");
  EXPECT_EQ(problem(R"({"view": "diagnostic"})"), "");
  const std::string display = problem(R"({"display": "sRGB - Displai"})");
  EXPECT_TRUE(contains(display, "shown.json:2: /display/display: display 'sRGB - Displai' is not in")) << display;
  EXPECT_TRUE(contains(display, "did you mean 'sRGB")) << display;
  const std::string view = problem(R"({"view": "Raww"})");
  EXPECT_TRUE(contains(view, "shown.json:2: /display/view: view 'Raww' is not in")) << view;
  EXPECT_TRUE(contains(view, "did you mean 'Raw'?")) << view;
}

// A number of the table, by the row's name.
double milliseconds_of(const std::string& table, const std::string& name, int& count) {
  double value = 0.0;
  count = 0;
  for (const std::string& line : lines_of(table)) {
    const std::size_t start = line.find_first_not_of(' ');
    if (start != std::string::npos && line.compare(start, name.size(), name) == 0 && line[start + name.size()] == ' ') {
      value += std::stod(line.substr(36));
      ++count;
    }
  }
  return value;
}

// With layers and a glow, several plans run the same passes.
TEST_F(Words, TimingsNameEachPassOnceAndTheirPartsAddUp) {
  const Outcome outcome = tool({"render", "sky.json", "-o", "a.exr", "--png", "a.png", "--method", "orders", "--layers",
                                "--set", "/display/exposure=1e6", "--timings", "-q"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::map<std::string, int> seen;
  double parts = 0.0;
  double passes = 0.0;
  int rows = 0;
  for (const std::string& line : lines_of(outcome.err)) {
    const std::string name = line.substr(0, 36);
    EXPECT_EQ(seen[name]++, 0) << name;
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == 2 || indent == 4) {
      (indent == 2 ? parts : passes) += std::stod(line.substr(36));
      ++rows;
    }
  }
  EXPECT_GE(rows, 12) << outcome.err;
  int count = 0;
  const double rounding = 0.05 * rows;
  EXPECT_NEAR(parts, milliseconds_of(outcome.err, "render", count), rounding) << outcome.err;
  EXPECT_EQ(count, 1);
  EXPECT_NEAR(passes, milliseconds_of(outcome.err, "execute", count), rounding) << outcome.err;
  EXPECT_EQ(count, 1);
}

// The tool's output on a terminal while it searches.
TEST_F(Words, ToleranceShowsProgressOnATerminal) {
  int master = -1;
  const pid_t child = ::forkpty(&master, nullptr, nullptr, nullptr);
  if (child == 0) {
    (void)!::chdir(scratch_.path().c_str());
    ::execl(tool_program().c_str(), "airlight", "render", "sky.json", "-o", "a.exr", "--sun-elevation=-5",
            "--tolerance", "10%", nullptr);
    ::_exit(127);
  }
  std::string text;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(master, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(count));
  }
  ::waitpid(child, nullptr, 0);
  ::close(master);
  EXPECT_TRUE(contains(text, "choosing method and quality: probing ")) << text;
  EXPECT_TRUE(contains(text, "\r\033[K")) << text;  // and it is removed
  EXPECT_FALSE(contains(tool({"render", "sky.json", "-o", "b.exr", "--sun-elevation=-5", "--tolerance", "10%"}).err,
                        "choosing"));
}

}  // namespace
}  // namespace airlight::test
