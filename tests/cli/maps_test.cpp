// Units, colour spaces, maps and lighting in the tool's files.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/output/picture_reader.h"
#include "core/output/working_space.h"
#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

class Maps : public SmallSky {
 protected:
  // Renders the small sky with further words; must succeed.
  void render(Names words) const {
    words.insert(words.begin(), {"render", "sky.json", "-q", "--float"});
    const Outcome outcome = tool(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  RadianceImage picture(const std::string& name) const { return read_exr_picture(scratch_.path() / name).radiance; }
  Json json(const std::string& name) const { return Json::parse(scratch_.read(name)); }
};

const Names kCube = {"--set", "/camera/projection=cube", "--set", "/camera/pitch_deg=0"};

Names operator+(Names a, const Names& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST_F(Maps, ProbePrintsLuminanceWhereTheUnitAllows) {
  const Names zenith = {"probe", "sky.json", "--elevation", "90", "--azimuth", "0"};
  EXPECT_FALSE(contains(tool(zenith).out, "cd/m2"));
  EXPECT_FALSE(contains(tool(zenith + Names{"--json"}).out, "luminance"));
  const Names lux = {"--set", "/sun/unit=lux", "--set", "/sun/irradiance=[1e5, 2e5, 3e5]"};
  EXPECT_TRUE(contains(tool(zenith + lux).out, "luminance cd/m2"));
  const Json found = Json::parse(tool(zenith + lux + Names{"--json"}).out);
  EXPECT_EQ(found["radiance_unit"], "cd/m2");
  const Json& probe = found["probes"][0];
  const double sum = 0.2126 * probe["radiance"][0].get<double>() + 0.7152 * probe["radiance"][1].get<double>() +
                     0.0722 * probe["radiance"][2].get<double>();
  EXPECT_NEAR(probe["luminance_cd_per_m2"].get<double>() / sum, 1.0, 1e-9);
  const Json watts = Json::parse(
      tool(zenith + Names{"--set", "/sun/unit=W/m2", "--set", "/sun/irradiance=[1e5, 2e5, 3e5]", "--json"}).out);
  EXPECT_NEAR(watts["probes"][0]["luminance_cd_per_m2"].get<double>() / sum, 128000.0 / 1361.0, 1e-6);
}

// OpenEXR's attribute, as it stands in the header: name, type, size, value.
std::optional<float> white_luminance_in(const std::string& exr) {
  using namespace std::string_literals;
  const std::string start = "whiteLuminance\0float\0\4\0\0\0"s;
  const std::size_t at = exr.find(start);
  if (at == std::string::npos) {
    return std::nullopt;
  }
  float value = 0.0F;
  std::memcpy(&value, exr.data() + at + start.size(), sizeof value);
  return value;
}

TEST_F(Maps, TheExrSaysHowBrightWhiteIs) {
  render({"-o", "a.exr"});
  EXPECT_FALSE(white_luminance_in(scratch_.read("a.exr")).has_value());
  render({"-o", "b.exr", "--set", "/sun/unit=lux"});
  EXPECT_EQ(white_luminance_in(scratch_.read("b.exr")), 1.0F);
  render({"-o", "c.exr", "--set", "/sun/unit=W/m2"});
  EXPECT_NEAR(white_luminance_in(scratch_.read("c.exr")).value_or(0.0F), 94.049F, 1e-3F);
}

// The EXR's pixels are the matrix applied; the PNG is the same byte for byte; diff names the spaces and stops.
TEST_F(Maps, AColourSpaceChangesTheExrAlone) {
  render({"-o", "a.exr", "--png", "a.png"});
  render({"-o", "b.exr", "--png", "b.png", "--colorspace", "ACES2065-1"});
  EXPECT_EQ(scratch_.read("a.png"), scratch_.read("b.png"));
  const RadianceImage a = picture("a.exr");
  const RadianceImage b = picture("b.exr");
  const ColorMatrix m = from_rec709(WorkingSpace::aces2065_1);
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double wanted = m[c][0] * static_cast<double>(a.rgba[i]) + m[c][1] * static_cast<double>(a.rgba[i + 1]) +
                            m[c][2] * static_cast<double>(a.rgba[i + 2]);
      EXPECT_NEAR(static_cast<double>(b.rgba[i + c]), wanted, 1e-5 * wanted);
    }
  }
  const Outcome diff = tool({"diff", "a.exr", "b.exr"});
  EXPECT_EQ(diff.exit_code, 2);
  EXPECT_TRUE(contains(diff.err, "colour spaces differ")) << diff.err;
  EXPECT_TRUE(contains(diff.err, "--colorspace")) << diff.err;
  // Its preset renders the first picture again.
  ASSERT_EQ(tool({"render", "b.exr", "-q", "--float", "-o", "c.exr"}).exit_code, 0);
  EXPECT_EQ(tool({"diff", "c.exr", "a.exr"}).exit_code, 0);
  ASSERT_EQ(tool({"render", "b.exr", "-q", "--float", "-o", "d.exr", "--colorspace", "ACES2065-1"}).exit_code, 0);
  EXPECT_EQ(tool({"diff", "d.exr", "b.exr"}).exit_code, 0);
  EXPECT_EQ(tool({"render", "sky.json", "--colorspace", "ACES"}).exit_code, 2);
}

TEST_F(Maps, ASequenceInAnotherSpaceIsDoneAgainAndShownTheSame) {
  const Names frames = {"sequence", "sky.json",        "-q",   "--sun-elevation", "10:20:10", "-o",
                        "s.##.exr", "--contact-sheet", "s.png"};
  ASSERT_EQ(tool(frames).exit_code, 0);
  const std::string sheet = scratch_.read("s.png");
  const std::string first = scratch_.read("s.01.exr");
  const Outcome again = tool(frames + Names{"--colorspace", "linear-rec2020", "--float"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(scratch_.read("s.01.exr"), first);
  const PixelImage found = read_png_picture(scratch_.path() / "s.png");
  scratch_.write("before.png", sheet);
  const PixelImage before = read_png_picture(scratch_.path() / "before.png");
  ASSERT_EQ(found.bytes.size(), before.bytes.size());
  int worst = 0;
  for (std::size_t i = 0; i < found.bytes.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<int>(found.bytes[i]) - static_cast<int>(before.bytes[i])));
  }
  EXPECT_LE(worst, 2);  // half floats against floats
}

// Faces of the three layouts have the same pixels; so have those of six files, each of which renders itself again.
TEST_F(Maps, LayoutsHoldTheSameFaces) {
  render(kCube + Names{"--size", "8x48", "-o", "stack.exr", "--png", "stack.png"});
  render(kCube + Names{"--set", "/camera/cube_layout=strip", "--size", "48x8", "-o", "strip.exr"});
  render(kCube + Names{"--set", "/camera/cube_layout=cross", "--size", "24x32", "-o", "cross.exr", "--png", "c.png"});
  render(kCube + Names{"--size", "8x48", "-o", "six.exr", "--png", "six.png", "--cube-faces"});
  const RadianceImage stack = picture("stack.exr");
  const RadianceImage strip = picture("strip.exr");
  const RadianceImage cross = picture("cross.exr");
  const char* const names[] = {"posx", "negx", "posy", "negy", "posz", "negz"};
  const int cells[6][3] = {{0, 1, 0}, {2, 1, 0}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 3, 1}};
  for (int face = 0; face < 6; ++face) {
    const RadianceImage one = picture("six." + std::string(names[face]) + ".exr");
    ASSERT_EQ(one.height, 8);
    // Rows beside the horizon are means, whose shares depend on a face's place in the picture by rounding.
    for (int k = 0; k < 64; ++k) {
      const int x = k % 8;
      const int y = k / 8;
      const float* const expected = stack.at(x, 8 * face + y);
      EXPECT_EQ(one.at(x, y)[0], expected[0]);
      EXPECT_NEAR(strip.at(8 * face + x, y)[2], expected[2], 5e-4F * expected[2]);
      const auto& [column, row, turned] = cells[face];
      const float* const there = cross.at(8 * column + (turned == 1 ? 7 - x : x), 8 * row + (turned == 1 ? 7 - y : y));
      EXPECT_NEAR(there[2], expected[2], 5e-4F * expected[2]) << names[face] << " " << x << ", " << y;
      EXPECT_EQ(there[3], 1.0F);
    }
    const std::string file = "six." + std::string(names[face]) + ".exr";
    ASSERT_EQ(tool({"render", file, "-q", "--float", "-o", "again.exr"}).exit_code, 0);
    const Outcome diff = tool({"diff", "again.exr", file, "--rel-max", "0.001"});
    EXPECT_EQ(diff.exit_code, 0) << names[face] << diff.out << diff.err;
  }
  EXPECT_EQ(cross.at(0, 0)[3], 0.0F);
  EXPECT_EQ(tool({"diff", "stack.exr", "stack.exr"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "six.exr"));
}

TEST_F(Maps, WhatDoesNotFitIsRefused) {
  const Outcome faces = tool({"render", "sky.json", "--cube-faces"});
  EXPECT_EQ(faces.exit_code, 2);
  EXPECT_TRUE(contains(faces.err, "/camera/projection is perspective")) << faces.err;
  const Outcome size = tool(Names{"render", "sky.json"} + kCube);
  EXPECT_EQ(size.exit_code, 2);
  EXPECT_TRUE(contains(size.err, "/image: 32x18 does not fit")) << size.err;
  const Outcome light = tool({"render", "sky.json", "--irradiance", "sky.exr", "-o", "a.exr"});
  EXPECT_EQ(light.exit_code, 2);
  EXPECT_TRUE(contains(light.err, "'sky.json' would be written over")) << light.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

TEST_F(Maps, IrradianceGoesWithTheCameraAndItsHarmonicsWithTheWorld) {
  render({"-o", "a.exr", "--irradiance", "light.exr"});
  const RadianceImage map = picture("light.exr");
  EXPECT_EQ(map.width, 64);
  const Json light = json("light.json");
  ASSERT_EQ(light["spherical_harmonics"]["coefficients"].size(), 9U);
  EXPECT_EQ(light["colorspace"], "linear-rec709");
  EXPECT_EQ(light["irradiance_unit"], "relative");
  // The sun's irradiance is probe's transmittance, up to the effect of the disc's width.
  const Json sun = light["sun"];
  const Json probe = Json::parse(tool({"probe", "sky.json", "--elevation", "30", "--azimuth", "0", "--json"}).out);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(sun["irradiance"][c].get<double>(), probe["probes"][0]["transmittance"][c].get<double>(), 1e-4);
  }
  EXPECT_NEAR(sun["direction"][2].get<double>(), -std::cos(M_PI / 6), 1e-9);  // north
  render({"-o", "b.exr", "--irradiance", "turned.exr", "--set", "/camera/azimuth_deg=90"});
  EXPECT_EQ(json("turned.json")["spherical_harmonics"], light["spherical_harmonics"]);
  const RadianceImage turned = picture("turned.exr");
  for (int x = 0; x < 64; ++x) {
    const float expected = map.at((x + 16) % 64, 10)[1];
    EXPECT_NEAR(turned.at(x, 10)[1], expected, 1e-4F * expected) << x;
  }
}

}  // namespace
}  // namespace airlight::test
