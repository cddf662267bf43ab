// Pictures for other programs, read back by programs that are not ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

class Formats : public SmallSky {
 protected:
  void render(Names words) const {
    words.insert(words.begin(), {"render", "sky.json", "-q"});
    const Outcome outcome = tool(words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }

  // By tests/cli/read_picture.py.
  Outcome read(Names words) const {
    words.insert(words.begin(), {"/usr/bin/python3", AIRLIGHT_SOURCE_DIR "/tests/cli/read_picture.py"});
    return run(scratch_.path(), words);
  }

  std::string refusal(Names words) const {
    words.insert(words.begin(), {"render", "sky.json"});
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    return outcome.err;
  }
};

constexpr const char* kNoPython = "OpenImageIO for Python is not installed; scripts/setup test does it";

// Rows of 8 to 32 767 pixels are stored by runs, others flat.
TEST_F(Formats, AnHdrIsReadByOpenImageIO) {
  for (const char* size : {"48x27", "7x5"}) {
    render({"--size", size, "-o", "sky.hdr"});
    render({"--size", size, "-o", "sky.npy"});
    const Outcome outcome = read({"hdr", "sky.hdr", "sky.npy"});
    if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
    EXPECT_EQ(outcome.exit_code, 0) << size << outcome.out << outcome.err;
  }
}

TEST_F(Formats, TheFilesAreThoseOfTiles) {
  for (const char* file : {"a.hdr", "a.npy"}) {
    const std::string tiled = std::string("tiled-") + file;
    render({"--size", "40x30", "-o", file});
    render({"--size", "40x30", "--tile", "16x8", "-o", tiled});
    EXPECT_EQ(scratch_.read(tiled), scratch_.read(file));
  }
}

TEST_F(Formats, ACubeMapIsLookedUpByDirection) {
  const Names cube{"--projection", "cube", "--set", "/sun/disc/visible=false", "--azimuth", "0"};
  for (const char* size : {"8x48", "5x30"}) {
    for (const char* file : {"sky.ktx2", "sky.dds"}) {
      Names words = cube;
      words.insert(words.end(), {"--size", size, "-o", "sky.npy"});
      render(words);
      words.back() = file;
      render(words);
      const Outcome outcome = read({"texture", file, "sky.npy"});
      if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
      EXPECT_EQ(outcome.exit_code, 0) << file << outcome.out << outcome.err;
    }
  }
}

TEST_F(Formats, AUsdStageLightsASceneAsTheSkyDoes) {
  for (const char* up : {"y", "z"}) {
    render({"--projection", "latlong", "--size", "128x64", "--azimuth", "30", "-o", "dome.exr", "--usd", "dome.usda",
            "--up", up, "--irradiance", "light.exr"});
    const Outcome outcome = read({"usd", "dome.usda", "light"});
    if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
}

// Three moments around midnight, in which sun and moon go past the north.
// By day at full-day's place the moon of that date is far below the horizon; it rises at night.
TEST_F(Formats, AStageHasAMoonThatRisesLater) {
  const Outcome made =
      tool({"sequence", "full-day",     "-q",     "--projection", "latlong", "--set",   "/camera/pitch_deg=0",
            "--size",   "16x8",         "--date", "2026-09-02",   "--from",  "16:00",   "--to",
            "00:00",    "--step",       "4h",     "--lat",        "48.85",   "--lon",   "2.35",
            "--tz",     "Europe/Paris", "-o",     "a.#.exr",      "--usd",   "day.usda"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string text = scratch_.read("day.usda");
  const std::size_t moon = text.find("DistantLight \"moon\"");
  ASSERT_NE(moon, std::string::npos) << text;
  const std::string its = text.substr(text.find("inputs:intensity", moon));
  EXPECT_TRUE(contains(its, "1: 0,")) << its;
  EXPECT_FALSE(contains(its, "3: 0,")) << its;
}

TEST_F(Formats, AStageOfASequenceHasASampleAFrame) {
  const Names place{"full-day", "-q",    "--date",       "2026-04-01", "--lat",  "69.65",
                    "--lon",    "18.96", "--projection", "latlong",    "--size", "16x8"};
  const auto with = [&](Names words, const Names& more) {
    for (const Names* part : {&place, &more}) words.insert(words.end(), part->begin(), part->end());
    return words;
  };
  const Names path{"--from", "20:00", "--to", "02:00", "--step", "3h", "--fps", "30", "-o", "dome.#.exr"};
  Names words = path;
  words.insert(words.end(), {"--usd", "day.usda"});
  const Outcome made = tool(with({"sequence"}, words));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  Names read_words{"usd-samples", "day.usda"};
  for (const char* moment : {"2026-04-01 20:00", "2026-04-01 23:00", "2026-04-02 02:00"}) {
    const std::string text = moment;
    const std::string light = "light" + text.substr(11, 2);
    Names one = with({"render"}, {"--time", text.substr(11), "--irradiance", light + ".exr", "-o", "one.exr"});
    *std::ranges::find(one, "2026-04-01") = text.substr(0, 10);
    const Outcome rendered = tool(one);
    ASSERT_EQ(rendered.exit_code, 0) << rendered.err;
    read_words.push_back(light);
  }
  const Outcome outcome = read(read_words);
  if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const auto refused = [&](const Names& more) {
    const Outcome refusal = tool(with({"sequence"}, more));
    EXPECT_EQ(refusal.exit_code, 2) << refusal.err;
    return refusal.err;
  };
  Names shard = words;
  shard.insert(shard.end(), {"--shard", "1/2"});
  EXPECT_TRUE(contains(refused(shard), "run once more without --shard"));
  Names plain{"--from", "20:00", "--to", "21:00", "--step", "1h", "--png", "a.#.png", "--usd", "day.usda"};
  EXPECT_TRUE(contains(refused(plain), "give -o 'sky.####.exr' too"));
  Names perspective = words;
  perspective.insert(perspective.end(), {"--set", "/camera/projection=perspective"});
  EXPECT_TRUE(contains(refused(perspective), "give --projection latlong"));
}

TEST_F(Formats, JsonHoldsTheArray) {
  render({"--size", "9x5", "-o", "array.json"});
  render({"--size", "9x5", "-o", "sky.npy"});
  const Outcome outcome = read({"json", "array.json", "sky.npy"});
  if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(contains(refusal({"-o", "sky.json"}), "would be written over"));
}

// The cube map's harmonics and sun are in its own axes: of a camera that looks east they are those of the sky around
// it, turned.
TEST_F(Formats, APrefilteredCubeHasItsLightBesideIt) {
  const Names cube{"--projection",    "cube", "--size",        "16x96",
                   "--prefilter",     "ggx",  "--set",         "/sun/disc/visible=false",
                   "--sun-elevation", "20",   "--sun-azimuth", "100"};
  const auto light_at = [&](const char* azimuth) {
    Names words = cube;
    words.insert(words.end(), {"--azimuth", azimuth, "-o", "glossy.ktx2"});
    render(words);
    return nlohmann::json::parse(scratch_.read("glossy.light.json"));
  };
  const auto north = light_at("0");
  const auto east = light_at("90");
  const auto harmonics = [](const nlohmann::json& light) {
    return light["spherical_harmonics"]["coefficients"].get<std::vector<std::vector<double>>>();
  };
  // Looking east, what was along x is along -z.
  const auto n = harmonics(north);
  const auto e = harmonics(east);
  EXPECT_NEAR(e[0][1], n[0][1], 1e-6 * n[0][1]);
  EXPECT_NEAR(e[1][1], n[1][1], 1e-6 * n[0][1]);
  EXPECT_NEAR(e[2][1], -n[3][1], 1e-6 * n[0][1]);
  EXPECT_NEAR(e[3][1], n[2][1], 1e-6 * n[0][1]);
  const auto toward = east["sun"]["direction"].get<std::vector<double>>();
  EXPECT_NEAR(std::atan2(toward[0], -toward[2]) * 180.0 / M_PI, 10.0, 0.01);  // 10 degrees to the right
  // The roughest mip is one texel, the mean of half the sphere weighted by the cosine twice: not far from what a
  // diffuse card gets from there, and its files are those of any cube.
  const std::string bytes = scratch_.read("glossy.ktx2");
  EXPECT_EQ(bytes.substr(1, 6), "KTX 20");
  Names plain = cube;
  plain.erase(plain.begin() + 4, plain.begin() + 6);
  plain.insert(plain.end(), {"--azimuth", "90", "-o", "plain.ktx2"});
  render(plain);
  const std::string other = scratch_.read("plain.ktx2");
  ASSERT_EQ(other.size(), bytes.size());
  EXPECT_NE(other, bytes);
  constexpr std::size_t kSky = 6 * 16 * 16 * 8;  // the sharpest mip, last in the file
  EXPECT_EQ(other.substr(other.size() - kSky), bytes.substr(bytes.size() - kSky));
  EXPECT_TRUE(contains(refusal({"-o", "sky.exr", "--prefilter", "ggx"}), "give -o FILE.ktx2 or FILE.dds too"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.ktx2", "--prefilter", "box"}), "ggx"));
}

const Names kInLux{"--set", "/sun/unit=lux", "--set", "/sun/irradiance=128000"};

TEST_F(Formats, RadianceFindsTheSkysIlluminance) {
  Names words{"--size", "8x4",          "--sun-elevation", "35",         "--sun-azimuth", "130", "--azimuth",
              "20",     "--irradiance", "light.exr",       "--radiance", "sky.rad",       "-o",  "sky.exr"};
  words.insert(words.end(), kInLux.begin(), kInLux.end());
  render(words);
  const Outcome outcome = read({"rad", "sky.rad", "light"});
  if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  // A spectrum of 20 bands, as Radiance's own spectral skies have. The preset's sun is that of G-173 in lux.
  Names spectral{"render",          "earth-noon", "-q",           "--spectral", "390:770:20", "--size",       "8x4",
                 "--sun-elevation", "35",         "--irradiance", "light.exr",  "--radiance", "spectral.rad", "-o",
                 "sky.exr"};
  spectral.insert(spectral.end(), kInLux.begin(), kInLux.end());
  const Outcome made = tool(spectral);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Outcome read_back = read({"rad", "spectral.rad", "light"});
  EXPECT_EQ(read_back.exit_code, 0) << read_back.out << read_back.err;
  spectral[4] = "550:570:10";
  EXPECT_TRUE(contains(tool(spectral).err, "3 wavelengths; Radiance takes 4 to 24"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.exr", "--radiance", "sky.hdr"}), "end in .rad"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.hdr", "--radiance", "sky.rad"}), "is where -o writes"));
}

TEST_F(Formats, ASkyMatrixHasTheDaysLight) {
  const Names place{"--date", "2026-03-21", "--lat", "48.85", "--lon", "2.35"};
  const auto with = [&](Names words, const Names& more) {
    for (const Names* part : {&place, &kInLux, &more}) words.insert(words.end(), part->begin(), part->end());
    return words;
  };
  for (const char* hour : {"09:00", "16:00"}) {
    render(with({"--size", "8x4", "-o", "sky.exr"},
                {"--time", hour, "--irradiance", std::string("light") + std::string(hour).substr(0, 2) + ".exr"}));
  }
  for (const char* factor : {"1", "2"}) {
    const Outcome made =
        tool(with({"sequence", "sky.json", "-q"}, {"--from", "02:00", "--to", "16:00", "--step", "7h",
                                                   "--radiance-matrix", "day.mtx", "--patches", factor}));
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Outcome outcome = read({"matrix", "day.mtx", factor, "dark", "light09", "light16"});
    if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
  const auto refused = [&](const Names& more) {
    Names words{"sequence", "sky.json"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    return outcome.err;
  };
  EXPECT_TRUE(contains(refused({"--sun-elevation", "0:9:3", "--radiance-matrix", "a.mtx"}), "give --date, --from"));
  EXPECT_TRUE(contains(refused({"--sun-elevation", "0:9:3", "--png", "a.#.png", "--patches", "2"}),
                       "--patches is for --radiance-matrix"));
  EXPECT_TRUE(contains(refused({"--radiance-matrix", "a.mtx", "--png", "a.#.png"}), "--png is for frames"));
  for (const Names& idle : {Names{"--ev", "1"}, Names{"--bits", "16"}, Names{"--fps", "30"},
                            Names{"--preview-rate", "9"}, Names{"--ocio-config", "x.ocio"}, Names{"--usd", "x.usda"}}) {
    Names words{"--radiance-matrix", "a.mtx"};
    words.insert(words.end(), idle.begin(), idle.end());
    EXPECT_TRUE(contains(refused(words), idle.front() + " is for frames"));
  }
  EXPECT_TRUE(contains(refused(with({"--radiance-matrix", "a.mtx"},
                                    {"--from", "00:00", "--to", "23:00", "--step", "1s", "--until", "2026-04-21"})),
                       "expected at most 100000000"));
  EXPECT_TRUE(contains(refused(with({"--radiance-matrix", "a.mtx"},
                                    {"--from", "00:00", "--to", "23:00", "--step", "1h", "--until", "2026-02-21"})),
                       "it ends before it begins"));
}

TEST_F(Formats, TheCompassMarksTheDirections) {
  const Outcome made = tool({"render", "compass", "--size", "180x90", "-q", "-o", "compass.npy"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Outcome outcome = read({"compass", "compass.npy"});
  if (outcome.exit_code == 77) GTEST_SKIP() << kNoPython;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

// An EXR says where the sun is and what it gives.
TEST_F(Formats, AnExrTellsItsLight) {
  render({"--sun-elevation", "30", "--sun-azimuth", "90", "--set", "/sun/unit=lux", "--set", "/sun/irradiance=128000",
          "-o", "sky.exr", "--irradiance", "light.exr"});
  const Outcome info = run(scratch_.path(), {"exrheader", "sky.exr"});
  const Outcome dump = info.exit_code == 0 ? info : run(scratch_.path(), {"iinfo", "-v", "sky.exr"});
  ASSERT_EQ(dump.exit_code, 0) << dump.err;
  for (const char* name : {"airlight:sun_direction", "airlight:sun_irradiance_above_air", "airlight:sun_irradiance",
                           "airlight:illuminance"}) {
    EXPECT_TRUE(contains(dump.out, name)) << dump.out;
  }
  const std::size_t at = dump.out.find("airlight:illuminance");
  const double lux = std::stod(dump.out.substr(dump.out.find_first_of("0123456789", at)));
  const auto light = nlohmann::json::parse(scratch_.read("light.json"));
  const auto irradiance = light["sun"]["irradiance"].get<std::vector<double>>();
  const double by_sun = 0.5 * (0.2126 * irradiance[0] + 0.7152 * irradiance[1] + 0.0722 * irradiance[2]);
  // The level surface by its nine harmonics, which are good to a per cent.
  const auto sh = light["spherical_harmonics"]["coefficients"].get<std::vector<std::vector<double>>>();
  double by_sky = 0.0;
  const double weights[] = {0.2126, 0.7152, 0.0722};
  for (std::size_t c = 0; c < 3; ++c) {
    by_sky += weights[c] * (M_PI * 0.282095 * sh[0][c] + 2.094395 * 0.488603 * sh[1][c] -
                            M_PI / 4 * (0.315392 * sh[6][c] + 0.546274 * sh[8][c]));
  }
  EXPECT_NEAR(lux, by_sun + by_sky, 0.01 * lux);
  EXPECT_GT(lux, 10000.0);
}

TEST_F(Formats, RefusesWhatAFormatCannotHold) {
  EXPECT_TRUE(contains(refusal({"-o", "sky.ktx2"}), "it holds a cube map in one file; give --projection cube"));
  EXPECT_TRUE(contains(
      refusal({"-o", "sky.dds", "--projection", "cube", "--set", "/camera/cube_layout=strip", "--size", "48x8"}),
      "the layout stack"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.hdr", "--colorspace", "ACEScg"}), "its colours are linear Rec.709"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.npy", "--float"}), "--half and --float are for EXRs"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.hdr", "--layers", "--method", "orders"}), "layers stand in the EXR"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.exr", "--usd", "sky.usda"}), "give --projection latlong"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.hdr", "--usd", "sky.usda", "--projection", "latlong"}), "give -o FILE.exr"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.exr", "--usd", "sky.usd", "--projection", "latlong"}), "end in .usda"));
  EXPECT_TRUE(contains(refusal({"-o", "sky.exr", "--up", "z"}), "--up is for --usd"));
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

TEST_F(Formats, TellsWhatAHalfCannotHold) {
  const Outcome outcome = tool({"render", "sky.json", "--projection", "cube", "--size", "8x48", "-o", "sky.ktx2",
                                "--set", "/sun/irradiance=1e9"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "samples above 65504")) << outcome.err;
}

}  // namespace
}  // namespace airlight::test
