// Clouds among a picture's layers and in the air before things: what is seen through them, and what is their own.

#include <algorithm>
#include <cmath>

#include "tests/methods/cloud_scene.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

constexpr double kHalf = 1.0 / 2048.0;  // half the step of a half

Rendering cloudy_layers(const Scene& scene, LayerSet set = LayerSet::light) {
  RenderRequest request;
  request.layers = set;
  const Rendering rendering = render_now(scene, request);
  EXPECT_EQ(rendering.fault(), "");
  return rendering;
}

const std::vector<float>& planes_named(const Rendering& rendering, std::string_view name) {
  const auto found = std::ranges::find(rendering.layers, name, &Layer::name);
  EXPECT_NE(found, rendering.layers.end()) << name;
  return found->planes;
}

// Balls over air that scatters and ground that is not black, seen from above, within and below them.
Scene cloudy_earth(double altitude, double elevation_deg) {
  Scene scene = all_round(earth(), altitude, 24, 12);
  scene.planet.ground_albedo = {0.3, 0.2, 0.1};
  scene.sun.elevation = radians(elevation_deg);
  scene.clouds = under_level_cloud(1.0, 0.5).clouds;
  scene.clouds.front().contents = field_of_balls();
  scene.sun.disc.angular_radius = radians(4.0);
  return with_method(scene, *find_method("orders"));
}

// The greatest difference of the layers' sum from the picture, over the picture and a ten-thousandth of its brightest.
double gap_of_sum(const Rendering& rendering) {
  const RadianceImage& picture = rendering.radiance;
  const std::size_t pixels = picture.rgba.size() / 4;
  const std::vector<float>& sun = planes_named(rendering, "sun");
  std::vector<double> sum(3 * pixels, 0.0);
  for (const Layer& layer : rendering.layers) {
    for (std::size_t i = 0; layer.is_light && i < sum.size(); ++i) {
      sum[i] += static_cast<double>(layer.planes[i]);
    }
  }
  double brightest = 0.0;
  double gap = 0.0;
  for (const bool measuring : {false, true}) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const auto seen = static_cast<double>(picture.rgba[4 * (i % pixels) + i / pixels]);
      if (!measuring) {
        brightest = std::max(brightest, sun[i] > 0.0F ? 0.0 : seen);
      } else {
        gap = std::max(gap, std::abs(sum[i] - seen) / (seen + 1e-4 * brightest));
      }
    }
  }
  return gap;
}

TEST(LayersOfClouds, SumUpToThePicture) {
  for (const double altitude : {0.1, 1.5, 4.0}) {
    for (const double elevation : {35.0, 2.0}) {
      const Scene scene = cloudy_earth(altitude, elevation);
      const Rendering rendering = cloudy_layers(scene);
      EXPECT_LT(gap_of_sum(rendering), kHalf) << altitude << " km, " << elevation;
      EXPECT_EQ(render_now(scene).radiance.rgba, rendering.radiance.rgba) << "layers change the picture";
    }
  }
  Scene two = cloudy_earth(0.1, 35.0);
  two.clouds.push_back(under_level_cloud(0.7, 0.5).clouds.front());
  two.clouds.back().base = 3.0;
  two.clouds.back().top = 4.0;
  EXPECT_LT(gap_of_sum(cloudy_layers(two)), kHalf) << "two fields";
  two.camera.altitude = 6.0;
  EXPECT_LT(gap_of_sum(cloudy_layers(two)), kHalf) << "two fields from above";
}

// Where nothing else sends light, the cloud's layer is the picture, and the others are black.
TEST(LayersOfClouds, AloneIsThePicture) {
  Scene scene = under_level_cloud(4.0, 0.6);
  scene.image = {16, 9};
  scene.camera.pitch = radians(40.0);
  const Rendering rendering = cloudy_layers(scene);
  const std::vector<float>& cloud = planes_named(rendering, "cloud");
  const std::size_t pixels = cloud.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i) {
    EXPECT_NEAR(cloud[i], rendering.radiance.rgba[4 * i], 1e-4F * rendering.radiance.rgba[4 * i]) << i;
    EXPECT_GT(cloud[i], 0.0F);
    EXPECT_EQ(planes_named(rendering, "ground")[i], 0.0F);
  }
}

// A black level cloud sends nothing; alpha is what it takes from a beam, its depth lies between base and top, and a
// beam through it loses just that.
TEST(LayersOfClouds, ABlackCloudHides) {
  constexpr double kDepth = 1.2;
  Scene scene = under_level_cloud(kDepth, 0.6);
  scene.clouds.front().single_scattering_albedo = 0.0;
  scene.image = {16, 9};
  scene.camera.pitch = radians(60.0);
  Scene clear = scene;
  clear.clouds.clear();
  const Rendering rendering = cloudy_layers(scene);
  const Rendering without = cloudy_layers(clear);
  physics::Physics p = geometry_of(scene);
  const physics::uint projection = projection_code(scene.camera.projection);
  for (int i = 0; i < 16 * 9; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double up = p.view_ray(p.scene.camera, projection, i % 16 + 0.5, i / 16 + 0.5).direction.y;
    const double through = std::exp(-kDepth / up);
    EXPECT_EQ(planes_named(rendering, "cloud")[at], 0.0F);
    EXPECT_NEAR(planes_named(rendering, "cloud_alpha")[at], 1.0 - through, 0.01) << i;
    EXPECT_NEAR(planes_named(rendering, "transmittance")[at] / planes_named(without, "transmittance")[at], through,
                0.01);
    const double distance = static_cast<double>(planes_named(rendering, "cloud_depth")[at]);
    EXPECT_GT(distance * up, 1.0 - scene.camera.altitude) << i;
    EXPECT_LT(distance * up, 1.5 - scene.camera.altitude) << i;  // nearer than the cloud's middle
  }
}

// A black sheet of this depth, a few metres above the camera, so that all air is behind it.
Cloud low_sheet(double depth, double base) {
  Cloud cloud = under_level_cloud(depth, 0.5).clouds.front();
  auto thin = std::make_shared<CloudFile>(*cloud.contents);
  cloud.single_scattering_albedo = 0.0;
  cloud.base = base;
  cloud.top = base + 0.04;
  thin->lowest = base + 0.001;
  thin->dz = 0.002;
  std::ranges::fill(thin->extinction, static_cast<float>(depth / 0.04));
  thin->identity = "low sheet " + std::to_string(depth);
  cloud.contents = thin;
  return cloud;
}

Scene polarised_sky() {
  Scene scene = cloudy_earth(0.0, 20.0);
  scene.media.resize(1);                         // molecules
  scene.planet.ground_albedo = {0.0, 0.0, 0.0};  // a black sheet would dim the light that ground sends into the air
  scene.clouds.clear();
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = radians(30.0);
  scene.camera.pitch = radians(70.0);
  scene.sun.disc.visible = false;
  return scene;
}

// Of polarised light black clouds, one or two, leave what they leave of all light, and that is what they leave of a
// beam where all air is behind them: in layers and in directions. But each sheet also counts as taking the light that
// air gets from below, of which moments of degree 2 hold some above black ground: up to 5 % of all light a sheet.
TEST(LayersOfClouds, QAndUAreSeenThroughTheClouds) {
  const Scene clear = polarised_sky();
  const Rendering without = cloudy_layers(clear, LayerSet::stokes);
  physics::Physics p = geometry_of(clear);
  const physics::uint projection = projection_code(clear.camera.projection);
  const std::vector<float>& bare = planes_named(without, "Q");
  const float largest = std::abs(*std::ranges::max_element(bare, {}, [](float q) { return std::abs(q); }));
  for (const bool two : {false, true}) {
    Scene scene = clear;
    scene.clouds = {low_sheet(0.5, 0.01)};
    if (two) {
      scene.clouds.push_back(low_sheet(0.3, 0.06));
    }
    const double depth = two ? 0.8 : 0.5;
    const double most_off = two ? 0.04 : 0.03;
    const Rendering rendering = cloudy_layers(scene, LayerSet::stokes);
    const std::vector<float>& seen = rendering.radiance.rgba;
    const std::vector<float>& clear_seen = without.radiance.rgba;
    std::vector<Direction> directions;
    std::vector<double> expected;
    for (int i = 0; i < scene.image.width * scene.image.height; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (std::abs(bare[at]) < 0.2F * largest) {
        continue;
      }
      const physics::vec3 d =
          p.view_ray(p.scene.camera, projection, i % scene.image.width + 0.5, i / scene.image.width + 0.5).direction;
      const double through = std::exp(-depth / d.y);
      EXPECT_NEAR(planes_named(rendering, "Q")[at] / bare[at], through, most_off) << i << " " << two;
      EXPECT_NEAR(planes_named(rendering, "Q")[at] / bare[at], seen[4 * at] / clear_seen[4 * at], 1e-3F) << i;
      directions.push_back(angles_of(d));
      expected.push_back(through);
    }
    ASSERT_GE(directions.size(), 10u);
    const std::vector<ProbeResult> clear_probes = probe_now(clear, directions);
    const std::vector<ProbeResult> probes = probe_now(scene, directions);
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const double left = probes[i].q.value()[1] / clear_probes[i].q.value()[1];
      EXPECT_NEAR(left, expected[i], most_off) << i << " " << two;
      EXPECT_NEAR(left, probes[i].radiance[1] / clear_probes[i].radiance[1], 1e-3) << i << " " << two;
    }
  }
}

// Two filters at a right angle let all light through. A thick cloud's light passes one by half, whichever way it is
// turned; the sky beside clouds is as polarised as without them.
TEST(LayersOfClouds, AFilterTurnsTheSkyAlone) {
  Scene scene = polarised_sky();
  scene.clouds = under_level_cloud(1.0, 0.5).clouds;
  scene.clouds.front().contents = field_of_balls();
  scene.render.parameters.insert_or_assign("cloud_resolution", std::string("full"));  // as through filters
  const auto through = [](Scene of, double degrees) {
    of.camera.polariser = radians(degrees);
    return render_now(of).radiance;
  };
  const Rendering whole = cloudy_layers(scene);
  const RadianceImage one = through(scene, 20.0);
  const RadianceImage other = through(scene, 110.0);
  Scene clear = scene;
  clear.clouds.clear();
  const RadianceImage bare = render_now(clear).radiance;
  const RadianceImage bare_one = through(clear, 20.0);
  const std::vector<float>& alpha = planes_named(whole, "cloud_alpha");
  double turned = 0.0;
  int open = 0;
  for (std::size_t i = 0; i < alpha.size(); ++i) {
    const double all = static_cast<double>(whole.radiance.rgba[4 * i + 1]);
    const double share = static_cast<double>(one.rgba[4 * i + 1]) / all;
    EXPECT_NEAR(share + static_cast<double>(other.rgba[4 * i + 1]) / all, 1.0, 2e-3) << i;
    const double bare_share = static_cast<double>(bare_one.rgba[4 * i + 1] / bare.rgba[4 * i + 1]);
    turned = std::max(turned, std::abs(bare_share - 0.5));
    if (alpha[i] == 0.0F) {
      EXPECT_NEAR(share, bare_share, 2e-3) << i;
      ++open;
    } else if (alpha[i] > 0.99F) {
      EXPECT_LT(std::abs(share - 0.5), 0.5 * std::abs(bare_share - 0.5) + 0.02) << i;
    }
  }
  EXPECT_GT(turned, 0.2);
  EXPECT_GT(open, 20);
  Scene thick = under_level_cloud(16.0, 0.5);
  thick.image = {12, 6};
  thick.camera.pitch = radians(60.0);
  const RadianceImage unfiltered = render_now(thick).radiance;
  const RadianceImage filtered = through(thick, 77.0);
  for (std::size_t i = 0; i < unfiltered.rgba.size(); i += 4) {
    EXPECT_NEAR(filtered.rgba[i], 0.5F * unfiltered.rgba[i], 1e-4F * unfiltered.rgba[i]);
  }
}

// The air and the cloud before a thing: nothing before the base, all of it behind the top, and in between what the
// integral through the grid says.
TEST(CloudSpans, EndAtTheThing) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(35.0)));
  scene.clouds.front().contents = field_of_balls();
  scene.clouds.front().single_scattering_albedo = 0.0;
  scene.image = {16, 9};
  scene.camera.pitch = radians(40.0);
  scene.camera.altitude = 0.2;
  const CloudGrid grid = cloud_grid(scene.clouds.front());
  physics::Physics p = geometry_of(scene);
  const physics::uint projection = projection_code(scene.camera.projection);
  double most = 0.0;
  double least = 1.0;
  for (const double distance : {1.0, 1.8, 2.4, 5.0}) {
    const std::vector<AirTo> airs = air_to(executor(), scene, spans_at(scene, distance));
    double error = 0.0;
    for (int i = 0; i < 16 * 9; ++i) {
      const physics::vec3 d = p.view_ray(p.scene.camera, projection, i % 16 + 0.5, i / 16 + 0.5).direction;
      const double want = std::exp(-water_depth_from(grid, {0.0, 0.0, 0.2}, {d.x, -d.z, d.y}, distance));
      const auto got = static_cast<double>(airs[static_cast<std::size_t>(i)].transmittance[1]);
      error += std::abs(got - want) / (16 * 9);
      most = std::max(most, want);
      least = std::min(least, want);
      EXPECT_NEAR(got, want, 0.1) << distance << " " << i;
    }
    EXPECT_LT(error, 0.01) << distance;
  }
  EXPECT_GT(most, 0.99);
  EXPECT_LT(least, 0.05);
}

// A thing on black ground has before it what the picture shows there, and one beyond all clouds the whole sky.
TEST(CloudSpans, UpToTheGroundAreThePicture) {
  for (const double altitude : {0.1, 1.5, 4.0}) {
    Scene scene = cloudy_earth(altitude, 35.0);
    scene.planet.ground_albedo = {0.0, 0.0, 0.0};
    scene.sun.disc.visible = false;
    RenderRequest request;
    request.layers = LayerSet::light;
    const Rendering rendering = render_now(scene, request);
    const std::vector<float>& depth = planes_named(rendering, "depth");
    const std::vector<AirTo> airs = air_to_all(executor(), scene, depth);
    double error = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < airs.size(); ++i) {
      error += std::abs(static_cast<double>(airs[i].radiance[1] - rendering.radiance.rgba[4 * i + 1]));
      all += static_cast<double>(rendering.radiance.rgba[4 * i + 1]);
    }
    std::printf("from %.1f km, up to the ray's end: %.3f %% off the picture\n", altitude, 100.0 * error / all);
    EXPECT_LT(error / all, 0.01) << altitude;
  }
}

// Things among clouds are lit in pictures alone.
TEST(LayersOfClouds, AmongThingsAreRefused) {
  Scene scene = cloudy_earth(0.1, 35.0);
  Sphere sphere;
  sphere.elevation = radians(10.0);
  sphere.distance = 1.0;
  sphere.radius = 0.1;
  sphere.albedo = {0.5, 0.5, 0.5};
  scene.spheres = {sphere};
  RenderRequest request;
  request.layers = LayerSet::light;
  for (const bool layers : {false, true}) {
    try {
      if (layers) {
        render_now(scene, request);
      } else {
        air_to(executor(), scene, spans_at(scene, 1.0));
      }
      FAIL() << "not refused";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("where no terrain, spheres or ground maps stand"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace airlight::test
