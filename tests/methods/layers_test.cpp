// The layers of --layers: the light layers' sum is the picture, and each layer is what its name says.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "core/scene/preset.h"
#include "core/scene/resolve.h"
#include "tests/methods/picture_file.h"
#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

const Layer& layer(const Rendering& rendering, std::string_view name) {
  const auto found = std::find_if(rendering.layers.begin(), rendering.layers.end(),
                                  [&](const Layer& candidate) { return candidate.name == name; });
  EXPECT_NE(found, rendering.layers.end()) << name;
  return *found;
}

double value(const Layer& l, int width, int x, int y, std::size_t c) {
  const std::size_t plane = l.planes.size() / l.channels.size();
  return static_cast<double>(l.planes[c * plane + static_cast<std::size_t>(y * width + x)]);
}

double largest(const Layer& l) {
  return static_cast<double>(*std::max_element(l.planes.begin(), l.planes.end()));
}

Rendering layered(const Scene& scene) {
  RenderRequest request;
  request.layers = LayerSet::light;
  const Rendering rendering = render_now(scene, request);
  EXPECT_EQ(rendering.fault(), "");
  return rendering;
}

// The greatest |sum - picture| over picture + 1e-4 of the brightest pixel, the disc's left out.
double greatest_gap(const Rendering& rendering) {
  const RadianceImage& picture = rendering.radiance;
  const Layer& sun = layer(rendering, "sun");
  double brightest = 0.0;
  double gap = 0.0;
  for (const bool measuring : {false, true}) {
    for (int i = 0; i < picture.width * picture.height; ++i) {
      const int x = i % picture.width;
      const int y = i / picture.width;
      for (std::size_t c = 0; c < 3; ++c) {
        const double beauty = channel_of(picture, x, y, c);
        double sum = 0.0;
        for (const Layer& l : rendering.layers) {
          sum += l.is_light ? value(l, picture.width, x, y, c) : 0.0;
        }
        if (!measuring) {
          brightest = std::max(brightest, value(sun, picture.width, x, y, c) > 0.0 ? 0.0 : beauty);
        } else {
          // A red sun has little or negative blue, as accurate as its red.
          const double whole = std::max({std::abs(channel_of(picture, x, y, 0)), std::abs(channel_of(picture, x, y, 1)),
                                         std::abs(channel_of(picture, x, y, 2))});
          gap = std::max(gap, std::abs(sum - beauty) / (std::max(std::abs(beauty), 1e-3 * whole) + 1e-4 * brightest));
        }
      }
    }
  }
  return gap;
}

constexpr double kHalf = 1.0 / 2048.0;  // half the step of a half

Scene named(const std::string& method, Scene scene) {
  return with_method(std::move(scene), *find_method(method), true);
}

void put(Scene& scene, const std::string& key, ParameterValue parameter) {
  scene.render.parameters.insert_or_assign(key, std::move(parameter));
}

Scene small_sky(double altitude) {
  Scene scene = all_round(earth(), altitude, 24, 12);
  scene.planet.ground_albedo = {0.3, 0.2, 0.1};
  scene.sun.disc.angular_radius = 4.0 * kDegree;
  return scene;
}

// Every shipped preset.
TEST(Layers, SumUpToThePicture_Presets) {
  int presets = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(AIRLIGHT_SOURCE_DIR) / "presets")) {
    if (entry.path().extension() != ".json" || entry.path().stem() == "chart") {
      continue;
    }
    Scene scene = resolve(load_preset(entry.path()), method_infos());
    if (!scene.clouds.empty()) {
      continue;  // LayersOfClouds has smaller ones
    }
    scene.image = {32, 18};
    scene.camera.polariser.reset();  // layers hold light before the lens
    scene = named("orders", std::move(scene));
    ++presets;
    const Rendering rendering = layered(scene);
    EXPECT_LT(greatest_gap(rendering), kHalf) << entry.path();
    EXPECT_EQ(render_now(scene).radiance.rgba, rendering.radiance.rgba) << "layers change the picture";
  }
  EXPECT_GE(presets, 8);
}

// Every method with layers, in each of its ways of rendering: by pixel, by tables and by shells, and from space.
TEST(Layers, SumUpToThePicture_Methods) {
  for (const SkyMethod& method : methods()) {
    if (method.add_layer_passes == nullptr) {
      continue;
    }
    for (const double altitude : {0.001, 300.0}) {
      Scene scene = named(std::string(method.info.name), small_sky(altitude));
      EXPECT_LT(greatest_gap(layered(scene)), kHalf) << method.info.name << " from " << altitude << " km";
    }
  }
  Scene tabulated = named("orders", small_sky(2.0));
  put(tabulated, "tabulate", std::string("always"));
  EXPECT_LT(greatest_gap(layered(tabulated)), kHalf) << "orders by a table";
  put(tabulated, "shells", std::string("always"));
  put(tabulated, "orders", 2);
  EXPECT_LT(greatest_gap(layered(tabulated)), kHalf) << "orders by a table, by shells";
  Scene mixed = small_sky(2.0);
  mixed.media = every_kind().media;
  EXPECT_LT(greatest_gap(layered(named("orders", mixed))), kHalf) << "five media";
}

// A medium's layer is the whole picture of a world in which only that medium scatters, once, and the other media
// attenuate as before; by `march`, which can leave out the rest.
TEST(Layers, AMediumsLayerIsAWorldInWhichItAloneScatters) {
  Scene scene = named("orders", small_sky(0.001));
  scene.media[1].phase = PhaseFunction::isotropic;  // of a peak, `orders` takes a part as unscattered
  put(scene, "steps", 192);
  const Rendering all = layered(scene);
  scene = named("march", scene);
  put(scene, "steps", 192);
  put(scene, "multiple_scattering_scale", 0.0);
  for (std::size_t kept = 0; kept < 2; ++kept) {
    Scene alone = scene;
    alone.planet.ground_albedo = {};
    alone.sun.disc.visible = false;
    for (std::size_t i = 0; i < alone.media.size(); ++i) {
      for (std::size_t c = 0; c < 3 && i != kept; ++c) {
        alone.media[i].absorption[c] += std::exchange(alone.media[i].scattering[c], 0.0);
      }
    }
    const RadianceImage truth = render_now(alone).radiance;
    const Layer& medium = layer(all, scene.media[kept].name);
    const double most = greatest(truth);
    double difference = 0.0;
    for (int i = 0; i < truth.width * truth.height; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const int x = i % truth.width;
        const int y = i / truth.width;
        difference = std::max(difference, std::abs(value(medium, truth.width, x, y, c) - channel_of(truth, x, y, c)));
      }
    }
    EXPECT_GT(most, 0.0);
    EXPECT_LT(difference, 1e-3 * most) << medium.name;
  }
}

TEST(Layers, NoAirLeavesGroundAndSun) {
  Scene scene = small_sky(0.001);
  scene.media = {};
  const Rendering rendering = layered(named("orders", scene));
  std::vector<std::string> names;
  for (const Layer& l : rendering.layers) {
    names.push_back(l.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"multiple", "ground", "transmittance", "sun", "depth", "N"}));
  EXPECT_EQ(largest(layer(rendering, "multiple")), 0.0);
  EXPECT_EQ(*std::min_element(layer(rendering, "transmittance").planes.begin(),
                              layer(rendering, "transmittance").planes.end()),
            1.0f);
  // A Lambertian ground under a sun at 30 degrees of irradiance 1.
  EXPECT_NEAR(value(layer(rendering, "ground"), 24, 5, 11, 0), 0.3 * 0.5 / std::numbers::pi, 1e-4);
  EXPECT_GT(largest(layer(rendering, "sun")), 1.0);
}

// One scatterer over black ground without a sun in the picture: its layer has light, and what it scatters again.
TEST(Layers, OneMediumOverBlackGroundLeavesTwoLayers) {
  Scene scene = small_sky(0.001);
  scene.planet.ground_albedo = {};
  scene.sun.disc.visible = false;
  scene.media.resize(1);
  const Rendering rendering = layered(named("orders", scene));
  EXPECT_GT(largest(layer(rendering, "rayleigh")), 0.0);
  EXPECT_GT(largest(layer(rendering, "multiple")), 0.0);
  for (const char* name : {"ground", "sun"}) {
    EXPECT_EQ(largest(layer(rendering, name)), 0.0) << name;
  }
}

// Directions of pixel centres in an all-round picture; azimuth 0 at the centre column's left edge.
Direction centre_of(const Scene& scene, int x, int y) {
  return {std::numbers::pi * (0.5 - (y + 0.5) / scene.image.height),
          scene.camera.azimuth + std::numbers::pi * (2.0 * (x + 0.5) / scene.image.width - 1.0)};
}

TEST(Layers, TransmittanceIsThatOfTheProbe) {
  for (const SkyMethod& method : methods()) {
    if (method.add_layer_passes == nullptr) {
      continue;
    }
    Scene scene = named(std::string(method.info.name), small_sky(2.0));
    put(scene, "tabulate", std::string("always"));
    const Rendering rendering = layered(scene);
    std::vector<Direction> directions;
    for (int y = 0; y < scene.image.height; ++y) {
      directions.push_back(centre_of(scene, 7, y));
    }
    const std::vector<ProbeResult> probes = probe_now(scene, directions);
    physics::Physics p = make_physics(scene);
    const physics::uint projection = projection_code(scene.camera.projection);
    int crossed = 0;
    for (int y = 0; y < scene.image.height; ++y) {
      const auto view = p.view_ray(p.scene.camera, projection, 7.5, y + 0.5);
      if (p.pixel_rays(p.scene.planet, p.scene.camera, projection, 7.5, y + 0.5, view.direction).count > 1) {
        ++crossed;  // by the horizon: a mean over sky and ground
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = probes[static_cast<std::size_t>(y)].transmittance[c];
        EXPECT_NEAR(value(layer(rendering, "transmittance"), 24, 7, y, c), expected, 2e-5)
            << method.info.name << ", row " << y;
      }
    }
    EXPECT_LE(crossed, 2);
  }
}

// Closed forms straight up and down and level, from inside the air and from above it.
TEST(Layers, DepthAndNormalsAreTheGeometrys) {
  Scene scene = named("orders", vacuum());
  scene.camera.projection = Projection::fisheye;
  scene.camera.vertical_fov = std::numbers::pi;
  scene.image = {9, 9};  // a pixel's centre lies on the axis
  const auto at_axis = [&](double altitude, double pitch) {
    scene.camera.altitude = altitude;
    scene.camera.pitch = pitch * kDegree;
    const Rendering rendering = layered(scene);
    const Layer& n = layer(rendering, "N");
    return std::array<double, 4>{value(layer(rendering, "depth"), 9, 4, 4, 0), value(n, 9, 4, 4, 0),
                                 value(n, 9, 4, 4, 1), value(n, 9, 4, 4, 2)};
  };
  const double radius = scene.planet.ground_radius;
  const double top = scene.planet.atmosphere_height;
  EXPECT_NEAR(at_axis(2.0, 90.0)[0], top - 2.0, 1e-5);
  EXPECT_NEAR(at_axis(2.0, 0.0)[0], std::sqrt((top - 2.0) * (2.0 * radius + top + 2.0)), 1e-3);
  EXPECT_EQ(at_axis(2.0, 90.0)[2], 0.0) << "no ground in the zenith";
  EXPECT_EQ(at_axis(300.0, 90.0)[0], 1e10);
  for (const double altitude : {2.0, 300.0}) {
    const std::array<double, 4> nadir = at_axis(altitude, -90.0);
    EXPECT_NEAR(nadir[0], altitude, 1e-6 * altitude);
    EXPECT_NEAR(nadir[1], 0.0, 1e-7);
    EXPECT_NEAR(nadir[2], 1.0, 1e-7);
    EXPECT_NEAR(nadir[3], 0.0, 1e-7);
  }
  // 45 degrees down from 300 km, looking north: d = r s - sqrt(R^2 - r^2 s^2) with s = sin 45; N leans to the north.
  const double r = radius + 300.0;
  const double distance = r * std::sqrt(0.5) - std::sqrt(radius * radius - 0.5 * r * r);
  const std::array<double, 4> oblique = at_axis(300.0, -45.0);
  EXPECT_NEAR(oblique[0], distance, 1e-4);
  EXPECT_NEAR(oblique[2], (r - distance * std::sqrt(0.5)) / radius, 1e-6);
  EXPECT_NEAR(oblique[3], -distance * std::sqrt(0.5) / radius, 1e-6);
  EXPECT_NEAR(std::hypot(oblique[1], oblique[2], oblique[3]), 1.0, 1e-6);
}

TEST(Layers, AreCalledByTheirMediaAsFarAsAChannelCanBe) {
  Scene scene = vacuum();
  for (const char* name : {"mie", "a dusty.haze!", "sun", "", "a_dusty_haze_"}) {
    scene.media.push_back(medium(name, {1e-3, 1e-3, 1e-3}, {}, exponential(8.0)));
  }
  scene.media.push_back(medium("ozone", {}, {1e-3, 1e-3, 1e-3}, exponential(8.0)));
  std::vector<std::string> names;
  for (const Layer& l : layers_of(ready(scene), LayerSet::light)) {
    names.push_back(l.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"mie", "a_dusty_haze_", "sun_2", "medium4", "a_dusty_haze__2", "multiple",
                                             "ground", "transmittance", "sun", "depth", "N"}));
}

TEST(Layers, AFaultNamesTheLayerAndThePlace) {
  Layer bad{.name = "mie", .channels = "RGB", .is_light = true, .planes = std::vector<float>(3 * 8, 1.0f)};
  bad.planes[8 + 5] = -1.0f;
  bad.planes[16 + 6] = std::numeric_limits<float>::quiet_NaN();
  Rendering rendering;
  rendering.layer_statistics = {{"sun", {}}, {bad.name, layer_statistics(bad, 4)}};
  EXPECT_EQ(rendering.fault(), "the layer mie holds 1 non-finite and 1 negative values, the first at column 1, row 1");
  const Layer normals{.name = "N", .channels = "XYZ", .is_signed = true, .planes = std::vector<float>(3 * 8, -1.0f)};
  EXPECT_TRUE(layer_statistics(normals, 4).sound());
}

}  // namespace
}  // namespace airlight::test
