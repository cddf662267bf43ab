// Pixels of several rays in pictures of things by tables: the list of rays (shaders/shared/thing_list.glsl).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/air/scene_block.h"
#include "core/methods/method.h"
#include "tests/methods/listed_rays.h"
#include "tests/methods/render_fixture.h"
#include "tests/methods/spectral_scene.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using physics::Physics;

Sphere ball_in_the_sky(SphereMaterial material, double azimuth, double elevation, double radius) {
  Sphere sphere;
  sphere.azimuth = azimuth * kDegree;
  sphere.elevation = elevation * kDegree;
  sphere.distance = 0.02;
  sphere.radius = radius;
  sphere.material = material;
  sphere.albedo = {0.6, 0.6, 0.6};
  return sphere;
}

// The camera looks up, past the ground and shadows on it.
Scene sky_with(std::vector<Sphere> balls, ImageSize size) {
  Scene scene = with_method(earth(), *find_method("orders"));
  scene.render.parameters.insert_or_assign("tabulate", std::string("always"));
  scene.sun.elevation = 40.0 * kDegree;
  scene.sun.azimuth = 200.0 * kDegree;
  scene.sun.disc.visible = false;
  scene.bloom.enabled = false;
  scene.camera.altitude = 0.02;
  scene.camera.azimuth = 90.0 * kDegree;
  scene.camera.pitch = 30.0 * kDegree;
  scene.camera.vertical_fov = 20.0 * kDegree;
  scene.image = size;
  scene.spheres = std::move(balls);
  return scene;
}

// A pixel's rays in the picture, from its upper left corner.
using Places = std::vector<std::pair<double, double>>;

Places on_grid() {
  Places found;
  for (int i = 0; i < 16; ++i) {
    found.emplace_back((i % 4 + 0.5) / 4.0, (i / 4 + 0.5) / 4.0);
  }
  return found;
}

// Many, no two of which share a row or a column, so that an edge along either is resolved as well as others.
Places spread_out() {
  constexpr int kCount = 121;
  Places found;
  for (int i = 0; i < kCount; ++i) {
    const double turns = 0.618033988749895 * i;
    found.emplace_back((i + 0.5) / kCount, turns - std::floor(turns));
  }
  return found;
}

Places places(SphereMaterial material) {
  if (material == SphereMaterial::mirror) {
    Places found;
    constexpr std::array<int, 8> kRow{2, 5, 4, 1, 6, 3, 7, 0};
    constexpr std::array<int, 8> kColumn{4, 3, 6, 2, 1, 0, 5, 7};
    for (std::size_t i = 0; i < 8; ++i) {
      found.emplace_back((kColumn[i] + 0.5) / 8.0, (kRow[i] + 0.5) / 8.0);
    }
    return found;
  }
  return on_grid();
}

// What a ray meets: which ball, rock, or what a mirror shows; 0: nothing.
unsigned int met_by(Physics& p, const Scene& scene, const physics::vec3& view) {
  const auto sight = p.sight_of(view);
  const auto hit = p.nearest_thing(p.scene.planet, sight, physics::kNoBody);
  if (hit.what != p.kMeetsBody) {
    return hit.what == p.kMeetsTerrain ? 50 : 0;
  }
  const auto surface = p.surface_at(p.scene.planet, scene.camera.altitude, sight, hit, 0.0);
  if (!surface.mirrors) {
    return hit.which + 1;
  }
  const physics::vec3 away = view - surface.normal * (2.0 * physics::dot(view, surface.normal));
  const auto second =
      p.sight_from(p.scene.planet, scene.camera.altitude, surface.place.point, away, p.scene.sun.direction);
  const auto behind = p.nearest_thing(p.scene.planet, second, hit.which);
  return 100 + (behind.what == p.kMeetsBody ? behind.which + 1 : 0);
}

struct Means {
  std::vector<double> mean;  // of a pixel's rays, each found as a listed direction
  std::vector<bool> uneven;  // they do not all meet the same
};

Means means_of_rays(const Scene& scene, const Places& at) {
  const Part part = part_of(scene);
  Physics p = formulas_of(part.air, part.scene);
  part.things.put_into(p);
  std::vector<Direction> directions;
  Means means;
  for (int k = 0; k < scene.image.width * scene.image.height; ++k) {
    std::set<unsigned int> met;
    for (const auto& [x, y] : at) {
      const double column = k % scene.image.width + x;
      const double row = k / scene.image.width + y;
      const auto view = p.view_ray(p.scene.camera, physics::kProjectionPerspective, column, row).direction;
      met.insert(met_by(p, scene, view));
      directions.push_back(angles_of(view));
    }
    means.uneven.push_back(met.size() > 1);
  }
  const std::vector<float> rays = probe_picture([]() -> Executor& { return executor(); }, scene, directions);
  for (std::size_t k = 0; k < directions.size() / at.size(); ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      sum += static_cast<double>(rays[3 * (k * at.size() + i) + 1]) / static_cast<double>(at.size());
    }
    means.mean.push_back(sum);
  }
  return means;
}

// Pixels whose rays do not all meet the same are the mean of their rays.
void expect_means(const Scene& scene, SphereMaterial material, int fewest, const std::string& what) {
  const RadianceImage picture = render_now(scene).radiance;
  const Means means = means_of_rays(scene, places(material));
  int uneven = 0;
  double worst = 0.0;
  for (std::size_t k = 0; k < means.mean.size(); ++k) {
    if (!means.uneven[k]) {
      continue;
    }
    ++uneven;
    const double here =
        channel_of(picture, static_cast<int>(k) % picture.width, static_cast<int>(k) / picture.width, 1);
    worst = std::max(worst, std::abs(here / means.mean[k] - 1.0));
  }
  std::printf("%s: %d pixels, %.2g off the means of their rays\n", what.c_str(), uneven, worst);
  EXPECT_GE(uneven, fewest) << what;
  EXPECT_LT(worst, 2e-4) << what;
}

TEST(ThingRays, EdgesAreTheMeanOfSixteen) {
  for (const ImageSize size : {ImageSize{21, 13}, ImageSize{64, 40}, ImageSize{9, 7}}) {
    const Scene scene = sky_with({ball_in_the_sky(SphereMaterial::matte, 84.0, 30.0, 0.001),
                                  ball_in_the_sky(SphereMaterial::matte, 95.0, 33.0, 0.0015)},
                                 size);
    expect_means(scene, SphereMaterial::matte, size.width, std::to_string(size.width));
  }
}

// Where the limb of a wide ball crosses a pixel alone, the pixel's two rays have the shares of its area: they are
// nearer to a fine mean than sixteen rays are.
TEST(ThingRays, LimbsHaveTheSharesOfTheirAreas) {
  for (const SphereMaterial material : {SphereMaterial::matte, SphereMaterial::translucent}) {
    Scene scene = sky_with({ball_in_the_sky(material, 90.0, 30.0, 0.0032)}, {72, 60});
    scene.camera.vertical_fov = 6.0 * kDegree;
    int limb = 0;
    double worst = 0.0;
    double mean = 0.0;
    double mean_of_sixteen = 0.0;
    for (const auto& [azimuth, pitch] : {std::pair{79.4, 30.0}, {100.6, 30.0}, {90.0, 39.2}, {90.0, 20.8}}) {
      scene.camera.azimuth = azimuth * kDegree;
      scene.camera.pitch = pitch * kDegree;
      const RadianceImage picture = render_now(scene).radiance;
      const Means fine = means_of_rays(scene, spread_out());
      const Means sixteen = means_of_rays(scene, on_grid());
      for (std::size_t k = 0; k < fine.mean.size(); ++k) {
        if (!fine.uneven[k]) {
          continue;
        }
        const double here =
            channel_of(picture, static_cast<int>(k) % picture.width, static_cast<int>(k) / picture.width, 1);
        const double off = std::abs(here / fine.mean[k] - 1.0);
        ++limb;
        worst = std::max(worst, off);
        mean += off;
        mean_of_sixteen += std::abs(sixteen.mean[k] / fine.mean[k] - 1.0);
      }
    }
    std::printf("%d pixels of limbs: %.4f off a fine mean, at most %.4f; sixteen rays are %.4f\n", limb, mean / limb,
                worst, mean_of_sixteen / limb);
    EXPECT_GT(limb, 250);
    EXPECT_LT(mean, 0.3 * mean_of_sixteen);
    EXPECT_LT(worst, 0.15);  // of a dark pixel next to a bright ball
  }
}

// A ball's shadow seen from near by, its edge wider than a pixel across: pixels are means there.
TEST(ThingRays, WideEdgesOfShadowsAreMeans) {
  Scene scene = sky_with({ball_in_the_sky(SphereMaterial::matte, 90.0, 20.0, 0.0005)}, {96, 32});
  scene.planet.ground_albedo = {0.2, 0.2, 0.2};
  scene.spheres.front().distance = 0.01;
  scene.sun.azimuth = 270.0 * kDegree;
  scene.camera.altitude = 0.002;
  scene.camera.pitch = -7.2 * kDegree;
  scene.camera.vertical_fov = 1.6 * kDegree;
  const RadianceImage picture = render_now(scene).radiance;
  const Means fine = means_of_rays(scene, spread_out());
  double worst = 0.0;
  double least = 1e9;
  double most = 0.0;
  for (std::size_t k = 0; k < fine.mean.size(); ++k) {
    const double here =
        channel_of(picture, static_cast<int>(k) % picture.width, static_cast<int>(k) / picture.width, 1);
    worst = std::max(worst, std::abs(here / fine.mean[k] - 1.0));
    least = std::min(least, fine.mean[k]);
    most = std::max(most, fine.mean[k]);
  }
  std::printf("a shadow of %.2f of the light: %.4f off a fine mean\n", least / most, worst);
  EXPECT_LT(least, 0.5 * most);
  EXPECT_LT(worst, 0.08);
}

// A block whose pixels all ask for as many units as a pixel may.
TEST(ThingRays, ABlockMayBeAllEdges) {
  std::vector<Sphere> balls;
  constexpr double kPixel = 20.0 / 16.0;  // degrees
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      balls.push_back(ball_in_the_sky(SphereMaterial::matte, 90.0 + (i - 3.5) * kPixel / std::cos(30.0 * kDegree),
                                      30.0 + (j - 3.5) * kPixel, 0.02 * 0.45 * kPixel * kDegree));
    }
  }
  expect_means(sky_with(balls, {16, 16}), SphereMaterial::matte, 64, "a block of edges");
}

// Away from its edge, of which all rays are sixteen, a mirror that shows another ball is the mean of eight.
TEST(ThingRays, MirrorsAreTheMeanOfEight) {
  Scene scene = sky_with({ball_in_the_sky(SphereMaterial::mirror, 90.0, 30.0, 0.006),
                          ball_in_the_sky(SphereMaterial::matte, 290.0, 20.0, 0.004)},
                         {40, 40});
  scene.camera.vertical_fov = 24.0 * kDegree;  // within the mirror
  expect_means(scene, SphereMaterial::mirror, 10, "a mirror");
}

// A skyline of mountains: all but few pixels that show rock and sky are the mean of sixteen rays.
TEST(ThingRays, SkylinesAreTheMeanOfSixteen) {
  Scene scene = sky_with({}, {72, 40});
  scene.render.parameters.insert_or_assign("volumetric_shadows", std::string("exact"));
  scene.camera.pitch = 4.0 * kDegree;
  Terrain terrain;
  terrain.ridge = Ridge{7, 1.6};
  terrain.width = 20.0;
  terrain.bearing = 90.0 * kDegree;
  terrain.distance = 8.0;
  terrain.turn = 90.0 * kDegree;
  terrain.albedo = {0.4, 0.4, 0.4};
  scene.terrain = terrain;
  const RadianceImage picture = render_now(scene).radiance;
  const Means means = means_of_rays(scene, places(SphereMaterial::matte));
  int uneven = 0;
  int off = 0;
  for (std::size_t k = 0; k < means.mean.size(); ++k) {
    const double here =
        channel_of(picture, static_cast<int>(k) % picture.width, static_cast<int>(k) / picture.width, 1);
    uneven += means.uneven[k] ? 1 : 0;
    off += means.uneven[k] && std::abs(here / means.mean[k] - 1.0) > 0.03 ? 1 : 0;
  }
  std::printf("a skyline: %d pixels, %d of them off the means of their rays\n", uneven, off);
  EXPECT_GT(uneven, 60);
  EXPECT_LT(off, uneven / 10);
}

// How far pixels around a ball's shadow on the ground, three pixels high, are off the means of sixteen rays.
double off_around_a_shadow(double azimuth) {
  Scene scene = sky_with({ball_in_the_sky(SphereMaterial::matte, 0.0, 8.0, 0.001)}, {640, 360});
  scene.planet.ground_albedo = {0.2, 0.2, 0.2};
  scene.spheres.front().distance = 0.01;
  scene.sun.elevation = 35.0 * kDegree;
  scene.sun.azimuth = azimuth * kDegree;
  scene.camera.projection = Projection::equirectangular;
  scene.camera.altitude = 0.002;
  scene.camera.azimuth = 0.0;
  scene.camera.pitch = 0.0;
  const RadianceImage picture = render_now(scene).radiance;
  Physics p = make_physics(scene);
  const auto at = places(SphereMaterial::matte);
  constexpr int kFirst = 276;
  constexpr int kEnd = 312;
  double worst = 0.0;
  for (int y = 192; y < 202; ++y) {
    std::vector<Direction> directions;
    for (int x = kFirst; x < kEnd; ++x) {
      for (const auto& [right, down] : at) {
        directions.push_back(
            angles_of(p.view_ray(p.scene.camera, physics::kProjectionEquirectangular, x + right, y + down).direction));
      }
    }
    const std::vector<float> rays = probe_picture([]() -> Executor& { return executor(); }, scene, directions);
    for (int x = kFirst; x < kEnd; ++x) {
      double mean = 0.0;
      for (std::size_t i = 0; i < at.size(); ++i) {
        mean += static_cast<double>(rays[3 * (static_cast<std::size_t>(x - kFirst) * at.size() + i) + 1]) / 16.0;
      }
      worst = std::max(worst, std::abs(channel_of(picture, x, y, 1) / mean - 1.0));
    }
  }
  return worst;
}

// Where a shadow ends between four corners that are all lit, pixels are the mean of their rays as well.
TEST(ThingRays, ShadowsEndWhereTheyDo) {
  for (double azimuth = 134.2; azimuth < 136.0; azimuth += 0.2) {
    const double off = off_around_a_shadow(azimuth);
    std::printf("sun at %.1f: around a shadow %.4f off the mean of rays\n", azimuth, off);
    EXPECT_LT(off, 0.2) << azimuth;  // a tip between a pixel's own corners is not seen
  }
}

// A ball fills the picture, the sun beside it: at the terminator light changes most from pixel to pixel.
TEST(ThingRays, LightThatDiffersIsAskedForItself) {
  const Scene scene = sky_with({ball_in_the_sky(SphereMaterial::matte, 90.0, 30.0, 0.01)}, {61, 45});
  const RadianceImage picture = render_now(scene).radiance;
  const std::vector<float> rays = listed_rays_of(scene);
  double worst = 0.0;
  int exact = 0;
  for (int k = 0; k < picture.width * picture.height; ++k) {
    const double truth = rays[3 * static_cast<std::size_t>(k) + 1];
    const double off = std::abs(channel_of(picture, k % picture.width, k / picture.width, 1) / truth - 1.0);
    worst = std::max(worst, off);
    exact += off < 1e-6 ? 1 : 0;
  }
  const double share = exact / static_cast<double>(picture.width * picture.height);
  std::printf("a terminator: %.4f off at most, %.2f of the pixels are their rays\n", worst, share);
  EXPECT_LT(worst, 0.01);
  EXPECT_LT(share, 0.9);  // many lie between rays
}

}  // namespace
}  // namespace airlight::test
