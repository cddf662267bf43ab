// Bent light against exact rays, and each method against the others through it.

#include "core/air/refraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/methods/ready.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/methods/exact_rays.h"
#include "tests/methods/path_trace_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

constexpr double kBlack = 0.0;

Refraction bent(double n_minus_1, double scale_height) {
  Refraction refraction;
  refraction.n_minus_1 = n_minus_1;
  refraction.density.scale_height = scale_height;
  return refraction;
}

// Molecules alone, as ExactAir has them.
Scene molecules(double sun_deg, double albedo) {
  const ExactAir air;
  Scene scene = airlight::earth(sun_deg, 0.001, albedo);
  scene.media.resize(1);
  scene.media[0].density.scale_height = air.scale_height;
  scene.planet.ground_radius = air.radius;
  scene.planet.refraction = bent(air.n_minus_1, air.scale_height);
  scene.sun.disc.angular_radius = radians(0.2665);
  scene.render.polarisation = false;
  return scene;
}

std::vector<Direction> toward(const std::vector<double>& elevations) {
  std::vector<Direction> directions;
  for (const double elevation : elevations) {
    for (const double azimuth : {0.0, 90.0, 180.0}) {
      directions.push_back({radians(elevation), radians(azimuth)});
    }
  }
  return directions;
}

// By exact rays, n - 1 = 2.77e-4, scale height 8 km; spread: of irradiance.
struct Seen {
  double true_deg;
  double seen_deg;
  double spread;
};

TEST(Refraction, TheSunIsSeenWhereExactRaysComeFrom) {
  for (const Seen& s :
       {Seen{5.0, 5.158, 0.9754}, Seen{1.0, 1.3696, 0.8954}, Seen{0.0, 0.5022, 0.8352}, Seen{-0.5, 0.0953, 0.7920}}) {
    physics::Physics p = geometry_of(molecules(s.true_deg, kBlack));
    p.scene.camera.altitude = 0.0;
    const SeenDirection seen = seen_direction(p, p.scene.sun.direction);
    EXPECT_NEAR(std::asin(seen.direction.y) * 180.0 / std::numbers::pi, s.seen_deg, 1e-3) << s.true_deg;
    EXPECT_NEAR(seen.spread, s.spread, 1e-3) << s.true_deg;
    const ExactSun exact = exact_sun({}, 0.0, radians(90.0 - s.true_deg));
    EXPECT_NEAR(std::asin(seen.direction.y), 0.5 * std::numbers::pi - exact.zenith, 1e-5) << s.true_deg;
    EXPECT_NEAR(seen.spread, exact.spread, 1e-3) << s.true_deg;
  }
}

TEST(Refraction, AltitudesAndBendingAreThoseOfExactRays) {
  physics::Physics p = geometry_of(molecules(10.0, kBlack));
  const ExactAir air;
  for (const double h : {0.0, 0.01, 1.0, 9.0, 31.0, 77.0, 100.0}) {
    const double g = optical_altitude(p, h);
    EXPECT_NEAR(g, air.index(h) * (air.radius + h) - air.index(0.0) * air.radius, 1e-6) << h;
    EXPECT_NEAR(p.true_altitude(g).h, h, 1e-6) << h;
    for (const double elevation : {0.5, 3.0, 40.0}) {
      const ExactPoint end = exact_ray(air, h, radians(90.0 - elevation), 2000).back();
      EXPECT_NEAR(p.bending_to_top(p.scene.planet, g, std::sin(radians(elevation)), physics::kBendingSteps),
                  end.bending, 1e-6 + 1e-4 * end.bending)
          << h << " km, " << elevation;
    }
  }
  // Between the horizon's straight and bent dip, as published for Earth: 0.93 and 3.01 degrees for 1.02 and 3.21.
  EXPECT_NEAR(-std::asin(p.horizon_mu(p.scene.planet, optical_altitude(p, 1.0))) * 180.0 / std::numbers::pi, 0.93,
              0.03);
  EXPECT_NEAR(-std::asin(p.horizon_mu(p.scene.planet, optical_altitude(p, 10.0))) * 180.0 / std::numbers::pi, 3.01,
              0.03);
}

// Air of n = 1 takes the same route, and makes the same picture but for rounding.
TEST(Refraction, AnIndexOfOneBendsNothing) {
  for (const char* name : {"orders", "march", "sky-view"}) {
    for (const double sun : {30.0, 0.0, -4.0}) {
      Scene scene = with_method(airlight::earth(sun, 0.5, 0.2), *find_method(name));
      const std::vector<Direction> directions = toward({-20.0, 2.0, 15.0, 89.0});
      const std::vector<ProbeResult> straight = probe_now(scene, directions);
      scene.planet.refraction = bent(0.0, 8.0);
      const std::vector<ProbeResult> same = probe_now(scene, directions);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(same[i].radiance[c], straight[i].radiance[c], 2e-4 * straight[i].radiance[c] + 1e-9)
              << name << ", sun " << sun << ", direction " << i;
        }
      }
    }
  }
}

// What is kept by the key is not taken for air of another.
TEST(Refraction, IsTheSameForEqualNumbersAlone) {
  Planet planet;
  planet.refraction = bent(2.78e-4, 8.0);
  planet.refraction->density.profile = DensityProfile::height_fog;
  Planet other = planet;
  EXPECT_EQ(refraction_key(other), refraction_key(planet));
  other.refraction->density.below = 2.0;
  EXPECT_NE(refraction_key(other), refraction_key(planet));
}

// From the day to where the shadow's edge crosses rays, down to a degree above the horizon.
TEST(Refraction, FirstOrderIsThatOfExactRays) {
  std::vector<Direction> directions = toward({1.0, 10.0});
  directions.push_back({0.5 * std::numbers::pi, 0.0});
  const std::vector<double> suns = sanitized()
                                       ? std::vector{1.0, -2.0}
                                       : std::vector{5.0, 3.0, 2.0, 1.0, 0.5, 0.0, -0.25, -0.5, -1.0, -2.0, -3.0, -4.0};
  double worst_path = 0.0;
  double worst_march = 0.0;
  for (const double sun : suns) {
    Scene traced = molecules(sun, kBlack);
    set(traced, "max_orders", 1);
    const HostPicture paths = trace(traced, directions);
    Scene marched = with_method(molecules(sun, kBlack), *find_method("march"));
    marched.render.parameters["multiple_scattering_scale"] = 0.0;
    marched.render.parameters["steps"] = 512;
    marched.render.parameters["transmittance_lut"] = TableSize{1024, 256};
    const std::vector<ProbeResult> march = probe_now(marched, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const std::array<double, 3> exact = exact_single(
          {}, traced.media[0].scattering, {0.001, directions[i].elevation, directions[i].azimuth, radians(sun)});
      if (exact[0] == 0.0) {  // all of the ray is in the planet's shadow
        EXPECT_EQ(paths.radiance.at(static_cast<int>(i), 0)[0], 0.0F) << sun << ", " << i;
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const double path = static_cast<double>(paths.radiance.at(static_cast<int>(i), 0)[c]) / exact[c] - 1.0;
        const double step = march[i].radiance[c] / exact[c] - 1.0;
        worst_path = std::max(worst_path, std::abs(path));
        worst_march = std::max(worst_march, std::abs(step));
        EXPECT_NEAR(path, 0.0, 0.005) << "path-trace, sun " << sun << ", direction " << i << ", channel " << c;
        EXPECT_NEAR(step, 0.0, 0.015) << "march, sun " << sun << ", direction " << i << ", channel " << c;
      }
    }
  }
  std::printf("path-trace at most %.4f off, march %.4f\n", worst_path, worst_march);
}

// By the layer of sunlight that molecules scatter once. Rows of this latlong picture stand 2 degrees apart, from 89
// degrees down. A table of 256 x 64, the default, leaves up to 2.2 % in the blue light of a level ray, and 48 steps 1.2
// % of a ray that the shadow's edge crosses.
TEST(Refraction, FirstOrderOfOrdersIsThatOfExactRays) {
  constexpr std::array<double, 2> kAzimuths{-90.0, 0.0};  // of the picture's first columns
  constexpr std::array<int, 4> kRows{0, 39, 42, 44};      // 89, 11, 5 and 1 degrees up
  const std::vector<double> suns =
      sanitized() ? std::vector{1.0, -2.0} : std::vector{5.0, 1.0, 0.0, -0.5, -2.0, -3.0, -4.0};
  double worst = 0.0;
  for (const double sun : suns) {
    Scene scene = with_method(molecules(sun, kBlack), *find_method("orders"));
    scene.camera.projection = Projection::equirectangular;
    scene.camera.azimuth = radians(45.0);
    scene.image = {4, 90};
    scene.render.parameters["steps"] = 256;
    scene.render.parameters["transmittance_lut"] = TableSize{1024, 256};
    RenderRequest request;
    request.layers = LayerSet::light;
    const Rendering rendering = render_now(scene, request);
    const Layer& once = rendering.layers.front();
    ASSERT_EQ(once.name, "medium1");
    for (const int row : kRows) {
      for (std::size_t x = 0; x < kAzimuths.size(); ++x) {
        const ExactView view{0.001, radians(89.0 - 2.0 * row), radians(kAzimuths[x]), radians(sun)};
        const std::array<double, 3> exact = exact_single({}, scene.media[0].scattering, view);
        for (std::size_t c = 0; c < 3; ++c) {
          const double found = static_cast<double>(once.planes[c * 360 + static_cast<std::size_t>(4 * row) + x]);
          worst = std::max(worst, exact[c] > 0.0 ? std::abs(found / exact[c] - 1.0) : 0.0);
          EXPECT_NEAR(found, exact[c], 0.01 * exact[c])
              << "sun " << sun << ", row " << row << ", azimuth " << kAzimuths[x] << ", channel " << c;
        }
      }
    }
  }
  std::printf("orders at most %.4f off\n", worst);
}

// Radiance of `march` over that of `path-trace`, of sunlight scattered or reflected once, in red.
std::vector<double> march_over_paths(Scene traced, const std::vector<Direction>& directions) {
  Scene marched = with_method(traced, *find_method("march"));
  set(traced, "max_orders", 1);
  const HostPicture paths = trace(traced, directions);
  marched.render.parameters["multiple_scattering_scale"] = 0.0;
  marched.render.parameters["steps"] = 512;
  const std::vector<ProbeResult> march = probe_now(marched, directions);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    ratios.push_back(march[i].radiance[0] / static_cast<double>(paths.radiance.at(static_cast<int>(i), 0)[0]));
  }
  return ratios;
}

// The glow stands around the sun that is seen: by the true one it is 13 to 18 % off. Points of the air see the sun a
// little lower than the camera does, by which `march` errs.
TEST(Refraction, TheGlowStandsAroundTheSunThatIsSeen) {
  Scene scene = molecules(-0.2, kBlack);
  scene.media.push_back(
      medium(PhaseFunction::henyey_greenstein, 0.95, {2e-3, 2e-3, 2e-3}, {0, 0, 0}, exponential(3.0)));
  for (const double ratio : march_over_paths(scene, {{radians(1.0), 0.0}, {radians(2.0), 0.0}, {radians(4.0), 0.0}})) {
    std::printf("glow %.4f\n", ratio);
    EXPECT_NEAR(ratio, 1.0, 0.07);
  }
}

// Ground is lit by the sun that it sees, though the true one has set.
TEST(Refraction, GroundIsLitByTheSunThatItSees) {
  Scene scene = molecules(-0.2, 0.6);
  scene.camera.altitude = 0.5;
  for (double& x : scene.media[0].scattering) x *= 1e-4;  // so little air that the sky lights nothing
  for (const double ratio :
       march_over_paths(scene, {{radians(-40.0), radians(30.0)}, {radians(-10.0), radians(170.0)}})) {
    EXPECT_NEAR(ratio, 1.0, 0.02);
  }
}

// Where the index falls three times as fast, rays between scatterings turn far enough to tell.
TEST(Refraction, PathsTurnBetweenScatterings) {
  const std::vector<Direction> directions = toward({10.0, 40.0, 80.0});
  Scene traced = molecules(-6.0, kBlack);
  traced.planet.refraction = bent(8e-4, 8.0);
  set(traced, "samples", sanitized() ? 32 : 8192);
  const HostPicture truth = trace(traced, directions);
  const std::vector<ProbeResult> found = probe_now(with_method(traced, *find_method("orders")), directions);
  double bias = 0.0;
  double noise = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto path = static_cast<double>(truth.radiance.at(static_cast<int>(i), 0)[0]);
    const auto error = static_cast<double>(truth.standard_error.at(static_cast<int>(i), 0)[0]);
    bias += (found[i].radiance[0] / path - 1.0) / static_cast<double>(directions.size());
    noise += error * error / (path * path * static_cast<double>(directions.size() * directions.size()));
  }
  std::printf("bias %.4f, noise %.4f\n", bias, std::sqrt(noise));
  EXPECT_LT(std::abs(bias), 0.01 + 3.0 * std::sqrt(noise));
}

// By volumes, as pictures of ground by maps have their layers, and by the table of the picture.
TEST(Refraction, LayersOfASeaAddUp) {
  Scene scene = with_method(molecules(-0.2, kBlack), *find_method("orders"));
  scene.ground.emplace().ocean.emplace();
  scene.sun.disc.visible = false;
  scene.camera.pitch = radians(5.0);
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = radians(50.0);
  scene.image = {64, 36};
  scene.render.parameters["tabulate"] = std::string("always");
  RenderRequest request;
  request.layers = LayerSet::light;
  const Rendering rendering = render_now(scene, request);
  for (int i = 14 * scene.image.width; i < 21 * scene.image.width; ++i) {  // 1 to 10 degrees above the horizon
    double sum = 0.0;
    for (const Layer& layer : rendering.layers) {
      sum += layer.is_light ? static_cast<double>(layer.planes[static_cast<std::size_t>(i)]) : 0.0;
    }
    const double whole = channel_of(rendering.radiance, i % scene.image.width, i / scene.image.width, 0);
    EXPECT_NEAR(sum, whole, 0.01 * whole) << i;
  }
}

// All orders, with aerosol and ground; by shells too.
TEST(Refraction, OrdersAgreesWithPathTrace) {
  const std::vector<Direction> directions = toward({2.0, 10.0, 40.0});
  for (const bool by_shells : {false, true}) {
    for (const double sun : {5.0, 0.0, -3.0}) {
      Scene traced = airlight::earth(sun, 0.001, 0.2);
      traced.planet.refraction = bent(2.78e-4, 8.4);
      set(traced, "samples", sanitized() ? 32 : 2048);
      const HostPicture truth = trace(traced, directions);
      Scene scene = with_method(traced, *find_method("orders"));
      scene.render.parameters["shells"] = std::string(by_shells ? "always" : "auto");
      const std::vector<ProbeResult> found = probe_now(scene, directions);
      double error = 0.0;
      double noise = 0.0;
      for (std::size_t i = 0; i < directions.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          const auto at = [&](const RadianceImage& image) {
            return static_cast<double>(image.at(static_cast<int>(i), 0)[c]);
          };
          const double share = 1.0 / (3.0 * static_cast<double>(directions.size()));
          error += std::abs(found[i].radiance[c] / at(truth.radiance) - 1.0) * share;
          noise += 0.8 * at(truth.standard_error) / at(truth.radiance) * share;
        }
      }
      std::printf("sun %g%s: error %.4f, noise %.4f\n", sun, by_shells ? ", by shells" : "", error, noise);
      EXPECT_LT(error, 0.008 + noise) << sun << by_shells;
    }
  }
}

// The sun on the horizon in a picture of 1 degree.
Scene through_a_long_lens() {
  Scene scene = molecules(-0.25, kBlack);
  scene.sun.disc.limb_darkening = 0.0;
  scene.camera.pitch = radians(0.3);
  scene.camera.azimuth = scene.sun.azimuth;
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = radians(1.0);
  scene.image = {200, 200};
  return scene;
}

// Near the horizon the disc is as high as exact rays make it, and stands half a degree above the true sun.
TEST(Refraction, FlattensTheDisc) {
  const Scene scene = through_a_long_lens();
  const Rendering rendering = render_now(with_method(scene, *find_method("orders")));
  int left = 200, right = 0, upper = 200, lower = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (channel_of(rendering.radiance, x, y, 0) > 10.0) {
        left = std::min(left, x);
        right = std::max(right, x);
        upper = std::min(upper, y);
        lower = std::max(lower, y);
      }
    }
  }
  ASSERT_LT(left, right);
  const double shape = static_cast<double>(lower - upper + 1) / (right - left + 1);
  const auto seen = [](double true_deg) {
    return 90.0 - exact_sun({}, 0.001, radians(90.0 - true_deg)).zenith * 180.0 / std::numbers::pi;
  };
  const double top = seen(-0.25 + 0.2665);
  const double bottom = seen(-0.25 - 0.2665);
  EXPECT_NEAR(shape, (top - bottom) / (2.0 * 0.2665), 0.015);
  EXPECT_NEAR(0.3 + (99.5 - 0.5 * (upper + lower)) / 200.0, 0.5 * (top + bottom), 0.01);
}

// The row of the picture at which a channel of the disc begins.
int upper_rim(const Rendering& rendering, std::size_t channel) {
  double most = 0.0;
  for (int y = 0; y < 200; ++y) most = std::max(most, channel_of(rendering.radiance, 100, y, channel));
  int y = 0;
  while (y < 200 && channel_of(rendering.radiance, 100, y, channel) < 0.2 * most) ++y;
  return y;
}

// A channel that is bent by 4 % more of the 30 minutes of arc there stands 0.017 degrees higher, as the disc is
// flattened by 0.84: 3.4 rows.
TEST(Refraction, PartsTheDiscsColours) {
  Scene scene = through_a_long_lens();
  scene.planet.refraction->dispersion = {0.98, 1.0, 1.02};
  const Rendering rendering = render_now(with_method(scene, *find_method("orders")));
  EXPECT_NEAR(upper_rim(rendering, 0) - upper_rim(rendering, 2), 3.4, 1.0);
  scene.planet.refraction->dispersion = {1.0, 1.0, 1.0};
  const Rendering together = render_now(with_method(scene, *find_method("orders")));
  EXPECT_EQ(upper_rim(together, 0), upper_rim(together, 2));
}

// The sun as a directional light: where it is seen, dimmed by the bent ray's air and spread.
TEST(Refraction, DirectionalLightIsTheBentBeam) {
  const Scene scene = with_method(molecules(0.0, kBlack), *find_method("orders"));
  const SunLight sun = sun_light([]() -> Executor& { return executor(); }, scene);
  const ExactSun exact = exact_sun({}, 0.001, radians(90.0));
  EXPECT_NEAR(sun.elevation, 0.5 * std::numbers::pi - exact.zenith, 1e-4);
  for (std::size_t c = 0; c < 3; ++c) {
    const double expected = std::exp(-scene.media[0].scattering[c] * exact.column) * exact.spread;
    // Blue falls by a fifth from the disc's top to its foot: its mean is above its middle.
    EXPECT_NEAR(sun.irradiance[c], expected, (c == 2 ? 0.08 : 0.02) * expected) << c;
  }
}

TEST(Refraction, LengthsOfRaysAreTrueOnes) {
  physics::Physics p = geometry_of(molecules(10.0, kBlack));
  for (const double elevation : {0.5, 10.0, 60.0}) {
    const double mu = std::sin(radians(elevation));
    const double optical = p.distance_to_top(p.scene.planet, p.scene.camera.altitude, mu);
    const auto ray = exact_ray({}, 0.001, radians(90.0 - elevation), 4000);
    EXPECT_NEAR(true_length(p, mu, optical), ray.back().length, 2e-3 * optical) << elevation;
    EXPECT_GT(ray.back().length, optical + 1.0) << elevation;
  }
}

// The index may follow a medium, whichever scene asks for it; the horizon's pixels are found by the bent one.
TEST(Refraction, FollowsAMediumInEveryScene) {
  Scene by_height = with_method(molecules(3.0, 0.2), *find_method("orders"));
  by_height.image = {160, 120};  // by a table, with the horizon's pixels apart
  by_height.camera.altitude = 2.0;
  by_height.camera.projection = Projection::perspective;
  by_height.camera.pitch = radians(-1.4);  // straight rays have the horizon two pixels lower
  by_height.camera.vertical_fov = radians(6.0);
  Scene by_medium = by_height;
  by_medium.planet.refraction->medium = "molecules";
  by_medium.media[0].name = "molecules";
  const auto read = [](const Scene& scene) {
    return resolve(parse_preset(to_json(scene), "as read", {}), method_infos());
  };
  by_height.media[0].name = "molecules";
  by_height = read(by_height);
  by_medium = read(by_medium);
  const std::vector<float> bent_pixels = render_now(by_height).radiance.rgba;
  EXPECT_EQ(render_now(by_medium).radiance.rgba, bent_pixels);
  Scene straight = by_height;
  straight.planet.refraction.reset();
  const auto device = []() -> Executor& { return executor(); };
  EXPECT_EQ(render(device, ready(by_height, ready(straight)), {}).radiance.rgba, bent_pixels);
}

// Other methods know no bent rays.
TEST(Refraction, IsLeftOutWhereRaysAreStraight) {
  const auto same = [](Scene scene, const char* what) {
    scene.image = {16, 9};
    const Rendering with = render_now(scene);
    scene.planet.refraction.reset();
    EXPECT_EQ(render_now(scene).radiance.rgba, with.radiance.rgba) << what;
  };
  for (const char* name : {"analytic", "nested"}) {
    same(with_method(molecules(1.0, 0.2), *find_method(name)), name);
  }
  // A ground by maps bends.
  Scene sea = with_method(molecules(0.0, 0.2), *find_method("orders"));
  sea.image = {16, 9};
  sea.ground.emplace().ocean.emplace();
  const Rendering bent_sea = render_now(sea);
  sea.planet.refraction.reset();
  EXPECT_NE(render_now(sea).radiance.rgba, bent_sea.radiance.rgba);
}

// Where azimuths have no meaning, at the shadow's edge to the last digit, from the ground to space, on small and large
// planets.
// At the top of the air nothing is left of the way along which a table by shells spreads the beam's logarithm.
TEST(Refraction, HoldsWhereAirEndsAbruptly) {
  for (const double sun : {60.0, 2.4}) {
    Scene scene = molecules(sun, 0.3);
    scene.planet.atmosphere_height = 10.4;
    scene.planet.refraction = bent(3.9e-4, 14.7);
    scene.media[0].density.scale_height = 0.9;
    scene.image = {8, 8};
    scene = with_method(scene, *find_method("orders"), true);
    scene.render.parameters.insert_or_assign("shells", std::string("always"));
    expect_sound(render_now(scene), "sun " + std::to_string(sun));
    const double up = probe_now(scene, toward({45.0})).front().radiance[1];
    scene.planet.refraction.reset();
    EXPECT_NEAR(probe_now(scene, toward({45.0})).front().radiance[1] / up, 1.0, 0.05) << sun;
  }
}

TEST(Refraction, HoldsAtItsEdges) {
  constexpr double kNext = 1e-15;
  for (const double radius : {10.0, 6371.0, 1e6}) {
    for (const double altitude : {0.0, 1.0, 99.999, 100.0, 400.0}) {
      for (const double sun : {90.0, 45.0, -0.55, -8.0, -90.0}) {
        Scene scene = molecules(sun, 0.3);
        scene.planet.ground_radius = radius;
        scene.planet.refraction = bent(radius > 1e5 ? 2e-6 : 2.78e-4, 8.0);
        scene.camera.altitude = altitude;
        scene.image = {8, 8};
        const Rendering rendering = render_now(with_method(scene, *find_method("orders"), true));
        expect_sound(rendering,
                     std::to_string(radius) + " km, at " + std::to_string(altitude) + ", sun " + std::to_string(sun));
      }
    }
  }
  physics::Physics p = geometry_of(molecules(0.0, kBlack));
  for (const double g : {0.0, 1.0, 50.0}) {
    const double edge = p.sun_before_lift(g, p.horizon_mu(p.scene.planet, g));
    EXPECT_TRUE(p.sun_is_up(p.scene.planet, g, edge + 1e-12)) << g;
    EXPECT_FALSE(p.sun_is_up(p.scene.planet, g, edge - 1e-9)) << g;
    EXPECT_NEAR(p.lifted_sun(g, p.sun_before_lift(g, 0.3)), 0.3, kNext) << g;
  }
}

}  // namespace
}  // namespace airlight::test
