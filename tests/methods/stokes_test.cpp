// Q and U, and polarising filters, against path-trace, published values and what light cannot break.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/air/scene_block.h"
#include "tests/methods/path_trace_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/this_build.h"

namespace airlight::test {
namespace {

using physics::vec3;

vec3 direction_of(const Direction& d) {
  const double c = std::cos(d.elevation);
  return {std::sin(d.azimuth) * c, std::sin(d.elevation), -std::cos(d.azimuth) * c};
}

// The angle from the plane of direction and zenith to the filter's axis, as U leans: by rotation about the axis that
// takes the camera's forward direction into the ray's.
double filter_angle(const Camera& camera, const Direction& d) {
  const CameraBasis basis = camera_basis(camera);
  const vec3 ray = direction_of(d);
  vec3 across = basis.up * std::cos(*camera.polariser) + basis.right * std::sin(*camera.polariser);
  const vec3 turn = cross(basis.forward, ray);
  if (length(turn) > 1e-9) {
    const vec3 k = turn / length(turn);
    const double c = dot(basis.forward, ray);
    across = across * c + cross(k, across) * length(turn) + k * (dot(k, across) * (1.0 - c));
  }
  const vec3 toward_azimuth(std::cos(d.azimuth), 0.0, std::sin(d.azimuth));
  const vec3 down(std::sin(d.azimuth) * std::sin(d.elevation), -std::cos(d.elevation),
                  -std::cos(d.azimuth) * std::sin(d.elevation));
  return std::atan2(dot(across, toward_azimuth), dot(across, down));
}

// What the filter lets through of light of these Stokes parameters.
double filtered(const ProbeResult& light, std::size_t c, double angle) {
  return 0.5 * (light.radiance[c] + (*light.q)[c] * std::cos(2.0 * angle) + (*light.u)[c] * std::sin(2.0 * angle));
}

struct FilteredSky {
  const char* name;
  double sun_deg;
  double aerosol;     // over that of Hillaire 2020
  double scattering;  // the molecules', likewise
  double bound;       // of the mean error, over the mean light
};

Scene filtered_sky(const FilteredSky& s) {
  Scene scene = airlight::earth(s.sun_deg, 0.001, 0.1);
  scene.sun.azimuth = radians(40.0);
  scene.camera.projection = Projection::fisheye;
  scene.camera.vertical_fov = std::numbers::pi;
  scene.camera.azimuth = radians(200.0);
  scene.camera.pitch = radians(35.0);
  scene.camera.roll = radians(15.0);
  for (double& x : scene.media[0].scattering) x *= s.scattering;
  for (double& x : scene.media[1].scattering) x *= s.aerosol;
  for (double& x : scene.media[1].absorption) x *= s.aerosol;
  return scene;
}

std::vector<Direction> sky_directions() {
  std::vector<Direction> directions;
  for (const double elevation : {6.0, 35.0, 80.0}) {
    for (const double azimuth : {50.0, 130.0, 250.0}) {
      directions.push_back({radians(elevation), radians(azimuth)});
    }
  }
  return directions;
}

TEST(Stokes, OrdersAgreesWithPathTraceThroughFilters) {
  const FilteredSky skies[]{{"clear, sun at 20", 20.0, 1.0, 1.0, 0.004},
                            {"clear, sun at -2", -2.0, 1.0, 1.0, 0.01},
                            {"hazy, sun at 60", 60.0, 10.0, 1.0, 0.01},
                            {"by shells, sun at 20", 20.0, 0.0, 6.0, 0.01}};
  const std::vector<Direction> directions = sky_directions();
  for (const FilteredSky& s : skies) {
    const std::vector<ProbeResult> found = probe_now(with_method(filtered_sky(s), *find_method("orders")), directions);
    double error = 0.0;
    double noise = 0.0;
    double light = 0.0;
    double swing = 0.0;  // of the light, between the filters
    for (const double angle : {0.0, 45.0, 90.0, 135.0}) {
      Scene traced = filtered_sky(s);
      traced.camera.polariser = radians(angle);
      set(traced, "samples", sanitized() ? 32 : 2048);
      const HostPicture truth = trace(traced, directions);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        constexpr std::size_t kBlue = 2;
        const auto at = [&](const RadianceImage& image) {
          return static_cast<double>(image.at(static_cast<int>(i), 0)[kBlue]);
        };
        const double expected = filtered(found[i], kBlue, filter_angle(traced.camera, directions[i]));
        error += std::abs(expected - at(truth.radiance));
        noise += 0.8 * at(truth.standard_error);
        light += at(truth.radiance);
        swing += std::abs(at(truth.radiance) - 0.5 * found[i].radiance[kBlue]);
        EXPECT_NEAR(expected, at(truth.radiance), 4.5 * at(truth.standard_error) + 0.03 * found[i].radiance[kBlue])
            << s.name << ", filter at " << angle << ", direction " << i;
      }
    }
    std::printf("%s: mean error %.4f, of it noise %.4f; filters change %.3f\n", s.name, error / light, noise / light,
                swing / light);
    EXPECT_LT(error, s.bound * light + (sanitized() ? 3.0 : 1.0) * noise) << s.name;
    EXPECT_GT(swing, 10.0 * s.bound * light) << s.name;
  }
}

// Natraj, Li and Yung 2009, as in polarisation_test.cpp, with Q and U, which have the other sign there.
struct PublishedStokes {
  double mu;
  double azimuth_deg;
  double i;
  double q;
  double u;
};
constexpr PublishedStokes kPublishedStokes[]{{0.02, 30.0, 0.39444956, -0.06485313, 0.04390364},
                                             {0.92, 60.0, 0.05643322, -0.01979730, 0.03822653}};

Scene stokes_slab() {
  Scene scene = slab(0.5, 1.0, PhaseFunction::rayleigh, 0.0);
  scene.render.polarisation = true;
  scene.sun.elevation = std::asin(0.2);
  scene.sun.irradiance = {std::numbers::pi, std::numbers::pi, std::numbers::pi};
  scene.camera.altitude = scene.planet.atmosphere_height;
  return scene;
}

TEST(Stokes, OrdersMeetsPublishedSlabs) {
  Scene scene = with_method(stokes_slab(), *find_method("orders"));
  scene.render.parameters["moments_lut"] = TableSize{256, 64};
  for (const PublishedStokes& p : kPublishedStokes) {
    const ProbeResult found = probe_now(scene, {{-std::asin(p.mu), radians(p.azimuth_deg)}}).front();
    EXPECT_NEAR(found.radiance[1], p.i, 1e-3 * p.i);
    EXPECT_NEAR((*found.q)[1], -p.q, 1e-3 * p.i);
    EXPECT_NEAR((*found.u)[1], -p.u, 1e-3 * p.i);
  }
}

TEST(Stokes, PathTraceMeetsPublishedSlabsThroughFilters) {
  for (const PublishedStokes& p : kPublishedStokes) {
    Scene scene = stokes_slab();
    set(scene, "samples", sanitized() ? 64 : 4096);
    const Direction direction{-std::asin(p.mu), radians(p.azimuth_deg)};
    scene.camera.projection = Projection::perspective;
    scene.camera.pitch = direction.elevation;
    scene.camera.azimuth = direction.azimuth;
    for (const double angle : {0.0, 45.0, 90.0, 135.0}) {
      scene.camera.polariser = radians(angle);
      const double leans = 2.0 * filter_angle(scene.camera, direction);
      const double expected = 0.5 * (p.i - p.q * std::cos(leans) - p.u * std::sin(leans));
      const HostPicture picture = trace(scene, std::vector<Direction>{direction});
      const auto error = static_cast<double>(picture.standard_error.at(0, 0)[1]);
      EXPECT_LT(error, (sanitized() ? 0.1 : 0.01) * p.i);
      EXPECT_NEAR(static_cast<double>(picture.radiance.at(0, 0)[1]), expected, 4.0 * error) << angle;
    }
  }
}

// Suns at, and by the last digit beside, the places where azimuths end.
std::vector<double> edge_suns(const Scene& scene) {
  const double r = scene.planet.ground_radius;
  const double dip = -std::acos(r / (r + scene.camera.altitude));
  std::vector<double> suns{radians(60.0), radians(20.0), radians(-4.0)};
  for (const double edge : {std::numbers::pi / 2.0, dip}) {
    suns.insert(suns.end(), {edge, std::nextafter(edge, -2.0), std::min(std::nextafter(edge, 2.0), radians(90.0))});
  }
  return suns;
}

// The zenith, the nadir, and all round.
std::vector<Direction> all_directions() {
  std::vector<Direction> directions;
  for (const double elevation : {-90.0, -89.99, -40.0, -3.0, -0.5, 0.0, 0.5, 10.0, 50.0, 89.99, 90.0}) {
    for (const double azimuth : {0.0, 1e-6, 75.0, 180.0, 290.0}) {
      directions.push_back({radians(elevation), radians(azimuth)});
    }
  }
  return directions;
}

// 2e-5: rounding in float, of light that is wholly polarised.
void expect_no_more_than_light(const ProbeResult& light, const std::string& where) {
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_LE(std::hypot((*light.q)[c], (*light.u)[c]), light.radiance[c] * (1.0 + 2e-5)) << where << ", channel " << c;
  }
}

TEST(Stokes, NoMoreLightIsPolarisedThanThereIs) {
  const auto thin = [](Scene scene) {
    for (Medium& m : scene.media) {
      m.scattering = {m.scattering[0] * 1e-9, m.scattering[1] * 1e-9, m.scattering[2] * 1e-9};
      m.absorption = {};
    }
    return scene;
  };
  Scene molecules = airlight::earth(20.0, 0.0, 0.0);
  molecules.media.resize(1);
  Scene thick = airlight::earth(20.0, 0.0, 0.3);
  for (double& x : thick.media[0].scattering) x *= 8.0;
  Scene bent = molecules;
  bent.planet.refraction.emplace().n_minus_1 = 2.78e-4;
  bent.planet.refraction->density.scale_height = 8.0;
  for (const Scene& air : {airlight::earth(20.0, 0.0, 0.3), molecules, thin(molecules), thick, bent}) {
    for (const double altitude : {0.0, 0.001, 60.0, air.planet.atmosphere_height, 500.0}) {
      Scene scene = with_method(air, *find_method("orders"));
      scene.camera.altitude = altitude;
      for (const double sun : edge_suns(scene)) {
        scene.sun.elevation = sun;
        const std::vector<Direction> directions = all_directions();
        const std::vector<ProbeResult> found = probe_now(scene, directions);
        for (std::size_t i = 0; i < found.size(); ++i) {
          expect_no_more_than_light(found[i], "camera at " + std::to_string(altitude) + " km, sun at " +
                                                  std::to_string(sun) + ", direction " + std::to_string(i));
        }
      }
    }
  }
}

const Layer& layer_called(const Rendering& rendering, std::string_view name) {
  return *std::ranges::find(rendering.layers, name, &Layer::name);
}

// Layers by the table of factors against those by a march of each pixel.
TEST(Stokes, TablesHoldQAndU) {
  for (const double altitude : {0.5, 20.0, 3000.0}) {
    for (const double sun : {-3.0, 0.0, 30.0, 90.0}) {
      Scene scene =
          all_round(with_method(airlight::earth(sun, altitude, 0.2), *find_method("orders")), altitude, 64, 32);
      scene.sun.disc.visible = false;
      std::vector<Rendering> made;
      for (const char* way : {"always", "never"}) {
        scene.render.parameters["tabulate"] = std::string(way);
        made.push_back(render_now(scene, {.layers = LayerSet::stokes}));
        ASSERT_EQ(made.back().fault(), "");
      }
      double error = 0.0;
      double polarised = 0.0;
      for (const char* name : {"Q", "U"}) {
        const std::vector<float>& table = layer_called(made[0], name).planes;
        const std::vector<float>& march = layer_called(made[1], name).planes;
        for (std::size_t i = 0; i < table.size(); ++i) {
          error += static_cast<double>(std::abs(table[i] - march[i]));
          polarised += static_cast<double>(std::abs(march[i]));
        }
      }
      EXPECT_LT(error, 0.01 * polarised) << "from " << altitude << " km, sun at " << sun;
    }
  }
}

double greatest_difference(const RadianceImage& a, const RadianceImage& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const double scale = std::max(static_cast<double>(b.rgba[i]), 1e-3 * greatest(b));
    most = std::max(most, std::abs(static_cast<double>(a.rgba[i] - b.rgba[i])) / scale);
  }
  return most;
}

RadianceImage sum_of_filters(Scene scene, double angle) {
  scene.camera.polariser = radians(angle);
  RadianceImage sum = render_now(scene).radiance;
  scene.camera.polariser = radians(angle + 90.0);
  const RadianceImage other = render_now(scene).radiance;
  for (std::size_t i = 0; i < sum.rgba.size(); ++i) {
    sum.rgba[i] += i % 4 == 3 ? 0.0F : other.rgba[i];
  }
  return sum;
}

// All light passes either a filter or the filter turned by a right angle, what is not polarised by half: the sun's
// disc, the ground, things.
TEST(Stokes, AFilterAndItsRightAngleLetAllLightThrough) {
  Scene clear = airlight::earth(12.0, 0.001, 0.3);
  clear.image = {48, 32};
  clear.sun.disc.angular_radius = radians(0.25);
  clear.camera.projection = Projection::perspective;
  clear.camera.vertical_fov = radians(70.0);
  clear.camera.azimuth = radians(20.0);
  clear.camera.pitch = radians(15.0);
  clear = with_method(clear, *find_method("orders"));
  Scene tabulated = clear;
  tabulated.render.parameters["tabulate"] = std::string("always");
  clear.render.parameters["tabulate"] = std::string("never");
  Scene ball = clear;
  Sphere sphere;
  sphere.azimuth = radians(10.0);
  sphere.elevation = radians(4.0);
  sphere.distance = 0.01;
  sphere.radius = 0.002;
  sphere.albedo = {0.4, 0.4, 0.4};
  ball.spheres.push_back(sphere);
  sphere.azimuth = radians(40.0);
  sphere.material = SphereMaterial::mirror;
  ball.spheres.push_back(sphere);
  const std::pair<const Scene*, double> scenes[]{{&clear, 3e-5}, {&tabulated, 2e-3}, {&ball, 3e-5}};
  for (const auto& [scene, bound] : scenes) {
    const RadianceImage whole = render_now(*scene).radiance;
    for (const double angle : {0.0, 33.0}) {
      EXPECT_LT(greatest_difference(sum_of_filters(*scene, angle), whole), bound) << angle;
    }
    Scene through = *scene;
    through.camera.polariser = radians(33.0);
    EXPECT_GT(greatest_difference(render_now(through).radiance, sum_of_filters(*scene, 0.0)), 0.2);
  }
}

// The filter of a picture is that of its directions.
TEST(Stokes, APictureThroughAFilterIsWhatProbesTell) {
  for (const Projection projection : {Projection::perspective, Projection::fisheye}) {
    Scene scene = with_method(filtered_sky({"", 25.0, 1.0, 1.0, 0.0}), *find_method("orders"));
    scene.camera.projection = projection;
    scene.camera.vertical_fov = radians(projection == Projection::fisheye ? 180.0 : 80.0);
    scene.camera.polariser = radians(25.0);
    scene.image = {24, 16};
    scene.sun.disc.visible = false;
    const RadianceImage picture = render_now(scene).radiance;
    physics::Physics p = geometry_of(scene);
    std::vector<Direction> directions;
    std::vector<std::pair<int, int>> pixels;
    for (int y = 1; y < 16; y += 3) {
      for (int x = 1; x < 24; x += 3) {
        const auto ray = p.view_ray(p.scene.camera, projection_code(projection), x + 0.5, y + 0.5);
        if (ray.inside && ray.direction.y > 0.15) {
          directions.push_back(angles_of(ray.direction));
          pixels.emplace_back(x, y);
        }
      }
    }
    const std::vector<ProbeResult> found = probe_now(scene, directions);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double expected = filtered(found[i], 2, filter_angle(scene.camera, directions[i]));
      EXPECT_NEAR(channel_of(picture, pixels[i].first, pixels[i].second, 2), expected, 2e-4 * found[i].radiance[2]);
    }
  }
}

// Where light in the sun's vertical plane is not polarised, degrees from the sun or from the point opposite to it.
struct Neutral {
  const char* name;
  double sun_deg;
  double azimuth_deg;              // from the sun's
  double from_deg, toward_deg;     // elevations between which Q changes sign
  double zero_deg;                 // elevation of the sun, or of the point opposite
  std::array<double, 3> expected;  // by optical depths 0.046, 0.108 and 0.265
};

// Of molecules over black ground; the values are those of an independent computation in double.
constexpr Neutral kNeutral[]{{"Babinet, sun at 5", 5.0, 0.0, 6.0, 50.0, 5.0, {12.8, 17.5, 23.0}},
                             {"Babinet, sun at 60", 60.0, 0.0, 61.0, 85.0, 60.0, {5.0, 6.8, 8.9}},
                             {"Brewster, sun at 60", 60.0, 0.0, 59.0, 30.0, 60.0, {-5.6, -8.0, -11.5}},
                             {"Arago, sun at 5", 5.0, 180.0, 2.0, 60.0, -5.0, {13.2, 18.1, 24.3}},
                             {"Arago, sun at -2", -2.0, 180.0, 3.0, 60.0, 2.0, {13.3, 18.0, 22.7}}};

TEST(Stokes, NeutralPointsStandWhereTheyBelong) {
  constexpr int kPlaces = 400;
  for (const Neutral& neutral : kNeutral) {
    Scene scene = airlight::earth(neutral.sun_deg, 0.001, 0.0);
    scene.media.resize(1);
    std::vector<Direction> directions;
    const auto elevation = [&](double k) {
      return neutral.from_deg + (neutral.toward_deg - neutral.from_deg) * k / kPlaces;
    };
    for (int k = 0; k <= kPlaces; ++k) {
      directions.push_back({radians(elevation(k)), radians(neutral.azimuth_deg)});
    }
    const std::vector<ProbeResult> found = probe_now(with_method(scene, *find_method("orders")), directions);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto crosses = [&](std::size_t k) { return (*found[k].q)[c] > 0.0 && (*found[k + 1].q)[c] <= 0.0; };
      std::size_t k = 0;
      while (k + 1 < found.size() && !crosses(k)) {
        ++k;
      }
      ASSERT_LT(k + 1, found.size()) << neutral.name;
      const double at = elevation(static_cast<double>(k) + 0.5) - neutral.zero_deg;
      std::printf("%s, channel %zu: %.1f degrees, expected %.1f\n", neutral.name, c, at, neutral.expected[c]);
      EXPECT_NEAR(at, neutral.expected[c], 0.5) << neutral.name;
    }
  }
}

}  // namespace
}  // namespace airlight::test
