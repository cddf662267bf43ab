// libairlight as its users see it: the installed header alone.
#include <airlight/airlight.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using airlight::Image;
using airlight::Scene;
using airlight::Session;

class SessionTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { session_ = std::make_unique<Session>(); }
  static void TearDownTestSuite() { session_.reset(); }

  static Scene map(const std::string& preset) {
    Scene scene = session_->load(preset);
    scene.option("projection", "latlong").option("size", "32x16").set("/sun/disc/visible", "false");
    return scene;
  }

  static std::unique_ptr<Session> session_;
};
std::unique_ptr<Session> SessionTest::session_;

template <class Error, class Work>
std::string message(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was refused";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(SessionTest, APixelIsTheLightAlongItsDirection) {
  const Scene scene = map("earth-noon");
  const Image sky = session_->render(scene);
  ASSERT_EQ(sky.rgb.size(), 3U * 32U * 16U);
  // The centre of row y, column x: the picture's middle is north.
  const int x = 20;
  const int y = 3;
  const airlight::Direction along{90.0 - 180.0 * (y + 0.5) / 16, 360.0 * (x + 0.5) / 32 - 180.0};
  const airlight::Probe probe = session_->probe(scene, std::array{along}).front();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(static_cast<double>(sky.at(x, y)[c]) / probe.radiance[c], 1.0, 0.01);
    EXPECT_GT(probe.transmittance[c], 0.0);
    EXPECT_LT(probe.transmittance[c], 1.0);
  }
}

// What a session takes over from one sky to the next changes no bit of it.
TEST_F(SessionTest, ASkyDoesNotDependOnThoseBefore) {
  Scene scene = map("earth-noon");
  const std::vector<float> first = session_->render(scene).rgb;
  scene.set("/sun/elevation_deg", "2");
  const std::vector<float> low = session_->render(scene).rgb;
  EXPECT_NE(low, first);
  session_->render(map("mars-like"));
  EXPECT_EQ(session_->render(scene).rgb, low);
  Session fresh;
  EXPECT_EQ(fresh.render(scene).rgb, low);
}

TEST_F(SessionTest, TheLastChangeCounts) {
  Scene scene = map("earth-noon");
  scene.set("/sun/elevation_deg", "2").set("/sun/elevation_deg", "11");
  EXPECT_TRUE(has(scene.json(), "\"elevation_deg\": 11")) << scene.json();
  scene.option("sun_elevation", "5");  // keys come after options, as on the command line
  EXPECT_TRUE(has(scene.json(), "\"elevation_deg\": 11"));
  const Scene copy = scene;
  scene.set("/sun/elevation_deg", "3");
  EXPECT_TRUE(has(copy.json(), "\"elevation_deg\": 11"));
}

TEST_F(SessionTest, LayersAddUpToThePicture) {
  const Image sky = session_->render(map("earth-sunset"), {.layers = "light"});
  std::vector<double> sum(sky.rgb.size());
  for (const airlight::Layer& layer : sky.layers) {
    const bool is_light = layer.channels == "RGB" && layer.name != "transmittance";
    for (std::size_t i = 0; is_light && i < sum.size(); ++i) {
      sum[i] += static_cast<double>(layer.planes[(i % 3) * sum.size() / 3 + i / 3]);
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    EXPECT_NEAR(sum[i], static_cast<double>(sky.rgb[i]), 5e-4 * static_cast<double>(sky.rgb[i])) << i;
  }
}

// Spectral radiance times the standard observer is the picture, where the wavelengths tell colours: Y by the published
// luminous efficiency (CIE 1924) against the luminance of red, green and blue. Measured: 1.6 % between blue sky
// and brown ground, since colours are adapted to a white sun, which keeps the luminance of grey alone.
TEST_F(SessionTest, ASpectrumIsThePicturesLight) {
  Scene scene = map("earth-noon");
  scene.option("size", "16x8");
  const Image sky = session_->render(scene, {.spectral = "380:780:10"});
  ASSERT_TRUE(sky.spectrum);
  const airlight::Spectrum& spectrum = *sky.spectrum;
  ASSERT_EQ(spectrum.nm.size(), 41U);
  ASSERT_EQ(spectrum.sunlight.size(), 41U);
  ASSERT_EQ(spectrum.planes.size(), 41U * 16U * 8U);
  EXPECT_EQ(spectrum.unit, "W.m^-2.sr^-1.nm^-1");
  const double efficiency[] = {0.000039, 0.00012, 0.000396, 0.00121, 0.004,   0.0116,   0.023,    0.038,    0.06,
                               0.09098,  0.13902, 0.20802,  0.323,   0.503,   0.71,     0.862,    0.954,    0.99495,
                               0.995,    0.952,   0.87,     0.757,   0.631,   0.503,    0.381,    0.265,    0.175,
                               0.107,    0.061,   0.032,    0.017,   0.00821, 0.004102, 0.002091, 0.001047, 0.00052,
                               0.000249, 0.00012, 0.00006,  0.00003, 0.000015};
  const auto luminance = [&](std::size_t pixel) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 41; ++k) {
      sum += efficiency[k] * static_cast<double>(spectrum.planes[k * 16 * 8 + pixel]);
    }
    return sum;
  };
  const auto of_colours = [&](std::size_t pixel) {
    return 0.2126 * static_cast<double>(sky.rgb[3 * pixel]) + 0.7152 * static_cast<double>(sky.rgb[3 * pixel + 1]) +
           0.0722 * static_cast<double>(sky.rgb[3 * pixel + 2]);
  };
  const double scale = luminance(25) / of_colours(25);
  for (const std::size_t pixel : {0U, 10U, 50U, 75U, 100U, 120U}) {
    EXPECT_NEAR(luminance(pixel) / of_colours(pixel), scale, 0.03 * scale) << pixel;
  }
  EXPECT_FALSE(session_->render(scene).spectrum);
  // Wavelengths too few for colours leave the picture as it is.
  EXPECT_EQ(session_->render(scene, {.spectral = "500:600:50"}).rgb, session_->render(scene).rgb);
}

// NREL's example of the solar position algorithm (Reda and Andreas 2003, table A5.1): 17 October 2003, 12:30:30 at
// 39.742476 N, 105.1786 W, 1830 m, 7 h behind UTC: topocentric zenith angle without refraction 50.12794 (its eq. 41),
// azimuth 194.34024.
TEST_F(SessionTest, TheSunStandsWhereItDoes) {
  Scene scene = map("earth");
  scene.option("date", "2003-10-17").option("time", "12:30:30").option("tz", "-07:00").option("lat", "39.742476");
  scene.option("lon", "-105.1786").option("place-altitude", "1.83014");
  const airlight::DirectionalLight sun = session_->irradiance(scene).sun;
  EXPECT_NEAR(sun.azimuth_deg, 194.34024, 0.01);
  // Seen through the air that bends light, a little higher than the true elevation of 39.8720.
  EXPECT_NEAR(sun.elevation_deg, 39.872, 0.03);
  scene.option("tz", "America/Denver").option("time", "13:30:30");  // summer time
  EXPECT_NEAR(session_->irradiance(scene).sun.azimuth_deg, 194.34024, 0.01);
}

TEST_F(SessionTest, RefusesPlacesAndSpectraInItsOwnWords) {
  using airlight::InputError;
  const auto refused = [](const std::vector<std::pair<std::string, std::string>>& options) {
    return message<InputError>([&] {
      Scene scene = map("earth");
      for (const auto& [name, value] : options) {
        scene.option(name, value);
      }
      scene.check();
    });
  };
  const std::string missing = refused({{"date", "2026-06-21"}, {"lat", "48"}});
  EXPECT_TRUE(has(missing, "the sun of a place needs time, lon as well")) << missing;
  EXPECT_FALSE(has(missing, "--")) << missing;
  const std::vector<std::pair<std::string, std::string>> moment = {
      {"date", "2026-06-21"}, {"time", "12:00"}, {"lat", "48"}, {"lon", "2"}};
  auto both = moment;
  both.emplace_back("sun_elevation", "4");
  EXPECT_TRUE(has(refused(both), "sun_elevation and date both say where the sun stands")) << refused(both);
  auto zone = moment;
  zone.emplace_back("tz", "Europe/Pari");
  EXPECT_TRUE(has(refused(zone), "tz: no time zone 'Europe/Pari'; did you mean 'Europe/Paris'?")) << refused(zone);
  auto lifted = moment;
  lifted.emplace_back("refraction", "true");
  EXPECT_TRUE(has(refused(lifted), "refraction: the preset's air bends light itself")) << refused(lifted);
  EXPECT_TRUE(has(refused({{"refraction", "yes"}}), "neither true nor false"));
  EXPECT_TRUE(has(refused({{"latt", "4"}}), "did you mean 'lat'?"));
  const auto of_spectrum = [](const std::string& preset, const std::string& spectral) {
    return message<InputError>([&] { session_->render(map(preset), {.spectral = spectral}); });
  };
  EXPECT_TRUE(has(of_spectrum("earth", "380:780"), "spectral: '380:780' is not FIRST:LAST:STEP"));
  EXPECT_TRUE(has(of_spectrum("earth-hillaire2020", "380:780:10"), "three channels and no spectra"));
}

// The mean of the irradiance over all normals is a quarter of the integral of radiance, which the first harmonic holds.
TEST_F(SessionTest, IrradianceHoldsTheLightOfTheSphere) {
  const Scene scene = map("earth-physical");
  const airlight::Irradiance light = session_->irradiance(scene);
  ASSERT_EQ(light.map.width, 64);
  ASSERT_EQ(light.map.height, 32);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    double weights = 0.0;
    for (int y = 0; y < light.map.height; ++y) {
      const double weight = std::cos(M_PI * ((y + 0.5) / light.map.height - 0.5));
      for (int x = 0; x < light.map.width; ++x) {
        sum += weight * static_cast<double>(light.map.at(x, y)[c]);
        weights += weight;
      }
    }
    EXPECT_NEAR(sum / weights, light.harmonics[0][c] * std::sqrt(4.0 * M_PI) / 4.0, 2e-3 * sum / weights);
    EXPECT_LT(light.sun.irradiance[c], light.sun.irradiance_above_air[c]);
  }
  EXPECT_NEAR(light.sun.direction[1], std::sin(light.sun.elevation_deg * M_PI / 180.0), 1e-9);
  EXPECT_FALSE(light.moon);
}

TEST_F(SessionTest, RefusesInWords) {
  using airlight::InputError;
  EXPECT_TRUE(has(message<InputError>([] { session_->load("earth-non"); }), "did you mean 'earth-noon'?"));
  EXPECT_TRUE(has(message<InputError>([] { session_->load("/nowhere/sky.json"); }), "/nowhere/sky.json"));
  EXPECT_TRUE(has(message<InputError>([] { map("earth").option("sun-elevatoin", "4"); }),
                  "unknown option 'sun-elevatoin' (did you mean 'sun-elevation'?)"));
  EXPECT_TRUE(has(message<InputError>([] { map("earth").option("sun-elevation", "low"); }), "'low' is no number"));
  EXPECT_TRUE(has(message<InputError>([] { map("earth").option("size", "64").check(); }), "is not WIDTHxHEIGHT"));
  EXPECT_TRUE(has(message<InputError>([] { map("earth").set("sun", "4"); }), "set sun=4"));
  const std::string problems = message<InputError>(
      [] { map("earth").option("sun_elevation", "400").set("/planet/ground_albedo", "7").check(); });
  EXPECT_TRUE(has(problems, "sun_elevation=400")) << problems;
  EXPECT_TRUE(has(problems, "/planet/ground_albedo")) << problems;
  EXPECT_TRUE(
      has(message<InputError>([] { session_->render(map("earth"), {.layers = "lihgt"}); }), "did you mean 'light'?"));
  EXPECT_TRUE(
      has(message<InputError>([] { session_->render(map("earth").option("method", "march"), {.layers = "light"}); }),
          "march does not tell its light apart"));
  EXPECT_TRUE(has(message<InputError>([] {
                    session_->probe(map("earth"), std::array{airlight::Direction{91, 0}});
                  }),
                  "number 0 has elevation 91"));
  EXPECT_TRUE(has(message<InputError>([] { session_->parse("{\"airlight\": 1, \"extends\": \"earth\",}"); }), "text"));
}

TEST_F(SessionTest, ReadsNoPicturesOfAPreset) {
  Scene scene = map("earth");
  scene.set("/planet/albedo_map", "\"somewhere.exr\"");
  const std::string refused = message<airlight::InputError>([&] { scene.check(); });
  EXPECT_TRUE(has(refused, "/planet/albedo_map")) << refused;
  EXPECT_TRUE(has(refused, "libairlight reads no pictures")) << refused;
  scene = map("earth");
  scene.set("/clouds", R"([{"type": "volume", "file": "heap.vdb"}])");
  EXPECT_TRUE(has(message<airlight::InputError>([&] { scene.check(); }), "libairlight reads no files of OpenVDB"));
}

TEST_F(SessionTest, ADeviceThatIsNotThereIsAnInputError) {
  Session nowhere({.device = "no such device", .cache_folder = "", .threads = 0});
  EXPECT_TRUE(has(message<airlight::InputError>([&] { nowhere.device(); }), "no such device"));
}

TEST_F(SessionTest, ProgressEndsARenderAndTheSessionGoesOn) {
  for (const char* method : {"orders", "path-trace"}) {
    Scene scene = map("earth-noon").option("method", method);
    if (scene.json().find("path-trace") != std::string::npos) {
      scene.option("samples", "64");
    }
    int calls = 0;
    double last = -1.0;
    const auto stop = [&](double done) {
      EXPECT_GE(done, last);
      last = done;
      ++calls;
      return false;
    };
    const std::string refused = message<airlight::RunError>([&] { session_->render(scene, {.progress = stop}); });
    EXPECT_EQ(refused, "the render was stopped") << method;
    EXPECT_GT(calls, 0) << method;
    const std::vector<float> whole = session_->render(map("earth-noon")).rgb;
    EXPECT_GT(*std::ranges::max_element(whole), 0.0F);
  }
}

TEST(Library, KnowsItsVersionAndPresets) {
  EXPECT_EQ(airlight::version(), std::to_string(AIRLIGHT_VERSION_MAJOR) + "." + std::to_string(AIRLIGHT_VERSION_MINOR) +
                                     "." + std::to_string(AIRLIGHT_VERSION_PATCH));
  const std::vector<std::string> names = airlight::presets();
  EXPECT_NE(std::ranges::find(names, "earth-noon"), names.end());
  EXPECT_TRUE(has(airlight::preset_text("earth-noon"), "\"media\""));
  const std::vector<std::string> options = airlight::option_names();
  EXPECT_NE(std::ranges::find(options, "sun-elevation"), options.end());
}

// Files below a folder.
std::ptrdiff_t files_in(const fs::path& folder) {
  std::ptrdiff_t count = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    count += entry.is_regular_file() ? 1 : 0;
  }
  return count;
}

TEST(Library, WritesOnlyWhereItIsTold) {
  std::string name = (fs::temp_directory_path() / "airlight-library-XXXXXX").string();
  const fs::path home = ::mkdtemp(name.data());
  const char* const before = std::getenv("HOME");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("HOME", home.c_str(), 1);
  ::setenv("XDG_CACHE_HOME", (home / "cache").c_str(), 1);
  ::unsetenv("AIRLIGHT_CACHE");
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  const auto render = [](const std::string& folder) {
    Session session({.device = "", .cache_folder = folder, .threads = 0});
    Scene scene = session.load("mars-like");
    scene.option("size", "8x6");
    session.render(scene);
  };
  render("");
  EXPECT_EQ(files_in(home), 0);
  render((home / "told").string());
  EXPECT_GT(files_in(home / "told"), 0);
  EXPECT_EQ(files_in(home), files_in(home / "told"));
  ::setenv("HOME", kept.c_str(), 1);
  fs::remove_all(home);
}

}  // namespace
