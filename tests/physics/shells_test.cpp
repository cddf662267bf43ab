// Air cut into shells: the edges, the steps between them, sunlight within a step, and the harmonics of high degree.

#include "core/air/shells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "tests/physics/host_tables.h"
#include "tests/physics/integral.h"
#include "tests/physics/scenes.h"

namespace airlight::test {
namespace {

using physics::Physics;
using physics::vec3;

// Clear air over fog that ends abruptly at 0.5 km, and a layer with bends at 3, 4 and 5 km.
Scene foggy(const char* shells) {
  Scene scene = vacuum();
  scene.media.push_back(medium("air", {0.006, 0.013, 0.033}, {}, exponential(8.0), PhaseFunction::rayleigh));
  scene.media.push_back(medium("fog", {0.3, 0.3, 0.3}, {0.01, 0.01, 0.01}, constant(0.5)));
  scene.media.push_back(medium("layer", {0.1, 0.1, 0.1}, {}, layers({{3.0, 0.0}, {4.0, 1.0}, {5.0, 0.0}})));
  scene.render.parameters["shells"] = std::string(shells);
  return scene;
}

TEST(Shells, AreUsedWhereTheAirAsksForThem) {
  EXPECT_GT(make_physics(foggy("auto")).scene.shell_rows, 0U);
  EXPECT_EQ(make_physics(foggy("never")).scene.shell_rows, 0U);
  Scene clear = foggy("auto");
  clear.media.resize(1);
  EXPECT_EQ(make_physics(clear).scene.shell_rows, 0U);
  clear.media.push_back(medium("ozone", {}, {0.1, 0.1, 0.1}, tent(25.0, 15.0)));  // absorbs only
  EXPECT_EQ(make_physics(clear).scene.shell_rows, 0U);
  clear.media[0].scattering = {0.06, 0.0, 0.0};
  EXPECT_EQ(make_physics(clear).scene.shell_rows, 0U) << "smooth air of a depth of 0.48";
  clear.media[0].scattering = {0.16, 0.0, 0.0};
  EXPECT_GT(make_physics(clear).scene.shell_rows, 0U) << "of 1.28";
  clear.media[0].scattering = {0.006, 0.013, 0.033};
  clear.media.push_back(medium("low fog", {6.0, 0.0, 0.0}, {}, exponential(0.1)));
  EXPECT_GT(make_physics(clear).scene.shell_rows, 0U) << "of 0.6 between two rows of the table";
  clear.render.parameters.erase("shells");
  EXPECT_EQ(make_physics(clear).scene.shell_rows, 0U) << "a method without the parameter";
}

TEST(Shells, HaveEdgesWhereADensityJumpsOrBends) {
  const Scene scene = foggy("auto");
  Physics p = make_physics(scene);
  const std::vector<double> rows = shell_altitudes(air_of(scene).column(), air_of(scene).options().moment_rows);
  EXPECT_EQ(rows.front(), 0.0);
  EXPECT_EQ(rows.back(), scene.planet.atmosphere_height);
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(), std::less_equal<>())) << "strictly rising";
  EXPECT_LE(rows.size(), static_cast<std::size_t>(physics::kMaxShellRows));
  for (const double h : {0.5, 3.0, 4.0, 5.0}) {
    EXPECT_TRUE(std::find(rows.begin(), rows.end(), h) != rows.end()) << h;
  }
  Scene fine = scene;
  fine.render.parameters["moments_lut"] = TableSize{48, 1024};
  std::vector<DensityLayer> many;
  for (int i = 0; i < 250; ++i) {
    many.push_back({0.3 * i, i % 2 == 0 ? 0.0 : 0.01});
  }
  fine.media[2].density = layers(many);
  EXPECT_LE(shell_altitudes(air_of(fine).column(), air_of(fine).options().moment_rows).size(),
            static_cast<std::size_t>(physics::kMaxShellRows));
}

// Thin layers below thick air: each is a shell by itself, and the rest takes nearly all the shells requested.
TEST(Shells, AreNeverMoreThanThereIsRoomFor) {
  std::size_t most = 0;
  for (int count = 1; count <= 30; ++count) {
    Scene scene = vacuum();
    std::vector<DensityLayer> list;
    for (int i = 1; i <= count; ++i) {
      list.push_back({0.001 * i, 1.0});
    }
    scene.media.push_back(medium("thick", {3.0, 3.0, 3.0}, {}, layers(list)));
    scene.render.parameters["shells"] = std::string("auto");
    const Physics p = make_physics(scene);
    ASSERT_GT(p.scene.shell_rows, 0U);
    ASSERT_LE(p.scene.shell_rows, physics::kMaxShellRows) << count;
    most = std::max<std::size_t>(most, p.scene.shell_rows);
  }
  EXPECT_EQ(most, physics::kMaxShellRows) << "no scene asked for more than there is room for";
}

// A shell whose edges are the same number in 32 bits would divide by its height of 0.
TEST(Shells, StandApartIn32Bits) {
  Scene scene = vacuum();
  scene.planet.atmosphere_height = 1e6;
  scene.media.push_back(medium("film", {1e3, 1e3, 1e3}, {}, layers({{9e5, 0.0}, {9e5 + 1.5, 1.0}, {9e5 + 3.0, 0.0}})));
  scene.media.push_back(medium("skin", {1e3, 1e3, 1e3}, {}, exponential(1e-6)));
  scene.render.parameters["shells"] = std::string("auto");
  Physics p = make_physics(scene);
  ASSERT_GT(p.scene.shell_rows, 4U);
  for (unsigned int k = 1; k < p.scene.shell_rows; ++k) {
    const auto below = static_cast<float>(p.shell_altitude(k - 1));
    EXPECT_LT(below, static_cast<float>(p.shell_altitude(k))) << k;
  }
}

TEST(Shells, StepsCoverTheRayAndCrossNoEdge) {
  Physics p = make_physics(foggy("auto"));
  const auto& planet = p.scene.planet;
  for (const double h : {0.0, 0.2, 0.5, 4.5, 60.0, 100.0}) {
    for (const double mu : {-1.0, -0.3, -0.1, -0.02, 0.0, 0.01, 0.4, 1.0}) {
      for (const double mu_sun : {0.3, -0.05}) {
        const auto ray = p.ray_in_atmosphere(planet, h, mu, mu_sun, mu * mu_sun);
        const auto shadow = p.shadow_crossings(planet, ray);
        auto walk = p.shell_walk(planet, ray);
        double end = 0.0;
        for (unsigned int i = 0; i < p.most_steps(2); ++i) {
          walk = p.next_step(walk, planet, ray, shadow, 2);
          if (walk.done) {
            break;
          }
          EXPECT_EQ(walk.from, end);
          EXPECT_GE(walk.to, walk.from);
          end = walk.to;
          const auto middle = p.point_on_ray(planet, ray, 0.5 * (walk.from + walk.to));
          EXPECT_GE(middle.h, p.shell_altitude(walk.shell) - 1e-9);
          EXPECT_LE(middle.h, p.shell_altitude(walk.shell + 1) + 1e-9);
          for (const double edge : {shadow.first, shadow.second}) {
            EXPECT_FALSE(walk.from < edge && edge < walk.to);
          }
        }
        EXPECT_TRUE(walk.done || ray.length_ <= 0.0) << h << " " << mu;
        EXPECT_NEAR(end, std::max(ray.length_, 0.0), 1e-6 * (1.0 + ray.length_)) << h << " " << mu;
      }
    }
  }
}

TEST(Shells, MeanExtinctionIsTheIntegral) {
  Physics p = make_physics(foggy("auto"));
  const auto& planet = p.scene.planet;
  for (const double h : {0.0, 0.3, 2.0, 30.0}) {
    for (const double x : {0.02, 0.2, 0.6, 1.0}) {
      const double mu = p.sun_table_mu(planet, h, x);
      EXPECT_NEAR(p.sun_table_coordinate(planet, h, mu), x, 1e-6);
      const double length = p.distance_to_top(planet, h, mu);
      physics::Physics::Ray ray = p.ray_in_atmosphere(planet, h, mu, mu, 1.0);
      const double depth =
          integral([&](double t) { return p.extinction_at(p.point_on_ray(planet, ray, t).h).y; }, 0.0, length, 4000);
      EXPECT_NEAR(p.mean_extinction_to_top(planet, h, mu).y * length / depth, 1.0, 3e-3) << h << " " << mu;
    }
  }
}

TEST(Shells, SunlightWithinAStepIsTheIntegral) {
  for (const double near : {0.0, 0.3, 20.0}) {
    for (const double far : {0.0, 0.31, 8.0}) {
      for (const double through : {0.0, 0.01, 3.0}) {
        const double expected =
            integral([&](double x) { return std::exp(-near - x * (far - near + through)); }, 0.0, 1.0, 20);
        EXPECT_NEAR(Physics{}.mean_sunlight(near, far, through) / expected, 1.0, 1e-8)
            << near << " " << far << " " << through;
      }
    }
  }
}

TEST(Shells, SourceStandsWhereTheStepShinesFrom) {
  Physics p;
  for (const double x : {0.0, 1e-3, 0.5, 0.9999, 1.0001, 4.0, 50.0}) {
    const double weight = integral([&](double t) { return std::exp(-x * t); }, 0.0, 1.0, 30);
    const double place = integral([&](double t) { return t * std::exp(-x * t); }, 0.0, 1.0, 30) / weight;
    EXPECT_NEAR(p.source_place(x), place, 2e-6) << x;
  }
}

TEST(Harmonics, AreOrthonormalUpToDegree8) {
  Physics p;
  constexpr int kAzimuths = 20;  // exact for cosines of up to 16 azimuths
  for (int a = 0; a < static_cast<int>(physics::kMaxHarmonics); ++a) {
    for (int b = a; b < static_cast<int>(physics::kMaxHarmonics); ++b) {
      const double product = integral(
          [&](double mu) {
            double sum = 0.0;
            for (int j = 0; j < kAzimuths; ++j) {
              const auto y = p.harmonics(mu, std::cos(2.0 * std::numbers::pi * (j + 0.5) / kAzimuths));
              sum += y.of[a] * y.of[b] * 2.0 * std::numbers::pi / kAzimuths;
            }
            return sum;
          },
          -1.0, 1.0, 12);
      EXPECT_NEAR(product, a == b ? 1.0 : 0.0, 1e-9) << a << " " << b;
    }
  }
}

}  // namespace
}  // namespace airlight::test
