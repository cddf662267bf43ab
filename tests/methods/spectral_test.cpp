// Scenes with curves over the wavelength, by every method.

#include <cmath>

#include "core/render/layers.h"
#include "core/render/sky.h"
#include "core/render/spans.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "core/stage/wavelengths.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// Night in thin low air, and the sun under a planet of fog: sampled light so small that its square is 0, to which no
// matrix can be fitted.
TEST(Spectral, ASkyWithoutLightHasAMatrix) {
  const std::string night = R"({"airlight": 1, "media": [{"name": "m0", "density": {"profile": "exponential",
      "scale_height_km": 0.05}, "scattering_per_km": {"at_nm": 550, "value": 2.7919085376757803e-05, "exponent": -1.3}}],
      "sun": {"elevation_deg": -4}})";
  const std::string fog = R"({"airlight": 1, "planet": {"radius_km": 100}, "media": [{"name": "m0", "density":
      {"profile": "height-fog", "scale_height_km": 0.1, "base_km": 0}, "scattering_per_km": 1000}, {"name": "m1",
      "density": {"profile": "height-fog", "scale_height_km": 1e7, "base_km": 1}, "scattering_per_km":
      {"named": "air", "scale": 1}}], "sun": {"elevation_deg": -90}, "render": {"method": "analytic"}})";
  for (const std::string& text : {night, fog}) {
    const Stage stage = ready(scene_of(text));
    for (const Rgb& colour : stage.basis().matrix) {
      EXPECT_TRUE(std::isfinite(colour[0] + colour[1] + colour[2])) << text;
    }
  }
  Scene scene = scene_of(night);
  scene.image = {8, 8};
  EXPECT_EQ(render_now(scene).fault(), "");
}

// Where nothing depends on the wavelength the colour is the sun's, whatever the number of wavelengths: the picture of
// three channels, disc included.
TEST(Spectral, GreyIsGrey) {
  const Scene grey = scene_of(clear_air("0.02", R"({"elevation_deg": 10, "irradiance": 2})"));
  const Scene six =
      scene_of(clear_air("0.02", R"({"elevation_deg": 10, "irradiance": 2, "spectrum": {"named": "solar"}})",
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
    // Sums of five in floats. Walks of other seeds agree in the mean.
    EXPECT_LT(exact ? worst : std::fabs(sum / expected_sum - 1.0), exact ? 2e-5 : 0.02) << method.info.name;
    const std::vector<Direction> up{{1.0, 0.3}};
    EXPECT_NEAR(probe_now(all, up)[0].transmittance[1] / probe_now(one, up)[0].transmittance[1], 1.0, 1e-5)
        << method.info.name;
  }
}

// The sun through a vertical of air, at every tenth nanometre: exp(-column x scattering), summed by CIE 1931.
TEST(Spectral, TransmittanceIsTheSunsColour) {
  const Scene scene = scene_of(clear_air(R"({"named": "air"})", R"({"elevation_deg": 10})",
                                         R"(, "render": {"method": "march", "wavelengths": 6})"));
  const double column = 8.0 * (1.0 - std::exp(-12.5));
  const BandColours colours = band_colours(scene.spectra->sun, White::sun);
  std::array<double, kFineBands> through{};
  for (std::size_t b = 0; b < through.size(); ++b) {
    const double nm = 0.5 * (fine_bands()[b].low + fine_bands()[b].high);
    through[b] = std::exp(-column * value_at(scene.media[0].scattering.curve, nm));
  }
  const Rgb expected = colour_of(colours, through);
  const ProbeResult found = probe_now(scene, {{1.5707963, 0.0}}).front();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(found.transmittance[c] / expected[c], 1.0, 2e-3) << c;
  }
}

// The reference is sunlight scattered once at all 48 wavelengths, by adaptive quadrature. It shares neither nodes nor
// matrix with the few wavelengths that are tested.
TEST(Spectral, FewWavelengthsComeCloseToAll) {
  const std::string extra = R"(, "render": {"method": "path-trace", "max_orders": 1, "wavelengths": )";
  const std::vector<Direction> directions{{0.03, 0.2}, {0.3, 1.0}, {1.0, 3.0}, {1.5, 0.0}, {0.1, 3.1}};
  for (const char* elevation : {"40", "5", "-3"}) {
    const auto probes = [&](int count) {
      const std::string sun = "{\"elevation_deg\": " + std::string(elevation) + "}";
      return probe_now(scene_of(clear_air(R"({"named": "air"})", sun, extra + std::to_string(count) + "}")),
                       directions);
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

// The sun is a lamp of 3000 K: white where white is the sun, orange under D65. Twice the light is twice as bright.
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
      scene_of(clear_air(R"(0.02, "absorption_per_km": {"wavelengths_nm": [630, 640], "values": [1, 0]})",
                         R"({"elevation_deg": 30})", R"(, "render": {"method": "march", "wavelengths": 24})"));
  const Rendering rendering = render_now(scene);
  EXPECT_EQ(rendering.fault(), "");
  EXPECT_GT(rendering.picture.outside, 0u);
}

std::string wavelengths(int count, const std::string& more = "") {
  return R"(, "render": {"wavelengths": )" + std::to_string(count) + more + "}";
}

// Earth's air, with what `air` changes, by day or dusk. `count`: wavelengths; 0: the default number.
Scene dusk_or_day(const std::string& air, const std::string& sun, int count, const std::string& more = "") {
  return scene_of(R"({"airlight": 1, "extends": ")" AIRLIGHT_SOURCE_DIR
                  R"(/presets/earth.json", "sun": {"elevation_deg": )" +
                  sun + R"(, "disc": {"visible": false}}, )" + air +
                  R"("camera": {"projection": "equirectangular", "pitch_deg": 0},
          "image": {"width": 16, "height": 8})" +
                  (count == 0 ? "" : wavelengths(count, more)) + "}");
}

double mean_error_of(const RadianceImage& found, const RadianceImage& truth) {
  double mean = 0.0;
  double sum = 0.0;
  int count = 0;
  const int rows = truth.height / 2;
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < truth.width * rows; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = channel_of(truth, i % truth.width, i / truth.width, c);
        const double here = channel_of(found, i % truth.width, i / truth.width, c);
        if (pass == 0) {
          mean += expected / (3.0 * truth.width * rows);
        } else {
          sum += std::fabs(here - expected) / std::max(std::fabs(expected), 1e-3 * mean);
          ++count;
        }
      }
    }
  }
  return sum / count;
}

// The number that `auto` chooses keeps the error of a sky of all orders below half a percent, and is the smaller one
// where that suffices. The bounds are a third above the results of scripts/spectral-errors.
TEST(Spectral, AutomaticWavelengthsKeepTheError) {
  struct SkyCase {
    const char* air;
    const char* sun;
    double bound;
    std::size_t wavelengths;
  };
  const char* const dust =
      R"("planet": {"radius_km": 3390, "ground_albedo": {"wavelengths_nm": [400, 700], "values": [0.05, 0.3]}},
         "media": [{"name": "rayleigh", "scattering_per_km": {"named": "air", "scale": 0.03}},
                   {"name": "aerosol", "scattering_per_km": {"wavelengths_nm": [400, 700], "values": [0.02, 0.025]},
                    "absorption_per_km": {"wavelengths_nm": [400, 700], "values": [0.008, 0.001]}},
                   {"name": "ozone", "absorption_per_km": 0}], )";
  for (const SkyCase& sky : {SkyCase{"", "40", 0.0035, 3}, SkyCase{"", "-4", 0.003, 6}, SkyCase{dust, "3", 0.003, 3}}) {
    const Scene chosen = dusk_or_day(sky.air, sky.sun, 0);
    EXPECT_EQ(ready(chosen).basis().nodes.nm.size(), sky.wavelengths) << sky.air << sky.sun;
    const RadianceImage truth = render_now(dusk_or_day(sky.air, sky.sun, 48)).radiance;
    EXPECT_LT(mean_error_of(render_now(chosen).radiance, truth), sky.bound) << sky.air << sky.sun;
  }
}

// By `orders`, whose clouds are some percent off by any wavelengths; not by the judge, and not without clouds.
TEST(Spectral, AFieldOfCloudsTakesFewerWavelengths) {
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/fair-weather-cumulus.json"), method_infos());
  scene.image = {48, 27};
  const auto wavelengths = [](const Scene& some) { return ready(some).basis().nodes.nm.size(); };
  EXPECT_EQ(wavelengths(scene), 3U);
  EXPECT_EQ(wavelengths(with_method(scene, *find_method("path-trace"))), 6U);
  Scene clear = scene;
  clear.clouds.clear();
  EXPECT_EQ(wavelengths(clear), 6U);
  const RadianceImage few = render_now(scene).radiance;
  scene.spectra->wavelengths = 6;
  EXPECT_LT(mean_error_of(few, render_now(scene).radiance), 0.015);
}

// With tables there is one pass over the pixels, whatever the number of wavelengths. The result equals the pictures of
// each three wavelengths, disc included, added by the matrix.
TEST(Spectral, PixelsKnowOfNoWavelengths) {
  Scene scene = dusk_or_day("", "4", 7, R"(, "method": "orders", "tabulate": "always", "steps": 16)");
  scene.sun.disc.visible = true;
  const auto bent = scene.planet.refraction;
  const auto passes = [&](const std::string& shader) {
    const Plan plan = plan_for(scene, {});
    return std::ranges::count_if(plan.passes(), [&](const PassDesc& pass) { return pass.shader == shader; });
  };
  ASSERT_TRUE(bent);
  EXPECT_EQ(passes("sky_from_factors"), 1);
  EXPECT_EQ(passes("sun_disc"), 3) << "each wavelength is bent its own way";
  scene.planet.refraction.reset();
  EXPECT_EQ(passes("sky_factors"), 3);
  EXPECT_EQ(passes("sky_from_factors"), 1);
  EXPECT_EQ(passes("sun_disc"), 1);
  EXPECT_EQ(passes("spectral_sum"), 0);
  scene.planet.refraction = bent;
  const RadianceImage found = render_now(scene).radiance;
  std::vector<double> expected(found.rgba.size());
  const Stage stage = ready(scene);
  for (const Part& group : stage.parts()) {
    const RadianceImage part = render_now(group.scene).radiance;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      for (std::size_t k = 0; k < 3 && i % 4 < 3; ++k) {
        expected[i] += group.colours[k][i % 4] * static_cast<double>(part.rgba[i - i % 4 + k]);
      }
    }
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (i % 4 < 3) {
      EXPECT_NEAR(static_cast<double>(found.rgba[i]) / expected[i], 1.0, 3e-5) << i;
    }
  }
}

// The air before things uses the sky's tables of the groups.
TEST(Spectral, ThingsFindTheSkysTables) {
  const Scene scene = dusk_or_day("", "5", 6, R"(, "method": "orders", "tabulate": "always")");
  ASSERT_EQ(render_now(scene).fault(), "");
  for (const bool volume : {false, true}) {
    std::vector<PassTiming> passes;
    air_to(executor(), scene, std::vector<Span>{{5, 0, 10.0F}}, {volume, {}}, &passes);
    EXPECT_EQ(passes.size(), volume ? 6U : 4U);  // of two groups: ratios or volume and extinction, and the air
    for (const PassTiming& pass : passes) {
      EXPECT_FALSE(pass.name.starts_with("order") || pass.name.starts_with("transmittance")) << pass.name;
    }
  }
}

// Layers, the air before things and the light that glares have the same colours as picture and probe.
TEST(Spectral, AllIsInTheSameColours) {
  Scene scene = dusk_or_day("", "4", 5, R"(, "method": "orders", "steps": 16)");
  RenderRequest request;
  request.layers = LayerSet::light;
  const Rendering rendering = render_now(scene, request);
  ASSERT_EQ(rendering.fault(), "");
  const std::size_t pixel = 5;  // of the highest row
  const Direction direction{1.5707963267948966 * (1.0 - 1.0 / 8.0), 6.283185307179586 * (5.5 / 16.0 - 0.5)};
  Direction turned = direction;
  turned.azimuth += scene.camera.azimuth;
  const ProbeResult probed = probe_now(scene, {turned}).front();
  const auto transmittance =
      std::ranges::find_if(rendering.layers, [](const Layer& layer) { return layer.name == "transmittance"; });
  // Its transmittance counts the forward peak's light as unscattered: tests/methods/beam_test.cpp.
  Scene finer = scene;  // rays to things take half of the picture's steps
  finer.render.parameters.insert_or_assign("steps", 32);
  const AirTo whole = air_to(executor(), finer, std::vector<Span>{{5, 0, 1e6F}}).front();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(static_cast<double>(transmittance->planes[128 * c + pixel]) / probed.transmittance[c], 1.0, 1e-4) << c;
    // These rays read the moments' ratios in halves, which are good to 5e-4.
    EXPECT_NEAR(static_cast<double>(whole.radiance[c]) / probed.radiance[c], 1.0, 5e-4) << c;
  }
  scene.planet.refraction.reset();  // a bent beam is spread, and comes from another direction
  const Direction at_sun{scene.sun.elevation, scene.sun.azimuth};
  Scene marched = with_method(scene, *find_method("march"));  // `orders` leaves the forward peak of haze in the beam
  marched.render.parameters.insert_or_assign("steps", 512);
  const ProbeResult sun = probe_now(marched, {at_sun}).front();
  const physics::vec3 glare = glare_points_of(ready(scene)).front().irradiance;
  const auto over_sun = [&](double light, std::size_t c) {
    return light / (scene.sun.irradiance[c] * sun.transmittance[c]);
  };
  EXPECT_NEAR(over_sun(glare.x, 0) / over_sun(glare.y, 1), 1.0, 0.02);
  EXPECT_NEAR(over_sun(glare.x, 0) / over_sun(glare.z, 2), 1.0, 0.03);
  EXPECT_GT(glare.x, 1.5 * glare.z) << "a low sun is red";
}

}  // namespace
}  // namespace airlight::test
