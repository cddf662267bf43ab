// Spectral EXRs, read by a foreign program: OpenImageIO for Python.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/process.h"

namespace airlight::test {
namespace {

using WordList = std::vector<std::string>;

// Spectra of air, haze and ozone in a few pixels, one of which has the sun's disc.
std::string spectral_preset(const std::string& elevation, const std::string& more) {
  return R"({"airlight": 1, "planet": {"ground_albedo": 0.2}, "media": [
    {"name": "air", "scattering_per_km": {"named": "air"},
     "density": {"profile": "exponential", "scale_height_km": 8}, "phase": {"function": "rayleigh"}},
    {"name": "haze", "scattering_per_km": {"at_nm": 550, "value": 0.05, "exponent": -1.3},
     "density": {"profile": "exponential", "scale_height_km": 1.5},
     "phase": {"function": "henyey-greenstein", "g": 0.7}},
    {"name": "ozone", "absorption_per_km": {"named": "ozone", "dobson_units": 300},
     "density": {"profile": "tent", "center_km": 25, "half_width_km": 15}}],
    "sun": {"elevation_deg": )" +
         elevation + R"(, "azimuth_deg": 10},
    "camera": {"projection": "equirectangular"}, "image": {"width": 16, "height": 8)" +
         more + R"(}, "render": {"method": "march"}})";
}

class SpectralExr : public testing::Test {
 protected:
  void render(const WordList& more) const {
    WordList words{"render", "sky.json", "-q", "-o", "sky.exr", "--spectral"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = airlight(scratch_.path(), words);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  Scratch scratch_;
};

// The file's colours equal its spectrum, integrated by the other program, to 0.3 %: by day, with the sun at the horizon
// and at dusk, with the sun as white and with D65. A channel near 0 beside the others is not compared by itself.
TEST_F(SpectralExr, IsReadByAnotherProgramAndIntegrated) {
  const WordList python{"/usr/bin/python3", AIRLIGHT_SOURCE_DIR "/tests/cli/spectral_exr.py"};
  struct Sky {
    const char* sun;
    const char* white;
  };
  for (const Sky& sky : {Sky{"40", "sun"}, Sky{"1", "D65"}, Sky{"-4", "sun"}}) {
    scratch_.write("sky.json", spectral_preset(sky.sun, std::string(R"(, "white": ")") + sky.white + "\""));
    render({"380:780:10"});
    WordList words = python;
    words.insert(words.end(), {"sky.exr", sky.white, "380:780:10"});
    const Outcome read = run(scratch_.path(), words);
    if (read.exit_code == 77) {
      GTEST_SKIP() << "OpenImageIO for Python is not installed; scripts/setup test does it: " << read.out;
    }
    ASSERT_EQ(read.exit_code, 0) << read.out << read.err;
    std::istringstream text(read.out);
    std::string word;
    double bands = 1.0;
    double points = 1.0;
    text >> word >> bands >> word >> points;
    EXPECT_LT(bands, 0.003) << sky.sun;
    EXPECT_LT(points, 0.003) << sky.sun;
  }
}

TEST_F(SpectralExr, CarriesItsPresetAndIsCompared) {
  scratch_.write("sky.json", spectral_preset("20", ""));
  render({"450:650:100", "--png", "sky.png"});
  EXPECT_FALSE(scratch_.read("sky.png").empty());
  const Outcome again =
      airlight(scratch_.path(), {"render", "sky.exr", "-q", "-o", "again.exr", "--spectral", "450:650:100"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(scratch_.read("sky.exr"), scratch_.read("again.exr"));
  const Outcome same = airlight(scratch_.path(), {"diff", "again.exr", "sky.exr", "--layer", "S0"});
  EXPECT_EQ(same.exit_code, 0) << same.err << same.out;
  const Outcome other = airlight(scratch_.path(), {"render", "sky.exr", "-q", "-o", "again.exr", "--spectral",
                                                   "450:650:100", "--set", "/media/1/scattering_per_km/value=0.06"});
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_EQ(
      airlight(scratch_.path(), {"diff", "again.exr", "sky.exr", "--layer", "S0", "--rel-mean", "0.1%"}).exit_code, 1);
}

TEST_F(SpectralExr, IsToldAsJson) {
  scratch_.write("sky.json", spectral_preset("20", ""));
  const Outcome told =
      airlight(scratch_.path(), {"render", "sky.json", "-q", "-o", "sky.exr", "--json", "--spectral", "500:600:50"});
  ASSERT_EQ(told.exit_code, 0) << told.err;
  const auto json = nlohmann::json::parse(told.out);
  EXPECT_EQ(json["exr"]["format"], "float");
  EXPECT_EQ(json["spectrum"]["unit"], "W.m^-2.sr^-1.nm^-1");
  EXPECT_EQ(json["spectrum"]["wavelengths_nm"], (std::vector<double>{500.0, 550.0, 600.0}));
  EXPECT_EQ(json["spectrum"]["picture"], "wavelengths of the scene's own");
  const Outcome planned =
      airlight(scratch_.path(), {"render", "sky.json", "-o", "none.exr", "--dry-run", "--spectral", "500:600:50"});
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
  EXPECT_TRUE(contains(planned.out, "3 wavelengths from 500 to 600 nm")) << planned.out;
}

// Layers and faces have spectra beside them, each as it is alone.
TEST_F(SpectralExr, GoesWithLayersAndFaces) {
  scratch_.write("sky.json", spectral_preset("20", ""));
  const Outcome layers =
      shell(scratch_.path(),
            "airlight render sky.json -q --method orders --layers --spectral 500:600:50 -o both.exr && "
            "airlight render sky.json -q --method orders --float --layers -o layers.exr && "
            "airlight render sky.json -q --method orders --spectral 500:600:50 -o spectrum.exr && "
            "airlight diff both.exr layers.exr --layer haze --fail 0 && "
            "airlight diff both.exr spectrum.exr --layer S0 --fail 0");
  EXPECT_EQ(layers.exit_code, 0) << layers.out << layers.err;
  const Outcome faces = shell(
      scratch_.path(),
      "airlight render sky.json -q --projection cube --size 8x48 --cube-faces --spectral 500:600:50 -o cube.exr && "
      "airlight render cube.negy.exr -q --spectral 500:600:50 -o face.exr && "
      "airlight diff cube.negy.exr face.exr --layer S0 --fail 1e-6");
  EXPECT_EQ(faces.exit_code, 0) << faces.out << faces.err;
}

TEST_F(SpectralExr, ProbePrintsSpectra) {
  scratch_.write("sky.json", spectral_preset("20", ""));
  const WordList words{"probe", "sky.json",    "--elevation", "90",        "--azimuth",
                       "0",     "--elevation", "5",           "--azimuth", "90"};
  const auto with = [&](const WordList& more) {
    WordList all = words;
    all.insert(all.end(), more.begin(), more.end());
    return airlight(scratch_.path(), all);
  };
  const Outcome usual = with({"--spectrum"});
  ASSERT_EQ(usual.exit_code, 0) << usual.err;
  EXPECT_EQ(lines_of(usual.out).size(), 1U + 2U * 41U + 1U) << usual.out;
  const Outcome listed = with({"--spectrum", "400:700:100", "--json"});
  ASSERT_EQ(listed.exit_code, 0) << listed.err;
  const auto json = nlohmann::json::parse(listed.out);
  EXPECT_EQ(json["wavelengths_nm"], (std::vector<double>{400.0, 500.0, 600.0, 700.0}));
  const std::vector<double> up = json["probes"][0]["transmittance"];
  const std::vector<double> low = json["probes"][1]["transmittance"];
  for (std::size_t k = 0; k < up.size(); ++k) {
    EXPECT_LT(low[k], up[k]);
  }
  EXPECT_LT(up[0], up[3]) << "air takes more of blue";
}

TEST_F(SpectralExr, BadInputIsOneLine) {
  scratch_.write("sky.json", spectral_preset("20", ""));
  scratch_.write("three.json", small_preset());
  struct Bad {
    WordList words;
    WordList parts;
  };
  const auto range = [](const std::string& text) {
    return WordList{"render", "sky.json", "-o", "a.exr", "--spectral", text};
  };
  const std::vector<Bad> all = {
      {range("380-780"), {"render: --spectral: '380-780' is not FIRST:LAST:STEP in nm", "380:780:10"}},
      {range("380:780"), {"is not FIRST:LAST:STEP"}},
      {range("380:780:10:5"), {"is not FIRST:LAST:STEP"}},
      {range("380:780:ten"), {"is not FIRST:LAST:STEP"}},
      {range("nan:780:10"), {"is not FIRST:LAST:STEP"}},
      {range("780:380:10"), {"does not ascend"}},
      {range("380:780:0"), {"has a step of 0 nm", "at least 0.1"}},
      {range("380:780:-10"), {"has a step of -10 nm"}},
      {range("300:780:10"), {"leaves the range from 360 to 830 nm"}},
      {range("380:900:10"), {"leaves the range from 360 to 830 nm"}},
      {range("380:780:1"), {"is 401 wavelengths", "2 to 96"}},
      {range("380:780:500"), {"is one wavelength", "2 to 96"}},
      {{"render", "three.json", "-o", "a.exr", "--spectral", "380:780:10"},
       {"the preset has three channels and no spectra", "such as earth"}},
      {{"render", "sky.json", "--png", "a.png", "--spectral", "380:780:10"}, {"none is written", "-o FILE.exr"}},
      {{"render", "sky.json", "-o", "a.exr", "--luts", ".", "--spectral", "380:780:10"}, {"does not go with --luts"}},
      {{"render", "sky.json", "-o", "a.exr", "--tile", "8x8", "--spectral", "380:780:10"}, {"does not go with --tile"}},
      {{"render", "sky.json", "-o", "a.exr", "--size", "4096x2048", "--spectral", "380:780:10"},
       {"4096x2048 are 8388608 pixels", "at most 3273603"}},
      {{"probe", "sky.json", "--elevation", "1", "--azimuth", "0", "--spectrum", "3"},
       {"probe: --spectrum: '3' is not FIRST:LAST:STEP"}},
      {{"probe", "three.json", "--elevation", "1", "--azimuth", "0", "--spectrum"}, {"no spectra"}},
  };
  for (const Bad& bad : all) {
    const Outcome outcome = airlight(scratch_.path(), bad.words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    for (const std::string& part : bad.parts) {
      EXPECT_TRUE(contains(outcome.err, part)) << "expected '" << part << "' in: " << outcome.err;
    }
  }
  EXPECT_EQ(scratch_.files(), (WordList{"sky.json", "three.json"}));
}

}  // namespace
}  // namespace airlight::test
