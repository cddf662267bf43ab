// Image-based lighting: the map and the harmonics against integrals in closed form, the sun against the air alone.

#include "core/render/lighting.h"

#include <cmath>
#include <functional>
#include <random>

#include "tests/methods/render_fixture.h"
#include "tests/of_scene.h"

namespace airlight::test {
namespace {

using std::numbers::pi;

Vector3 direction_of(double elevation, double azimuth) {
  const double c = std::cos(elevation);
  return {std::sin(azimuth) * c, std::sin(elevation), -std::cos(azimuth) * c};
}

// An equirectangular sky of that radiance in every channel, the green one doubled.
RadianceImage sky_of(double azimuth, int width, int height, const std::function<double(const Vector3&)>& radiance) {
  RadianceImage image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double value =
          radiance(direction_of(pi * (0.5 - (y + 0.5) / height), azimuth + pi * (2.0 * (x + 0.5) / width - 1.0)));
      for (const double factor : {1.0, 2.0, 1.0}) {
        image.rgba.push_back(static_cast<float>(factor * value));
      }
      image.rgba.push_back(1.0F);
    }
  }
  return image;
}

std::vector<Vector3> normals() {
  std::vector<Vector3> some = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    some.push_back(direction_of(std::asin(unit(random)), pi * unit(random)));
  }
  return some;
}

double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Irradiance of a surface with this unit normal: the sum over degrees l of A_l L_lm Y_lm, where A_0 = pi, A_1 = 2 pi/3,
// A_2 = pi/4 belong to the clamped cosine. [RH01] eq. 9; within 1 % of the mean for most lights, and negative for a
// single small light.
Vector3 irradiance_from_sh(const ShRadiance& radiance, const Vector3& normal) {
  const std::array<double, 9> basis = sh_basis(normal);
  Vector3 sum{};
  for (std::size_t k = 0; k < 9; ++k) {
    const double cosine = k == 0 ? pi : (k < 4 ? 2.0 * pi / 3.0 : 0.25 * pi);
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += cosine * radiance[k][c] * basis[k];
    }
  }
  return sum;
}

TEST(Harmonics, AreOrthonormal) {
  constexpr int kRows = 64;
  std::array<std::array<double, 9>, 9> products{};
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < 2 * kRows; ++x) {
      const double elevation = pi * (0.5 - (y + 0.5) / kRows);
      const auto basis = sh_basis(direction_of(elevation, pi * (x + 0.5) / kRows));
      const double weight = std::cos(elevation) * pi / kRows * pi / kRows;
      for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t j = 0; j < 9; ++j) {
          products[i][j] += basis[i] * basis[j] * weight;
        }
      }
    }
  }
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < 9; ++j) {
      EXPECT_NEAR(products[i][j], i == j ? 1.0 : 0.0, 2e-3) << i << ", " << j;
    }
  }
  // [RH01] eq. 3, in this frame.
  EXPECT_NEAR(sh_basis({0, 1, 0})[1], 0.488603, 1e-6);
  EXPECT_NEAR(sh_basis({0, 0, 1})[6], 2.0 * 0.315392, 1e-6);
  EXPECT_NEAR(sh_basis({1, 0, 0})[8], 0.546274, 1e-6);
}

// Unit radiance gives pi, on every normal, by either way.
TEST(Irradiance, OfAUniformSkyIsPi) {
  const RadianceImage sky = sky_of(0.4, 48, 24, [](const Vector3&) { return 1.0; });
  const ShRadiance sh = project_to_sh(sky, 0.4);
  EXPECT_NEAR(sh[0][0], 2.0 * std::sqrt(pi), 1e-7);
  for (const Vector3& n : normals()) {
    EXPECT_NEAR(irradiance_from_sh(sh, n)[0], pi, 1e-6);
    EXPECT_NEAR(irradiance_from_sh(sh, n)[1], 2.0 * pi, 2e-6);
  }
  EXPECT_NEAR(level_irradiance(sky)[0], pi, 1e-3);
  const RadianceImage map = irradiance_map(sky, 0.4, 16, 8, 0.0);
  for (std::size_t i = 0; i < map.rgba.size(); i += 4) {
    EXPECT_NEAR(static_cast<double>(map.rgba[i]) / pi, 1.0, 2e-3);  // pixels that the horizon of the normal cuts
  }
}

// Radiance 1 + (d.u) / 2 + (d.v)^2 is of degree 2: E(n) = pi + (pi/3) n.u + pi/4 (1 + (n.v)^2), since the clamped
// cosine keeps pi of degree 0, 2 pi/3 of degree 1 and pi/4 of degree 2, and (d.v)^2 = 1/3 + degree 2.
TEST(Irradiance, OfAPolynomialSkyIsInClosedForm) {
  const Vector3 u = direction_of(0.7, 2.0);
  const Vector3 v = direction_of(-0.3, 0.5);
  const double azimuth = -1.2;  // the picture may look anywhere: the frame is the world's
  const RadianceImage sky =
      sky_of(azimuth, 96, 48, [&](const Vector3& d) { return 1.0 + 0.5 * dot(d, u) + dot(d, v) * dot(d, v); });
  const ShRadiance sh = project_to_sh(sky, azimuth);
  EXPECT_NEAR(level_irradiance(sky)[0], pi + pi / 3 * u[1] + 0.25 * pi * (1.0 + v[1] * v[1]), 3e-3);
  const auto truth = [&](const Vector3& n) {
    return pi + pi / 3.0 * dot(n, u) + pi / 3.0 + 0.25 * pi * (dot(n, v) * dot(n, v) - 1.0 / 3.0);
  };
  for (const Vector3& n : normals()) {
    EXPECT_NEAR(irradiance_from_sh(sh, n)[0] / truth(n), 1.0, 2e-3);
  }
  constexpr int kWidth = 24;
  constexpr int kHeight = 12;
  const RadianceImage map = irradiance_map(sky, azimuth, kWidth, kHeight, 0.9);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vector3 n = direction_of(pi * (0.5 - (y + 0.5) / kHeight), 0.9 + pi * (2.0 * (x + 0.5) / kWidth - 1.0));
      EXPECT_NEAR(channel_of(map, x, y, 0) / truth(n), 1.0, 2e-3) << x << ", " << y;
    }
  }
}

// The harmonics of a clamped cosine around s are pi, 2 pi/3 and pi/4 times the basis at s, by degree: in turned axes
// around s in those axes.
TEST(Harmonics, TurnWithTheirAxes) {
  const double degrees[] = {pi, 2.0 * pi / 3.0, 0.25 * pi};
  const auto lobe = [&](const Vector3& s) {
    const std::array<double, 9> basis = sh_basis(s);
    ShRadiance sh{};
    for (std::size_t k = 0; k < 9; ++k) {
      sh[k] = {degrees[k == 0 ? 0 : k < 4 ? 1 : 2] * basis[k], -basis[k], 0.0};
    }
    return sh;
  };
  for (const double azimuth : {0.0, 0.5 * pi, 0.7, -2.1}) {
    const Vector3 s = direction_of(0.4, 1.3);
    const ShRadiance found = turned(lobe(s), azimuth);
    const ShRadiance wanted = lobe(direction_of(0.4, 1.3 - azimuth));
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_NEAR(found[k][0], wanted[k][0], 1e-12) << k << " at " << azimuth;
      EXPECT_NEAR(found[k][1], wanted[k][1], 1e-12) << k;
    }
  }
}

// A sky over black ground: pi (1 + sin e)/2 on a normal of elevation e.
TEST(Irradiance, OfHalfASphere) {
  const RadianceImage sky = sky_of(0.0, 64, 32, [](const Vector3& d) { return d[1] > 0.0 ? 1.0 : 0.0; });
  constexpr int kHeight = 10;
  const RadianceImage map = irradiance_map(sky, 0.0, 3, kHeight, 0.0);
  for (int y = 0; y < kHeight; ++y) {
    const double elevation = pi * (0.5 - (y + 0.5) / kHeight);
    EXPECT_NEAR(channel_of(map, 1, y, 0), 0.5 * pi * (1.0 + std::sin(elevation)), 4e-3) << y;
  }
}

Scene scene_at(double elevation) {
  Scene scene = earth();
  scene.sun.elevation = elevation * kDegree;
  scene.sun.azimuth = 1.0;
  scene.sun.irradiance = {3.0, 2.0, 1.0};
  return with_method(scene, *find_method("march"), true);
}

// A disc so small that the air is the same over all of it.
TEST(Lighting, TheSunIsWhatTheAirLeavesOfIt) {
  Scene scene = scene_at(25.0);
  scene.sun.disc.angular_radius = 0.01 * kDegree;
  scene.sun.disc.visible = false;
  const SunLight sun = sun_light([]() -> Executor& { return executor(); }, scene);
  const ProbeResult probe = probe_now(scene, {{scene.sun.elevation, scene.sun.azimuth}}).front();
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(sun.irradiance[c] / (scene.sun.irradiance[c] * probe.transmittance[c]), 1.0, 1e-4);
  }
  EXPECT_NEAR(sun.visible_share, 1.0, 1e-12);
  EXPECT_NEAR(sun.direction[1], std::sin(25.0 * kDegree), 1e-12);
}

// In empty space only the planet hides the sun: half of a disc whose centre is on the horizon, all of one below.
TEST(Lighting, ThePlanetCutsTheSun) {
  Scene scene = vacuum();
  scene.camera.altitude = 0.0;
  scene = with_method(scene, *find_method("march"), true);
  const auto at = [&](double elevation) {
    scene.sun.elevation = elevation;
    return sun_light([]() -> Executor& { return executor(); }, scene);
  };
  const double radius = scene.sun.disc.angular_radius;
  EXPECT_NEAR(at(0.0).irradiance[1], 0.5 * scene.sun.irradiance[1], 0.01);
  EXPECT_NEAR(at(1.01 * radius).irradiance[1], scene.sun.irradiance[1], 1e-6);
  EXPECT_EQ(at(-1.01 * radius).irradiance[1], 0.0);
  // A cap beyond half the radius: 0.1955 of a uniform disc, less for a darkened limb.
  const double cap = at(-0.5 * radius).visible_share;
  EXPECT_GT(cap, 0.12);
  EXPECT_LT(cap, 0.1955);
}

// The disc's light by a dense grid of directions, as low as the disc is still round. Below that it is cut.
TEST(Lighting, TheDiscsLightIsTheSumOverIt) {
  for (const double elevation : {0.27, 0.54, 2.0, 30.0}) {
    const Scene scene = scene_at(elevation);
    const Sun& given = scene.sun;
    std::vector<Direction> directions;
    std::vector<double> weights;
    double total = 0.0;
    constexpr int kAcross = 60;
    for (int i = 0; i < kAcross * kAcross; ++i) {
      const double up = 2.0 * (i / kAcross + 0.5) / kAcross - 1.0;
      const double right = 2.0 * (i % kAcross + 0.5) / kAcross - 1.0;
      const double r2 = up * up + right * right;
      if (r2 < 1.0) {
        const double radius = given.disc.angular_radius;
        directions.push_back(
            {given.elevation + radius * up, given.azimuth + radius * right / std::cos(given.elevation)});
        weights.push_back(1.0 - given.disc.limb_darkening * (1.0 - std::sqrt(1.0 - r2)));
        total += weights.back();
      }
    }
    const std::vector<ProbeResult> probes = probe_now(scene, directions);
    Vector3 sum{};
    for (std::size_t i = 0; i < probes.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += given.irradiance[c] * weights[i] / total * probes[i].transmittance[c];
      }
    }
    const SunLight sun = sun_light([]() -> Executor& { return executor(); }, scene);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(sun.irradiance[c] / sum[c], 1.0, 2e-4) << elevation << ", " << c;
    }
  }
}

// Against a sky of seven times as many pixels, in the hardest case: an aureole on the horizon.
TEST(Lighting, TheSkyItIsTakenFromIsFineEnough) {
  for (const double elevation : {1.0, 60.0}) {
    Scene scene = scene_at(elevation);
    const Lighting lighting = lighting_of([]() -> Executor& { return executor(); }, scene, {});
    Scene fine = all_round(scene, scene.camera.altitude, 512, 256);
    fine.camera.azimuth = 0.0;
    fine.sun.disc.visible = false;
    const RadianceImage sky = render_now(fine).radiance;
    const ShRadiance sh = project_to_sh(sky, 0.0);
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_NEAR(lighting.sh[k][1], sh[k][1], 0.003 * sh[0][1]) << elevation << ", " << k;
    }
  }
}

// On a real sky map and harmonics agree, and the ground's own irradiance is the map's value for up.
TEST(Lighting, MapAndHarmonicsOfASkyAgree) {
  Scene scene = scene_at(30.0);
  scene.camera = {.azimuth = 2.0, .pitch = 0.3, .vertical_fov = 1.0};
  const Lighting lighting = lighting_of([]() -> Executor& { return executor(); }, scene, {});
  ASSERT_EQ(lighting.irradiance.width, kIrradianceWidth);
  double greatest_map = 0.0;
  double worst = 0.0;
  for (int y = 0; y < kIrradianceHeight; ++y) {
    for (int x = 0; x < kIrradianceWidth; ++x) {
      const Vector3 n = direction_of(pi * (0.5 - (y + 0.5) / kIrradianceHeight),
                                     2.0 + pi * (2.0 * (x + 0.5) / kIrradianceWidth - 1.0));
      const double map = channel_of(lighting.irradiance, x, y, 1);
      greatest_map = std::max(greatest_map, map);
      worst = std::max(worst, std::abs(map - irradiance_from_sh(lighting.sh, n)[1]));
    }
  }
  EXPECT_GT(greatest_map, 0.0);
  EXPECT_LT(worst, 0.05 * greatest_map);  // [RH01] sec. 3.2: harmonics above degree 2 are at most a few percent
  // The brightest normal leans toward the sun: its azimuth is 1.0 rad.
  int at_x = 0;
  for (int x = 0; x < kIrradianceWidth; ++x) {
    at_x = channel_of(lighting.irradiance, x, 12, 1) > channel_of(lighting.irradiance, at_x, 12, 1) ? x : at_x;
  }
  EXPECT_NEAR(2.0 + pi * (2.0 * (at_x + 0.5) / kIrradianceWidth - 1.0), 1.0, 0.1);
}

}  // namespace
}  // namespace airlight::test
