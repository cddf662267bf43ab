// Spectral radiance at listed wavelengths, by every method.

#include "core/render/spectrum.h"

#include <cmath>

#include "core/scene/photometry.h"
#include "core/spectra/data.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

Rendering spectrum_now(const Scene& scene, const Nodes& nodes) {
  return render_now(scene, {.spectrum = nodes});
}

SpectralProbes spectra_now(const Scene& scene, const std::vector<Direction>& directions, const Nodes& nodes) {
  return probe_spectrum([]() -> Executor& { return executor(); }, scene, directions, nodes);
}

Nodes every(double first, double last, double step) {
  std::vector<double> nm;
  for (double x = first; x <= last + 1e-6; x += step) {
    nm.push_back(x);
  }
  return listed_nodes(nm, std::min(step, 10.0));
}

// At each wavelength the picture is that of three channels with that wavelength's coefficients, disc included, times
// the sunlight there. With four wavelengths one group is whole and one is filled up.
TEST(Spectrum, EachWavelengthIsAPictureOfItsOwn) {
  const std::vector<double> nm{420.0, 500.0, 580.0, 660.0};
  const auto coefficient = [&](std::size_t k) { return 0.01 * (1.0 + static_cast<double>(k)); };
  const std::string curve =
      R"({"wavelengths_nm": [414, 426, 494, 506, 574, 586, 654, 666],
          "values": [0.01, 0.01, 0.02, 0.02, 0.03, 0.03, 0.04, 0.04]})";
  for (const SkyMethod& method : methods()) {
    const Scene scene =
        with_method(scene_of(clear_air(curve, R"({"elevation_deg": 10, "irradiance": 2})")), method, true);
    const Rendering found = spectrum_now(scene, listed_nodes(nm, 10.0));
    ASSERT_EQ(found.fault(), "") << method.info.name;
    ASSERT_TRUE(found.spectrum);
    ASSERT_EQ(found.spectrum->planes.size(), nm.size());
    EXPECT_EQ(found.spectrum->unit, "W.m^-2.sr^-1.nm^-1");
    for (std::size_t k = 0; k < nm.size(); ++k) {
      const double sun = 2.0 * mean_over(solar_irradiance(), nm[k] - 5.0, nm[k] + 5.0);
      EXPECT_NEAR(found.spectrum->sunlight[k] / sun, 1.0, 1e-12);
      const Scene plain =
          with_method(scene_of(clear_air(std::to_string(coefficient(k)), R"({"elevation_deg": 10})")), method, true);
      const RadianceImage expected = render_now(plain).radiance;
      double sum = 0.0;
      double expected_sum = 0.0;
      for (std::size_t i = 0; i < found.spectrum->planes[k].size(); ++i) {
        const double value = static_cast<double>(found.spectrum->planes[k][i]) / sun;
        const auto other = static_cast<double>(expected.rgba[4 * i]);
        sum += value;
        expected_sum += other;
        if (on_device(method)) {
          ASSERT_NEAR(value, other, 1e-5 * other + 1e-9) << method.info.name << ", " << nm[k] << " nm, pixel " << i;
        }
      }
      // Walks with other random numbers agree in the mean.
      EXPECT_NEAR(sum / expected_sum, 1.0, on_device(method) ? 1e-5 : 0.02) << method.info.name << ", " << nm[k];
    }
  }
}

// Straight up through air of a known column, and the same by the probe of three channels.
TEST(Spectrum, ProbeTellsTransmittanceByWavelength) {
  const Scene scene = scene_of(
      clear_air(R"({"named": "air"})", R"({"elevation_deg": 30})", R"(, "render": {"method": "march", "steps": 256})"));
  const Nodes nodes = every(400.0, 700.0, 60.0);
  const SpectralProbes found = spectra_now(scene, {{1.5707963, 0.0}}, nodes);
  const double column = 8.0 * (1.0 - std::exp(-12.5));
  for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
    const double depth = column * mean_over(scene.media[0].scattering.curve, nodes.nm[k] - 5.0, nodes.nm[k] + 5.0);
    EXPECT_NEAR(found.directions[0].transmittance[k] / std::exp(-depth), 1.0, 2e-4) << nodes.nm[k];
  }
  EXPECT_GT(found.directions[0].radiance.front() / found.wavelengths.sunlight.front(),
            3.0 * found.directions[0].radiance.back() / found.wavelengths.sunlight.back())
      << "a sky is blue";
}

// With a unit, and D65 as white, the spectrum has the luminance of its colour: 683 lm/W times the integral over y.
// (Sunlight as white changes the channels' ratio, and with it the luminance of any other light.)
TEST(Spectrum, AbsoluteUnitsAgreeWithLuminance) {
  for (const char* sun :
       {R"({"elevation_deg": 20, "irradiance": 1361, "unit": "W/m2", "disc": {"visible": false}})",
        R"({"elevation_deg": 20, "irradiance": 128000, "unit": "lux", "spectrum": {"black_body_k": 4000},
            "disc": {"visible": false}})"}) {
    Scene scene = scene_of(clear_air(R"({"named": "air"})", sun, R"(, "render": {"method": "march"})"));
    scene.spectra->white = White::d65;
    const Nodes nodes = every(380.0, 780.0, 10.0);
    const Rendering found = spectrum_now(scene, nodes);
    EXPECT_EQ(found.spectrum->unit, "W.m^-2.sr^-1.nm^-1");
    EXPECT_TRUE(found.spectrum->tells_colours);
    for (const std::size_t pixel : {std::size_t{3}, std::size_t{40}, std::size_t{120}}) {
      double lumens = 0.0;
      for (std::size_t k = 0; k < nodes.nm.size(); ++k) {
        lumens += 683.002 * 10.0 * value_at(observer().y, nodes.nm[k]) *
                  static_cast<double>(found.spectrum->planes[k][pixel]);
      }
      const float* rgb = &found.radiance.rgba[4 * pixel];
      const double luminance =
          *white_luminance(scene.sun.unit) *
          bt709_luminance({static_cast<double>(rgb[0]), static_cast<double>(rgb[1]), static_cast<double>(rgb[2])});
      EXPECT_NEAR(lumens / luminance, 1.0, 3e-3) << pixel;
    }
  }
}

// A lamp's spectrum is a shape in the preset's own numbers.
TEST(Spectrum, RelativeUnitsAreThePresets) {
  const Scene scene = scene_of(clear_air("0.02", R"({"spectrum": {"black_body_k": 3000}, "irradiance": 3})"));
  EXPECT_EQ(spectral_unit(scene).name, "sun.spectrum.sr^-1");
  EXPECT_EQ(spectral_unit(scene).scale, 1.0);
}

// With too few wavelengths for colours the picture is the one without a spectrum, to the bit; with many it agrees with
// the exact sum of all 48.
TEST(Spectrum, PictureIsTheIntegralOrTheScenesOwn) {
  const Scene scene = scene_of(clear_air(R"({"named": "air"})", R"({"elevation_deg": 2})",
                                         R"(, "render": {"method": "march", "wavelengths": 48})"));
  const RadianceImage own = render_now(scene).radiance;
  const Rendering few = spectrum_now(scene, every(500.0, 600.0, 50.0));
  EXPECT_FALSE(few.spectrum->tells_colours);
  EXPECT_EQ(few.radiance.rgba, own.rgba);
  const Rendering many = spectrum_now(scene, every(380.0, 780.0, 10.0));
  EXPECT_TRUE(many.spectrum->tells_colours);
  for (std::size_t i = 0; i < own.rgba.size(); ++i) {
    ASSERT_NEAR(many.radiance.rgba[i], own.rgba[i], 3e-3 * std::fabs(own.rgba[i]) + 1e-7) << i;
  }
}

}  // namespace
}  // namespace airlight::test
