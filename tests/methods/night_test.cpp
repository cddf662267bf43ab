// The night sky: its parts against what is known of them, and the pictures against the formulas in double.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "core/night/background.h"
#include "core/night/night_air.h"
#include "core/post/night_sky.h"
#include "core/render/lighting.h"
#include "core/render/spectrum.h"
#include "core/scene/photometry.h"
#include "core/spectra/data.h"
#include "tests/methods/paranal.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

// Magnitudes a square arc second (V) at the zenith.
double zenith_magnitude(double sun_elevation_deg) {
  const ProbeResult up = probe_now(paranal(sun_elevation_deg), {{0.5 * std::numbers::pi, 0.0}}).front();
  return -2.5 * std::log10(bt709_luminance(up.radiance) / 1.08e5);
}

TEST(NightSky, IsAsDarkAsParanals) {
  EXPECT_NEAR(zenith_magnitude(-30.0), 21.5, 0.3);
}

// Colour temperature by the nearest black body in CIE 1960's diagram, 1000 K / temperature on a fine scale.
double colour_temperature(const Rgb& colour) {
  const auto place = [](const Rgb& c) {
    const double x = 0.4123908 * c[0] + 0.3575843 * c[1] + 0.1804808 * c[2];
    const double y = 0.2126390 * c[0] + 0.7151687 * c[1] + 0.0721923 * c[2];
    const double z = 0.0193308 * c[0] + 0.1191948 * c[1] + 0.9505322 * c[2];
    return std::pair(4.0 * x / (x + 15.0 * y + 3.0 * z), 6.0 * y / (x + 15.0 * y + 3.0 * z));
  };
  const auto [u, v] = place(colour);
  const BandColours bands = band_colours(constant_curve(1.0), White::d65);
  double nearest = 1e9;
  double found = 0.0;
  for (double mired = 5.0; mired < 300.0; mired += 0.1) {
    std::array<double, kFineBands> light{};
    std::ranges::transform(fine_bands(), light.begin(), [&](const WaveBand& band) {
      const double nm = 0.5 * (band.low + band.high);
      return 1e15 * std::pow(nm, -5.0) / std::expm1(14.38777 * mired / nm);
    });
    const auto [there_u, there_v] = place(colour_of(bands, light));
    if (const double apart = std::hypot(there_u - u, there_v - v); apart < nearest) {
      nearest = apart;
      found = 1e6 / mired;
    }
  }
  return found;
}

TEST(Twilight, ColourTemperatureOfD65IsItsOwn) {
  EXPECT_NEAR(colour_temperature({1.0, 1.0, 1.0}), 6504.0, 20.0);
}

// Light on level ground, rural, measured: 9600 K with the sun at 0 degrees, 13 100 at -4, 20 300 at -6, 39 300 at -8.
// Near the end of the diagram's curve ozone decides: with the 300 DU of `earth` the last is three times as high.
TEST(Twilight, HasItsColourTemperatures) {
  const auto found = [](double sun, const char* ozone) {
    Preset preset = load_preset(AIRLIGHT_SOURCE_DIR "/presets/earth.json");
    apply_override(preset, R"(/image/white="D65")");
    apply_override(preset, std::string("/media/2/absorption_per_km/dobson_units=") + ozone);
    Scene scene = resolve(preset, method_infos());
    scene.sun.elevation = sun * kDegree;
    const Lighting lighting = lighting_of([]() -> Executor& { return executor(); }, scene, {});
    Rgb level{};
    for (int x = 0; x < kIrradianceWidth; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        level[c] += lighting.irradiance.at(x, 0)[c];
      }
    }
    return colour_temperature(level);
  };
  for (const auto& [sun, kelvin] :
       {std::pair(0.0, 9600.0), std::pair(-4.0, 13100.0), std::pair(-6.0, 20300.0), std::pair(-8.0, 39300.0)}) {
    EXPECT_NEAR(found(sun, "275") / kelvin, 1.0, 0.15) << sun;
  }
  EXPECT_LT(found(-6.0, "250"), found(-6.0, "300") - 5000.0);
}

// From 13 degrees down airglow and starlight flatten the curve as they do there.
TEST(NightSky, EndsTheTwilight) {
  EXPECT_NEAR(zenith_magnitude(-13.746), 20.78, 0.25);
  EXPECT_NEAR(zenith_magnitude(-14.816), 21.19, 0.25);
  EXPECT_NEAR(zenith_magnitude(-16.784), 21.44, 0.25);
  EXPECT_NEAR(zenith_magnitude(-18.413), 21.52, 0.25);
}

// Air of molecules alone, which absorb nothing.
Scene molecules(double ground_albedo) {
  Scene scene = earth();
  scene.media.resize(1);
  scene.media[0].absorption = {};
  scene.planet.ground_albedo = {ground_albedo, ground_albedo, ground_albedo};
  return scene;
}

// Of a direction of the table: what the air lets through of the sky behind it.
double sky_through(physics::Physics& p, physics::uint i) {
  const double mu = p.night_slope_cosine(p.scene.planet, 0.5, i);
  return i >= physics::kNightSlopes ? 0.0 : p.transmittance_to_top(p.scene.planet, 0.5, mu).y;
}

// Under an even sky of radiance 1, air that absorbs nothing over white ground is as bright in every direction.
TEST(NightAir, LosesNothingOverWhiteGround) {
  const Air air = air_of(molecules(1.0));
  physics::Physics p = air.formulas();
  p.sun_steps = physics::kTransmittanceSteps;
  const NightAir lit = night_air(air, 0.5);
  for (physics::uint i = 0; i < 2 * physics::kNightSlopes; ++i) {
    EXPECT_NEAR(sky_through(p, i) + lit.scattered[i].y, 1.0, 0.03) << i;
  }
  EXPECT_NEAR(lit.ground.y, std::numbers::pi, 0.06);
}

// Black-body radiation: a sky of radiance 1 and a ground that reflects A and shines with 1 - A are 1 in every
// direction, through whatever air.
TEST(NightAir, OfSkyAndShiningGroundIsOneEverywhere) {
  const Air air = air_of(molecules(0.3));
  physics::Physics p = air.formulas();
  p.sun_steps = physics::kTransmittanceSteps;
  const NightAir sky = night_air(air, 0.5);
  const NightAir ground = night_air(air, 0.5, NightSource::ground);
  for (physics::uint i = 0; i < 2 * physics::kNightSlopes; ++i) {
    EXPECT_NEAR(sky_through(p, i) + sky.scattered[i].y + 0.7 * ground.scattered[i].y, 1.0, 0.03) << i;
  }
  EXPECT_NEAR(sky.ground.y + 0.7 * ground.ground.y, std::numbers::pi, 0.06);
}

// Thin air over a shining ground scatters half its depth straight down: half of all directions shine.
TEST(NightAir, OfThinAirOverLampsIsHalfItsDepth) {
  Scene scene = molecules(0.0);
  scene.media[0].scattering = {1e-5, 1e-5, 1e-5};
  const Air air = air_of(scene);
  const NightAir lit = night_air(air, 0.0, NightSource::ground);
  const double depth = air.depths().extinction;
  EXPECT_NEAR(lit.scattered[physics::kNightSlopes - 1].y / (0.5 * depth), 1.0, 0.05);
}

// Colours of lamps: CIE 1931 places of high-pressure sodium (0.53, 0.41) and of white of 4000 K (0.38, 0.38).
TEST(Lamps, HaveTheirColours) {
  for (const auto& [lamps, x, y] : {std::tuple(Lamps::sodium, 0.53, 0.41), std::tuple(Lamps::led, 0.38, 0.38)}) {
    std::array<double, kFineBands> light{};
    std::ranges::transform(fine_bands(), light.begin(), [lamps = lamps](const WaveBand& band) {
      return lamp_light(lamps, 0.5 * (band.low + band.high));
    });
    const Rgb colour = colour_of(band_colours(constant_curve(1.0), White::d65), light);
    const double cx = 0.4124564 * colour[0] + 0.3575761 * colour[1] + 0.1804375 * colour[2];
    const double cy = bt709_luminance(colour);
    const double cz = 0.0193339 * colour[0] + 0.1191920 * colour[1] + 0.9503041 * colour[2];
    EXPECT_NEAR(cx / (cx + cy + cz), x, 0.02);
    EXPECT_NEAR(cy / (cx + cy + cz), y, 0.02);
  }
}

TEST(NightSky, IsBrighterOverTowns) {
  Scene scene = paranal(-30.0);
  const auto zenith = [&] {
    return bt709_luminance(probe_now(scene, {{0.5 * std::numbers::pi, 0.0}}).front().radiance);
  };
  const double dark = zenith();
  scene.night_sky->light_pollution = 0.1;
  const double town = zenith();
  // Between half the depth above 2.6 km and half the whole, of 0.1 cd/m2, at 550 nm.
  EXPECT_GT(town - dark, 0.1 * 0.5 * 0.05);
  EXPECT_LT(town - dark, 0.1 * 0.5 * 0.3);
}

TEST(Airglow, BrightensTowardTheHorizonAsVanRhijnSays) {
  physics::Physics p = geometry_of(earth());
  const auto factor = [&](double zenith_deg) {
    return p.van_rhijn(p.scene.planet, 0.0, std::cos(zenith_deg * kDegree));
  };
  EXPECT_NEAR(factor(0.0), 1.0, 1e-12);
  EXPECT_NEAR(factor(60.0), 1.92, 0.03);
  EXPECT_NEAR(factor(90.0), 6.0, 0.1);
}

TEST(ZodiacalLight, IsLeinertsTable) {
  EXPECT_NEAR(zodiacal_light(90.0 * kDegree, 0.0), 259.0, 1e-6);
  EXPECT_NEAR(zodiacal_light(-60.0 * kDegree, 30.0 * kDegree), 183.0, 1e-6);
  EXPECT_NEAR(zodiacal_light(180.0 * kDegree, 0.0), 230.0, 1e-6);
  EXPECT_NEAR(zodiacal_light(37.5 * kDegree, 0.0), 0.5 * (1650.0 + 1180.0), 1e-6);
  EXPECT_NEAR(zodiacal_light(1.0, 0.5 * std::numbers::pi), 60.0, 0.1);
}

// 460 stars of magnitude 0 over all the sky, less those brighter than 6.5, which are 96.
TEST(FaintStars, AddUpToTheSkysLight) {
  double sum = 0.0;
  constexpr int kRows = 180;
  for (int i = 0; i < kRows; ++i) {
    const double latitude = (90.0 - (i + 0.5)) * kDegree;
    for (int j = 0; j < 360; ++j) {
      sum += faint_stars(airlight::direction_of((j + 0.5) * kDegree, latitude)) * std::cos(latitude) * 180.0 /
             std::numbers::pi * 2.0 * std::sin(0.5 * kDegree);
    }
  }
  EXPECT_NEAR(sum * 1e-4, 364.0, 10.0);
}

// The Milky Way's bright clouds in Sagittarius against the pole of the galaxy.
TEST(FaintStars, HaveTheMilkyWay) {
  const double cloud = faint_stars(airlight::direction_of(271.0 * kDegree, -29.0 * kDegree));
  EXPECT_GT(cloud, 8.0 * faint_stars(airlight::direction_of(192.86 * kDegree, 27.13 * kDegree)));
}

TEST(NightSky, OfThePictureIsThatOfItsFormula) {
  for (const char* name : {"orders", "nested"}) {
    Scene scene = with_method(earth(), *find_method(name), true);
    scene.sun.elevation = -60.0 * kDegree;
    scene.sun.unit = SunUnit::lux;
    scene.sun.irradiance.fill(kSunlight);
    scene.camera.pitch = 0.4;
    scene.image = {32, 18};
    const RadianceImage black = render_now(scene).radiance;
    scene.night_sky = NightSky{};
    const RadianceImage picture = render_now(scene).radiance;
    const Stage stage = ready(scene);
    RadianceImage formula{32, 18, std::vector<float>(picture.rgba.size())};
    draw_night_sky(formula, stage, {0, 0, 32, 18});
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
      if (i % 4 != 3) {
        const double light = double{picture.rgba[i]} - double{black.rgba[i]};
        EXPECT_NEAR(light, double{formula.rgba[i]}, 0.01 * double{formula.rgba[i]}) << name << " " << i;
      }
    }
  }
}

// A thing close by sends back what lights it; one far off fades into what the air scatters along the whole ray.
TEST(NightSky, LightsThingsAndFadesThemIntoTheAir) {
  Scene scene = earth();
  scene.night_sky = NightSky{};
  const Stage stage = ready(scene);
  physics::Physics p = night_formulas(stage);
  const physics::PlanetData planet = p.scene.planet;
  const double h = scene.camera.altitude;
  const physics::vec3 level = p.direction_from_angles(0.01, 0.0);
  const auto ray = p.ray_in_atmosphere(planet, h, level.y, 0.0, 0.0);
  const physics::vec3 all = p.night_through(planet, ray, p.distance_to_top(planet, h, level.y));
  const physics::vec3 white(1.0);
  const physics::vec3 near = p.night_on_surface(planet, h, level, p.night_through(planet, ray, 0.0), all, white, 1.0);
  EXPECT_NEAR(near.y, p.night_on_ground().y / std::numbers::pi, 1e-12 * near.y);
  const physics::vec3 far = p.night_on_surface(planet, h, level, all, all, physics::vec3(0.0), 1.0);
  EXPECT_NEAR(far.y, p.night_scattered_at(planet, h, level.y, false).y, 1e-9 * far.y);
  const physics::vec3 through = p.night_through(planet, ray, 50.0);
  EXPECT_GT(through.x, through.z);
  EXPECT_NEAR(through.y,
              std::exp(-p.optical_depth_to_top(planet, h, level.y, 400).y +
                       p.optical_depth_to_top(planet, p.point_on_ray(planet, ray, 50.0).h,
                                              p.point_on_ray(planet, ray, 50.0).mu, 400)
                           .y),
              0.01);
}

TEST(NightSky, IsALayer) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.sun.elevation = -8.0 * kDegree;
  scene.night_sky = NightSky{.airglow = 100.0};
  scene.image = {24, 14};
  RenderRequest request;
  request.layers = LayerSet::light;
  const Rendering made = render_now(scene, request);
  for (std::size_t i = 0; i < made.radiance.rgba.size() / 4; ++i) {
    double sum = 0.0;
    for (const Layer& layer : made.layers) {
      sum += layer.is_light ? double{layer.planes[i]} : 0.0;
    }
    EXPECT_NEAR(sum, double{made.radiance.rgba[4 * i]}, 5e-4 * sum);
  }
}

TEST(NightSky, IsTheSameInTiles) {
  Scene scene = with_method(earth(), *find_method("orders"), true);
  scene.sun.elevation = -60.0 * kDegree;
  scene.night_sky = NightSky{};
  scene.image = {40, 30};
  const RadianceImage whole = render_now(scene).radiance;
  RadianceImage joined;
  BandsRequest request;
  request.tile = ImageSize{16, 16};
  request.sink = [&](Band& band) {
    joined.rgba.insert(joined.rgba.end(), band.rows.radiance.rgba.begin(), band.rows.radiance.rgba.end());
  };
  render_bands([]() -> Executor& { return executor(); }, scene, request);
  EXPECT_EQ(joined.rgba, whole.rgba);
}

}  // namespace
}  // namespace airlight::test
