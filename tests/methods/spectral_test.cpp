// Scenes with curves over the wavelength, by every method.

#include <cmath>

#include "core/methods/spectral_sky.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/methods/render_fixture.h"

namespace airlight::test {
namespace {

Scene scene_of(const std::string& text) {
  return resolve(parse_preset(text, "test", {}), method_infos());
}

std::string with(const std::string& scattering, const std::string& sun, const std::string& extra = "") {
  return R"({"airlight": 1, "planet": {"ground_albedo": 0.3}, "media": [{"name": "air", "scattering_per_km": )" +
         scattering + R"(, "density": {"profile": "exponential", "scale_height_km": 8},
          "phase": {"function": "rayleigh"}}], "sun": )" +
         sun + R"(, "camera": {"projection": "equirectangular"}, "image": {"width": 16, "height": 8})" + extra + "}";
}

// Where nothing depends on the wavelength the colour is that of the sun, whatever the number of wavelengths: the
// picture of three channels, disc and all.
TEST(Spectral, GreyIsGrey) {
  const Scene grey = scene_of(with("0.02", R"({"elevation_deg": 10, "irradiance": 2})"));
  const Scene six = scene_of(with("0.02", R"({"elevation_deg": 10, "irradiance": 2, "spectrum": {"named": "solar"}})",
                                  R"(, "render": {"wavelengths": 5})"));
  for (const SkyMethod& method : methods()) {
    const bool exact = method.render_on_host == nullptr;
    const Scene one = with_method(grey, method, true);
    const Scene all = with_method(six, method, true);
    const Rendering expected = render_now(one);
    const Rendering found = render_now(all);
    ASSERT_EQ(found.fault(), "") << method.info.name;
    double worst = 0.0;
    double sum = 0.0;
    double expected_sum = 0.0;
    for (std::size_t i = 0; i < expected.radiance.rgba.size(); ++i) {
      const auto a = static_cast<double>(expected.radiance.rgba[i]);
      const auto b = static_cast<double>(found.radiance.rgba[i]);
      worst = std::max(worst, std::fabs(a - b) / std::max(a, 1e-6));
      sum += b;
      expected_sum += a;
    }
    // Sums of five in floats; walks of other seeds meet in the mean.
    EXPECT_LT(exact ? worst : std::fabs(sum / expected_sum - 1.0), exact ? 2e-5 : 0.02) << method.info.name;
    const std::vector<Direction> up{{1.0, 0.3}};
    EXPECT_NEAR(probe_now(all, up)[0].transmittance[1] / probe_now(one, up)[0].transmittance[1], 1.0, 1e-5)
        << method.info.name;
  }
}

// The sun through a vertical of air, at every tenth nanometre: exp(-column x scattering), summed by CIE 1931.
TEST(Spectral, TransmittanceIsTheSunsColour) {
  const Scene scene = scene_of(
      with(R"({"named": "air"})", R"({"elevation_deg": 10})", R"(, "render": {"method": "march", "wavelengths": 6})"));
  const double column = 8.0 * (1.0 - std::exp(-12.5));
  const BandColours colours = band_colours(scene.spectra->sun, White::sun);
  std::array<double, kFineBands> through{};
  for (std::size_t b = 0; b < through.size(); ++b) {
    const double nm = 0.5 * (fine_bands()[b].low + fine_bands()[b].high);
    through[b] = std::exp(-column * value_at(scene.spectra->media[0].scattering, nm));
  }
  const Rgb expected = colour_of(colours, through);
  const ProbeResult found = probe_now(scene, {{1.5707963, 0.0}}).front();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(found.transmittance[c] / expected[c], 1.0, 2e-3) << c;
  }
}

// Sunlight scattered once by the reference's adaptive quadrature, at all 48 wavelengths, is the truth of the colours
// that a few wavelengths give: the judge shares neither nodes nor matrix.
TEST(Spectral, FewWavelengthsComeCloseToAll) {
  const std::string extra = R"(, "render": {"method": "path-trace", "max_orders": 1, "wavelengths": )";
  const std::vector<Direction> directions{{0.03, 0.2}, {0.3, 1.0}, {1.0, 3.0}, {1.5, 0.0}, {0.1, 3.1}};
  for (const char* elevation : {"40", "5", "-3"}) {
    const auto probes = [&](int count) {
      const std::string sun = "{\"elevation_deg\": " + std::string(elevation) + "}";
      return probe_now(scene_of(with(R"({"named": "air"})", sun, extra + std::to_string(count) + "}")), directions);
    };
    const std::vector<ProbeResult> truth = probes(48);
    const auto error = [&](const std::vector<ProbeResult>& found) {
      double sum = 0.0;
      int lit = 0;
      for (std::size_t i = 0; i < truth.size(); ++i) {
        for (std::size_t c = 0; c < 3 && truth[i].radiance[1] > 0.0; ++c, ++lit) {
          sum += std::fabs(found[i].radiance[c] / truth[i].radiance[c] - 1.0);
        }
      }
      return sum / std::max(lit, 1);
    };
    EXPECT_LT(error(probes(6)), 0.004) << elevation;
    EXPECT_LT(error(probes(4)), 0.01) << elevation;
    EXPECT_LT(error(probes(3)), 0.03) << elevation;
  }
}

// The sun of a lamp of 3000 K is white where white is the sun, and orange under D65; twice the light is twice as
// bright.
TEST(Spectral, WhiteIsWhatThePresetSays) {
  const auto light = [](const std::string& white, double irradiance) {
    const Scene scene = scene_of(R"({"airlight": 1, "media": [{"name": "air", "scattering_per_km": 0.02,
      "density": {"profile": "exponential", "scale_height_km": 8}}], "image": {"width": 8, "height": 8, "white": ")" +
                                 white + R"("}, "render": {"method": "march", "wavelengths": 6},
      "sun": {"spectrum": {"black_body_k": 3000}, "irradiance": )" +
                                 std::to_string(irradiance) + "}}");
    return probe_now(scene, {{0.7, 0.3}}).front();
  };
  const ProbeResult sun = light("sun", 1.0);
  EXPECT_NEAR(sun.radiance[0] / sun.radiance[2], 1.0, 1e-5);
  const ProbeResult warm = light("D65", 1.0);
  EXPECT_GT(warm.radiance[0], 3.0 * warm.radiance[2]);
  EXPECT_NEAR(warm.transmittance[0], sun.transmittance[0], 1e-5);
  EXPECT_NEAR(light("D65", 2.0).radiance[0] / warm.radiance[0], 2.0, 1e-5);
}

// Light from 640 nm on is redder than Rec.709's red: negative channels of a positive luminance are no fault.
TEST(Spectral, ColoursOutsideTheSpaceAreNoFault) {
  const Scene scene =
      scene_of(with(R"(0.02, "absorption_per_km": {"wavelengths_nm": [630, 640], "values": [1, 0]})",
                    R"({"elevation_deg": 30})", R"(, "render": {"method": "march", "wavelengths": 24})"));
  const Rendering rendering = render_now(scene);
  EXPECT_EQ(rendering.fault(), "");
  EXPECT_GT(rendering.picture.outside, 0u);
}

}  // namespace
}  // namespace airlight::test
