// Pictures of clouds whose rays are not all marched.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/render/render.h"
#include "tests/methods/cloud_scene.h"

namespace airlight::test {
namespace {

Scene framed(Scene scene, const std::string& resolution) {
  scene.camera.projection = Projection::perspective;
  scene.camera.vertical_fov = radians(40.0);
  scene.camera.pitch = radians(34.0);
  scene.camera.azimuth = radians(70.0);
  scene.camera.altitude = 0.2;
  scene.image = {144, 81};
  scene.media.front().scattering = {2e-3, 5e-3, 1.2e-2};
  scene.planet.ground_albedo = {0.2, 0.2, 0.2};
  scene.render.parameters.insert_or_assign("cloud_resolution", resolution);
  return scene;
}

Scene below_balls(const std::string& resolution) {
  Scene scene = under_level_cloud(1.0, std::sin(radians(35.0)));
  scene.clouds.front().contents = field_of_balls();
  return framed(std::move(scene), resolution);
}

struct Difference {
  double mean = 0.0;   // relative
  double most = 0.0;   // likewise
  double equal = 0.0;  // share of pixels that are equal to the bit
};

Difference between(const RadianceImage& image, const RadianceImage& reference) {
  Difference found;
  const std::size_t pixels = image.rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    bool equal = true;
    for (std::size_t c = 4 * i; c < 4 * i + 3; ++c) {
      const double off = std::abs(double{image.rgba[c]} / double{reference.rgba[c]} - 1.0);
      found.mean += off / static_cast<double>(3 * pixels);
      found.most = std::max(found.most, off);
      equal = equal && image.rgba[c] == reference.rgba[c];
    }
    found.equal += equal ? 1.0 / static_cast<double>(pixels) : 0.0;
  }
  return found;
}

Difference halved(const Scene& half, const Scene& full) {
  const Difference found = between(render_now(half).radiance, render_now(full).radiance);
  std::printf("half against full: %.4f %% in the mean, %.3f %% at most, %.0f %% of the pixels equal\n",
              100.0 * found.mean, 100.0 * found.most, 100.0 * found.equal);
  return found;
}

// Light that is smooth over the picture is that of the rays around a pixel, to the second order. The cells are as high
// as the cloud's own: by 15 layers in place of its 20 pixels are up to 0.6 % off, 0.004 % in the mean.
TEST(CloudLattice, GoesEvenlyBetweenRaysOfALevelCloud) {
  for (const double depth : {0.5, 16.0}) {
    const auto scene = [depth](const char* resolution) {
      Scene level = framed(under_level_cloud(depth, std::sin(radians(35.0))), resolution);
      level.render.parameters.find("cloud_lut")->second = TableSize{4, 20};
      return level;
    };
    const Difference found = halved(scene("half"), scene("full"));
    EXPECT_LT(found.most, 3e-3) << depth;
    EXPECT_LT(found.mean, 3e-4) << depth;
    EXPECT_LT(found.equal, 0.5) << depth;
  }
}

// Where rays differ all pixels are marched.
TEST(CloudLattice, IsThePictureOfAllRays) {
  const Difference found = halved(below_balls("half"), below_balls("full"));
  EXPECT_LT(found.mean, 1e-3);
  EXPECT_LT(found.most, 0.12);
  EXPECT_GT(found.equal, 0.3);
  EXPECT_LT(found.equal, 0.65);
}

// What stands behind clouds is each pixel's own: the edges of things in gaps are as sharp as without clouds.
TEST(CloudLattice, KeepsTheEdgesOfThings) {
  const auto scene = [](const char* resolution) {
    Scene made = below_balls(resolution);
    Sphere ball;
    ball.azimuth = radians(70.0);
    ball.elevation = radians(30.0);
    ball.distance = 0.5;
    ball.radius = 0.05;
    ball.albedo = {0.9, 0.9, 0.9};
    made.spheres = {ball};
    return made;
  };
  const RadianceImage half = render_now(scene("half")).radiance;
  const RadianceImage full = render_now(scene("full")).radiance;
  const RadianceImage without = render_now(below_balls("full")).radiance;
  std::size_t of_the_ball = 0;
  for (std::size_t i = 0; i < full.rgba.size(); i += 4) {
    // Far from the ball no more than its shadow is seen of it.
    if (std::abs(double{full.rgba[i]} / double{without.rgba[i]} - 1.0) > 0.2) {
      ++of_the_ball;
      EXPECT_NEAR(double{half.rgba[i]}, double{full.rgba[i]}, 1e-6 * double{full.rgba[i]});
    }
  }
  EXPECT_GT(of_the_ball, 50U);
  EXPECT_LT(between(half, full).mean, 1e-3);
}

// Difference of two pictures over their sum, of this of each pixel's light.
template <class Measure>
double off_in_sum(const RadianceImage& half, const RadianceImage& full, Measure measure) {
  double sum = 0.0;
  double off = 0.0;
  for (std::size_t i = 0; i < full.rgba.size(); i += 4) {
    sum += measure(double{full.rgba[i]});
    off += std::abs(measure(double{half.rgba[i]}) - measure(double{full.rgba[i]}));
  }
  std::printf("half against full: %.3f %% of all light off\n", 100.0 * off / sum);
  return off / sum;
}

// The sun's disc may outshine a cloud that hides it but for a trace.
TEST(CloudLattice, LeavesAsMuchOfTheDisc) {
  const auto picture = [](const char* resolution) {
    Scene made = below_balls(resolution);
    made.sun.disc.visible = true;
    made.camera.azimuth = made.sun.azimuth;
    made.camera.pitch = made.sun.elevation;
    made.camera.vertical_fov = radians(2.0);
    return render_now(made).radiance;
  };
  EXPECT_LT(off_in_sum(picture("half"), picture("full"), [](double light) { return light; }), 2e-3);
}

// At night a star may outshine the cloud before it, which sends nothing: how much of the star is left counts alone.
// Roots of light, so that stars weigh more alike.
TEST(CloudLattice, LeavesAsMuchOfStars) {
  const auto picture = [](const char* resolution) {
    Scene made = below_balls(resolution);
    made.sun.elevation = radians(-25.0);
    made.stars = Stars{6.5};
    made.camera.julian_date = 2451545.0;
    made.camera.vertical_fov = radians(100.0);
    return render_now(made).radiance;
  };
  EXPECT_LT(off_in_sum(picture("half"), picture("full"), [](double light) { return std::sqrt(light); }), 5e-4);
}

TEST(CloudLattice, TilesAreThePicture) {
  const Scene scene = below_balls("half");
  const Rendering whole = render_now(scene);
  std::vector<float> rgba;
  BandsRequest request{.tile = ImageSize{37, 23}, .picture = {}, .exposure_first = false, .sink = {}};
  request.sink = [&](const Band& band) {
    rgba.insert(rgba.end(), band.rows.radiance.rgba.begin(), band.rows.radiance.rgba.end());
  };
  render_bands([]() -> Executor& { return executor(); }, scene, request);
  EXPECT_EQ(rgba, whole.radiance.rgba);
}

}  // namespace
}  // namespace airlight::test
