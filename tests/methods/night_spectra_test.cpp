// The night by wavelength: the zenith of Paranal in published bands, and spectra against colours.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/night/background.h"
#include "core/night/stars.h"
#include "core/render/spectrum.h"
#include "core/spectra/data.h"
#include "tests/methods/paranal.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// A band of Bessell's, Publications of the Astronomical Society of the Pacific 102 (1990) 1181, every 20 nm, and the
// sun's magnitude in it: V -26.76, B - V 0.65.
struct PhotometricBand {
  double first_nm;
  std::vector<double> response;
  double sun;
};
const PhotometricBand kBandV{
    480.0, {0.030, 0.458, 0.967, 0.973, 0.792, 0.574, 0.359, 0.197, 0.081, 0.025, 0.013}, -26.76};
const PhotometricBand kBandB{360.0, {0.0, 0.134, 0.920, 0.978, 0.853, 0.640, 0.423, 0.235, 0.079, 0.008}, -26.11};

std::vector<double> band_wavelengths(const PhotometricBand& band) {
  std::vector<double> nm;
  for (std::size_t i = 0; i < band.response.size(); ++i) {
    nm.push_back(band.first_nm + 20.0 * static_cast<double>(i));
  }
  return nm;
}

Scene twilight_at_paranal(double sun_elevation_deg) {
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/paranal.json"), method_infos());
  scene.sun.elevation = sun_elevation_deg * kDegree;
  scene.night_sky.reset();
  scene.stars.reset();
  return scene;
}

constexpr double kSquareSecond = std::numbers::pi / 180.0 / 3600.0 * (std::numbers::pi / 180.0 / 3600.0);

// Magnitudes a square arc second of sunlight at the zenith of the preset `paranal`.
double twilight_magnitude(double sun_elevation_deg, const PhotometricBand& band) {
  const std::vector<double> nm = band_wavelengths(band);
  const SpectralProbes found =
      probe_spectrum([]() -> Executor& { return executor(); }, twilight_at_paranal(sun_elevation_deg),
                     {{0.5 * std::numbers::pi, 0.0}}, listed_nodes(nm, 10.0));
  double sky = 0.0;
  double sun = 0.0;
  for (std::size_t i = 0; i < nm.size(); ++i) {
    sky += band.response[i] * nm[i] * found.directions.front().radiance[i];
    sun += band.response[i] * nm[i] * found.wavelengths.sunlight[i];
  }
  return band.sun - 2.5 * std::log10(sky / sun * kSquareSecond);
}

double with_dark_sky(double magnitude, double dark) {
  return -2.5 * std::log10(std::pow(10.0, -0.4 * magnitude) + std::pow(10.0, -0.4 * dark));
}

// Patat, Ugolnikov and Postylyakov, Astronomy and Astrophysics 455 (2006) 385: the zenith at Paranal in V as the sun
// goes down, twilight and the dark sky's 21.52 together. core/NIGHT.md says what each part of that air does.
TEST(NightSky, HasParanalsTwilight) {
  const std::vector<std::pair<double, double>> measured{{-9.062, 17.04},  {-10.022, 17.86}, {-10.926, 18.72},
                                                        {-11.885, 19.51}, {-12.844, 20.25}, {-13.746, 20.78},
                                                        {-14.816, 21.19}};
  double sum = 0.0;
  for (const auto& [sun, magnitude] : measured) {
    const double off = with_dark_sky(twilight_magnitude(sun, kBandV), 21.52) - magnitude;
    EXPECT_LT(std::abs(off), 0.25) << sun << " " << off;
    sum += std::abs(off) / static_cast<double>(measured.size());
  }
  EXPECT_LT(sum, 0.15);
}

// The same in B, of which nothing was fitted: their parabola through what was measured between 95 and 105 degrees from
// the zenith (table 4), and the dark sky's 22.6.
TEST(NightSky, HasParanalsTwilightInBlue) {
  double sum = 0.0;
  for (const double sun : {-9.0, -11.0, -13.0}) {
    const double beyond = -sun - 5.0;
    const double measured = 11.84 + 1.411 * beyond - 0.041 * beyond * beyond;
    const double off = with_dark_sky(twilight_magnitude(sun, kBandB), 22.6) - measured;
    EXPECT_LT(std::abs(off), 0.25) << sun << " " << off;
    sum += std::abs(off) / 3.0;
  }
  EXPECT_LT(sum, 0.15);
}

// At 9 degrees nearly all light of the zenith was scattered twice: first by the stratosphere's aerosol, seen from the
// side. The 2.3 % of path-trace's noise are in the bound.
TEST(NightSky, OfPathTraceHasTheSameTwilight) {
  const std::vector<double> nm{530.0};
  const auto zenith = [&](const char* method) {
    Scene scene = with_method(twilight_at_paranal(-9.062), *find_method(method));
    if (scene.render.method == "path-trace") {
      scene.render.parameters["samples"] = 20000;
    }
    return probe_spectrum([]() -> Executor& { return executor(); }, scene, {{0.5 * std::numbers::pi, 0.0}},
                          listed_nodes(nm, 10.0))
        .directions.front()
        .radiance.front();
  };
  EXPECT_NEAR(zenith("orders") / zenith("path-trace"), 1.0, 0.06);
}

// Every 10 nm, next to one another, so that no line of the airglow falls between them.
Nodes gapless(double first, double last) {
  std::vector<double> nm;
  for (double at = first; at <= last; at += 10.0) {
    nm.push_back(at);
  }
  return listed_nodes(nm, 10.0);
}

double response_at(const PhotometricBand& band, double nm) {
  const double x = (nm - band.first_nm) / 20.0;
  if (x < 0.0 || x > static_cast<double>(band.response.size() - 1)) {
    return 0.0;
  }
  const auto i = std::min(static_cast<std::size_t>(x), band.response.size() - 2);
  const double u = x - static_cast<double>(i);
  return band.response[i] * (1.0 - u) + band.response[i + 1] * u;
}

// Magnitude of a light in a band, of its spectrum and the sun's in one unit.
double magnitude_in(const PhotometricBand& band, const std::vector<double>& nm, const std::vector<double>& light,
                    const std::vector<double>& sunlight) {
  double sum = 0.0;
  double sun = 0.0;
  for (std::size_t i = 0; i < nm.size(); ++i) {
    sum += response_at(band, nm[i]) * nm[i] * light[i];
    sun += response_at(band, nm[i]) * nm[i] * sunlight[i];
  }
  return band.sun - 2.5 * std::log10(sum / sun);
}

SpectralProbes zenith_of(const Scene& scene, const Nodes& nodes) {
  return probe_spectrum([]() -> Executor& { return executor(); }, scene, {{0.5 * std::numbers::pi, 0.0}}, nodes);
}

TEST(NightSpectra, OfTheZenithAreAsDarkAsParanals) {
  // They are measured between the stars.
  for (const char* method : {"orders", "path-trace"}) {
    Scene scene = with_method(paranal(-40.0), *find_method(method), true);
    scene.night_sky->starlight = 0.0;
    const Nodes nodes = gapless(370.0, 660.0);
    const SpectralProbes found = zenith_of(scene, nodes);
    const auto magnitude = [&](const PhotometricBand& band) {
      return magnitude_in(band, nodes.nm, found.directions.front().radiance, found.wavelengths.sunlight) -
             2.5 * std::log10(kSquareSecond);
    };
    RecordProperty(std::string(method) + ", V", std::to_string(magnitude(kBandV)));
    RecordProperty(std::string(method) + ", B", std::to_string(magnitude(kBandB)));
    EXPECT_NEAR(magnitude(kBandV), 21.5, 0.3) << method;
    EXPECT_NEAR(magnitude(kBandB), 22.6, 0.3) << method;
  }
}

// Planes times the observer's curves, each band's mean, in linear Rec.709 with the sun as white.
std::vector<Rgb> integrated(const SpectralImage& spectrum) {
  const Observer& eye = observer();
  const auto rgb_of = [&](const auto& value) {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    for (std::size_t k = 0; k < spectrum.nm.size(); ++k) {
      const double low = spectrum.nm[k] - 5.0;
      const double high = spectrum.nm[k] + 5.0;
      x += value(k) * mean_over(eye.x, low, high);
      y += value(k) * mean_over(eye.y, low, high);
      z += value(k) * mean_over(eye.z, low, high);
    }
    return Rgb{3.2409699 * x - 1.5373832 * y - 0.4986108 * z, -0.9692436 * x + 1.8759675 * y + 0.0415551 * z,
               0.0556301 * x - 0.2039770 * y + 1.0569715 * z};
  };
  const Rgb sun = rgb_of([&](std::size_t k) { return spectrum.sunlight[k]; });
  std::vector<Rgb> pixels;
  for (std::size_t i = 0; i < spectrum.planes.front().size(); ++i) {
    Rgb colour = rgb_of([&](std::size_t k) { return double{spectrum.planes[k][i]}; });
    for (std::size_t c = 0; c < 3; ++c) {
      colour[c] *= kSunlight / sun[c];
    }
    pixels.push_back(colour);
  }
  return pixels;
}

// A moonless night with all that shines in it, mean over the picture of each pixel's error.
TEST(NightSpectra, AddUpToThePicture) {
  Scene scene = all_round(with_method(paranal(-40.0), *find_method("orders"), true), 0.5, 24, 12);
  scene.stars = Stars{};
  for (const NightSky& sky :
       {NightSky{.light_pollution = 0.001, .lamps = Lamps::led},
        NightSky{.airglow = 0.0, .zodiacal = 0.0, .starlight = 0.0, .light_pollution = 0.01, .lamps = Lamps::sodium}}) {
    scene.night_sky = sky;
    const RadianceImage picture = render_now(scene).radiance;
    RenderRequest request;
    request.spectrum = gapless(360.0, 830.0);
    SpectralImage spectrum;
    BandsRequest bands{.picture = request, .sink = [&](Band& band) { spectrum = std::move(*band.rows.spectrum); }};
    render_spectrum([]() -> Executor& { return executor(); }, ready(scene), bands);
    const std::vector<Rgb> colours = integrated(spectrum);
    double sum = 0.0;
    for (std::size_t i = 0; i < colours.size(); ++i) {
      double most = 0.0;
      double off = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        most = std::max(most, double{picture.rgba[4 * i + c]});
        off = std::max(off, std::abs(colours[i][c] - double{picture.rgba[4 * i + c]}));
      }
      ASSERT_GT(most, 0.0) << i;
      sum += off / most / static_cast<double>(colours.size());
    }
    RecordProperty("mean_error", std::to_string(sum));
    EXPECT_LT(sum, 0.02);
  }
}

Scene without_air(Scene scene) {
  for (Medium& medium : scene.media) {
    medium.scattering = {};
    medium.absorption = {};
  }
  return scene;
}

// W/(m2 nm sr), in its lines and between them.
TEST(NightSpectra, OfAirglowAreThePublishedOnes) {
  Scene scene = without_air(paranal(-40.0));
  scene.night_sky = NightSky{.airglow = 1.0, .zodiacal = 0.0, .starlight = 0.0};
  const Nodes nodes = gapless(500.0, 640.0);
  const SpectralProbes found = zenith_of(scene, nodes);
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    const double published = mean_over(airglow(), nodes.bands[k].low, nodes.bands[k].high);
    EXPECT_NEAR(found.directions.front().radiance[k] / published, 1.0, 2e-3) << nodes.nm[k];
  }
}

// Leinert's stars of 10th magnitude a square degree hold at 500 nm; 0.9 and 0.6 a decade below and above.
TEST(NightSpectra, OfZodiacalLightAreALittleRedderThanTheSuns) {
  Scene scene = without_air(paranal(-40.0));
  scene.night_sky = NightSky{.airglow = 0.0, .zodiacal = 1.0, .starlight = 0.0};
  const Nodes nodes = listed_nodes({400.0, 500.0, 700.0}, 10.0);
  const SpectralProbes found = zenith_of(scene, nodes);
  const auto over_sun = [&](std::size_t k) {
    return found.directions.front().radiance[k] / found.wavelengths.sunlight[k];
  };
  EXPECT_NEAR(over_sun(0) / over_sun(1), 1.0 + 0.9 * std::log10(0.8), 1e-3);
  EXPECT_NEAR(over_sun(2) / over_sun(1), 1.0 + 0.6 * std::log10(1.4), 1e-3);
}

// Stars by their spectra have the magnitudes of the catalogue in V. In B a black body is up to a quarter of a magnitude
// too bright for a red giant.
TEST(NightSpectra, OfStarsHaveTheirMagnitudes) {
  Scene scene = paranal(-40.0);
  scene.stars = Stars{};
  const Stage stage = ready(scene);
  const Nodes nodes = gapless(360.0, 720.0);
  std::vector<std::vector<double>> light(10, std::vector<double>(nodes.nm.size()));
  std::vector<double> sunlight(nodes.nm.size());
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    const std::vector<WaveBand> band(3, nodes.bands[k]);
    const Night night = night_of(scene, {{stage.whole().air}, {}}, band);
    sunlight[k] = at_node(scene.spectra->sun, nodes, k);
    for (std::size_t i = 0; i < light.size(); ++i) {
      light[i][k] = night.stars[i].irradiance.y * sunlight[k] / kSunlight;
    }
  }
  for (std::size_t i = 0; i < light.size(); ++i) {
    const CatalogueStar& star = bright_stars()[i];
    const double v = magnitude_in(kBandV, nodes.nm, light[i], sunlight);
    const double b = magnitude_in(kBandB, nodes.nm, light[i], sunlight);
    EXPECT_NEAR(v, star.magnitude, 0.05) << star_name(star);
    EXPECT_NEAR(b - v, star.colour, 0.25) << star_name(star);
  }
}

}  // namespace
}  // namespace airlight::test
