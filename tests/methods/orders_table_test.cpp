// The picture of `orders` from its table of factors against the same light gathered pixel by pixel.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

struct Gaps {
  double mean = 0.0;
  double most = 0.0;
};

// |a - b| / max(b, a thousandth of b's mean) over rows [first, last), colour channels pooled.
Gaps gaps(const RadianceImage& a, const RadianceImage& b, int first, int last) {
  double mean = 0.0;
  const int values = 3 * b.width * (last - first);
  for (const bool measuring : {false, true}) {
    Gaps found;
    double sum = 0.0;
    for (int i = 4 * b.width * first; i < 4 * b.width * last; ++i) {
      if (i % 4 == 3) {
        continue;
      }
      const double x = a.rgba[static_cast<std::size_t>(i)];
      const double y = b.rgba[static_cast<std::size_t>(i)];
      const double gap = std::abs(x - y) / std::max(y, 1e-3 * mean);
      sum += y / values;
      found.mean += measuring ? gap / values : 0.0;
      found.most = std::max(found.most, gap);
    }
    if (measuring) {
      return found;
    }
    mean = sum;
  }
  return {};
}

RadianceImage by_table(Scene scene, const std::string& tabulate, const std::string& fold) {
  scene = with_method(std::move(scene), *find_method("orders"));
  scene.render.parameters.insert_or_assign("tabulate", tabulate);
  scene.render.parameters.insert_or_assign("fold", fold);
  return render_now(scene).radiance;
}

Scene all_of_it(double altitude, double albedo, double sun) {
  Scene scene = all_round(earth(), altitude, 72, 36);
  scene.planet.ground_albedo = {albedo, albedo, albedo};
  scene.sun.elevation = sun * kDegree;
  scene.sun.disc.visible = false;
  return scene;
}

// Seen from low over a bright ground, straight down a row of a table of distances alone would be tens of degrees high.
TEST(OrdersTable, IsThePictureByPixel) {
  for (const double altitude : {0.01, 2.0, 60.0}) {
    for (const double albedo : {0.0, 0.8}) {
      const Scene scene = all_of_it(altitude, albedo, 40.0);
      const RadianceImage pixels = by_table(scene, "never", "smooth");
      const RadianceImage table = by_table(scene, "always", "smooth");
      const Gaps sky = gaps(table, pixels, 0, 18);
      const Gaps ground = gaps(table, pixels, 18, 36);  // from 60 km the limb is in it
      EXPECT_LT(sky.mean, 0.002) << altitude << " km, albedo " << albedo;
      EXPECT_LT(sky.most, 0.01) << altitude << " km, albedo " << albedo;
      EXPECT_LT(ground.mean, albedo > 0.0 ? 0.0005 : 0.008) << altitude << " km, albedo " << albedo;
      EXPECT_LT(ground.most, 0.05) << altitude << " km, albedo " << albedo;
    }
  }
}

// From space: the disc with its terminator, the limb, and black beside it.
TEST(OrdersTable, IsThePictureByPixelFromSpace) {
  for (const double altitude : {101.0, 500.0, 2.0 * 6360.0, 1e5}) {
    for (const double sun : {50.0, 0.0, -60.0}) {
      Scene scene = all_of_it(altitude, 0.3, sun);
      scene.camera.projection = Projection::perspective;
      scene.camera.pitch = -90.0 * kDegree;
      scene.camera.vertical_fov = std::min(2.2 * std::asin(6460.0 / (6360.0 + altitude)), 2.4);
      scene.image = {48, 48};
      const RadianceImage pixels = by_table(scene, "never", "smooth");
      const Gaps all = gaps(by_table(scene, "always", "smooth"), pixels, 0, 48);
      EXPECT_LT(all.mean, 0.002) << altitude << " km, sun " << sun;
      EXPECT_LT(all.most, 0.15) << altitude << " km, sun " << sun;
    }
  }
}

// The table is made where the picture looks: no pixel reads a texel that is not. Each case has a sun of its own, so
// that what an earlier table left in memory is wrong.
TEST(OrdersTable, MadeForAPictureIsTheWholeOneThere) {
  double sun = 25.0;
  for (const Projection projection : {Projection::perspective, Projection::fisheye}) {
    for (const double pitch : {-60.0, 0.0, 35.0, 90.0}) {
      for (const double azimuth : {0.0, 100.0, 180.0}) {
        Scene scene = all_of_it(0.002, 0.3, sun += 1.0);
        scene.image = {72, 48};
        scene.camera.projection = projection;
        scene.camera.vertical_fov = 50.0 * kDegree;
        scene.camera.pitch = pitch * kDegree;
        scene.camera.azimuth = azimuth * kDegree;
        scene.camera.roll = 30.0 * kDegree;
        const RadianceImage part = by_table(scene, "auto", "smooth");
        EXPECT_EQ(part.rgba, by_table(scene, "always", "smooth").rgba) << pitch << " " << azimuth;
      }
    }
  }
}

// Includes sizes that are powers of two, whose constants coincide with others of the shaders.
TEST(OrdersTable, MayHaveAnySize) {
  for (const TableSize size : {TableSize{8, 16}, TableSize{16, 32}, TableSize{32, 64}, TableSize{17, 31}}) {
    for (const double altitude : {0.01, 500.0}) {
      Scene scene = with_method(all_of_it(altitude, 0.3, 50.0), *find_method("orders"));
      scene.render.parameters.insert_or_assign("sky_lut", size);
      scene.render.parameters.insert_or_assign("tabulate", std::string("always"));
      const RadianceImage table = render_now(scene).radiance;
      scene.render.parameters.insert_or_assign("tabulate", std::string("never"));
      EXPECT_LT(gaps(table, render_now(scene).radiance, 0, 36).mean, 0.05) << size[0] << " x " << size[1];
    }
  }
}

// On a GPU four threads share a ray's steps. The sums come in another order, but the table is the same.
TEST(OrdersTable, ByTeamsIsTheSame) {
  Scene scene = with_method(all_of_it(2.0, 0.3, 1.0), *find_method("orders"));
  scene.render.parameters.insert_or_assign("tabulate", std::string("always"));
  Executor teams({.teams = true});
  const RadianceImage alone = render_now(scene).radiance;
  const RadianceImage together = render([&]() -> Executor& { return teams; }, scene, {}).radiance;
  EXPECT_LT(gaps(together, alone, 0, 36).most, 1e-4);
}

// Folding all media blurs only the aureole: without a forward peak it changes nothing.
TEST(OrdersTable, FoldingBlursTheAureoleAlone) {
  Scene scene = all_of_it(0.01, 0.3, 20.0);
  const RadianceImage apart = by_table(scene, "always", "smooth");
  const RadianceImage folded = by_table(scene, "always", "all");
  EXPECT_LT(gaps(folded, apart, 0, 36).mean, 0.01);
  EXPECT_GT(gaps(folded, apart, 0, 18).most, 1e-3);
  for (Medium& medium : scene.media) {
    medium.phase_g = medium.phase_g > 0.0 ? 0.99 : medium.phase_g;
  }
  EXPECT_EQ(by_table(scene, "always", "smooth").rgba, by_table(scene, "always", "all").rgba) << "too sharp to fold";
  for (Medium& medium : scene.media) {
    medium.phase = medium.phase == PhaseFunction::rayleigh ? medium.phase : PhaseFunction::isotropic;
  }
  EXPECT_EQ(by_table(scene, "always", "smooth").rgba, by_table(scene, "always", "all").rgba);
}

// At an optical depth of 178 a thick shell stands between much thinner ones. Without a limit on the bend between its
// rows, orders grew from the twentieth on, to 1e30 of the arriving light.
TEST(OrdersByShells, NoOrderOutgrowsTheOneBefore) {
  Scene scene = all_round(earth(), 99.9, 16, 8);
  scene.media.resize(1);
  scene.media[0].phase = PhaseFunction::rayleigh;
  scene.media[0].density.profile = DensityProfile::exponential;
  scene.media[0].density.scale_height = 8.0;
  scene.media[0].scattering = {22.23, 22.23, 22.23};
  scene.media[0].absorption = {};
  scene.planet.ground_albedo = {1.0, 1.0, 1.0};
  scene.sun.elevation = -3.0 * kDegree;
  scene.sun.disc.visible = false;
  scene = with_method(std::move(scene), *find_method("orders"));
  scene.render.parameters.insert_or_assign("orders", 24);
  scene.render.parameters.insert_or_assign("moments_lut", TableSize{24, 12});
  for (const float value : render_now(scene).radiance.rgba) {
    ASSERT_TRUE(std::isfinite(value));
    ASSERT_LE(value, 1.0F);
  }
}

}  // namespace
}  // namespace airlight::test
