// Prefiltered cube maps against the mean that they stand for, summed over the sphere in double.
#include "core/output/prefilter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace airlight {
namespace {

using Sky = double (*)(const CubeDirection&);

double along(const CubeDirection& a, const CubeDirection& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

CubeDirection unit(const CubeDirection& d) {
  const double length = std::sqrt(along(d, d));
  return {d[0] / length, d[1] / length, d[2] / length};
}

double constant(const CubeDirection&) {
  return 0.75;
}
// The horizon's gradient, and a broad glow around a sun near an edge of two faces.
double day(const CubeDirection& d) {
  const double toward_sun = along(d, unit({0.8, 0.5, -0.75}));
  return 1.0 + 0.6 * d[1] + 4.0 * std::exp(12.0 * (toward_sun - 1.0));
}
double hemisphere(const CubeDirection& d) {
  return d[1] > 0.0 ? 1.0 : 0.1;
}

CubeFaces faces_of(Sky sky, std::size_t side) {
  CubeFaces faces;
  for (std::size_t face = 0; face < kCubeFaces; ++face) {
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto centre = [&](std::size_t k) {
        return 2.0 * (static_cast<double>(k) + 0.5) / static_cast<double>(side) - 1.0;
      };
      const auto value = static_cast<float>(sky(unit(cube_direction({face, centre(i % side), centre(i / side)}))));
      faces[face].insert(faces[face].end(), {value, 2.0F * value, 0.5F * value, 1.0F});
    }
  }
  return faces;
}

// The header's mean toward n: midpoints in the angle from n, finer near n, and around it.
double mean_toward(Sky sky, const CubeDirection& n, double alpha) {
  const CubeDirection other = std::abs(n[1]) < 0.9 ? CubeDirection{0, 1, 0} : CubeDirection{1, 0, 0};
  const CubeDirection a =
      unit({n[1] * other[2] - n[2] * other[1], n[2] * other[0] - n[0] * other[2], n[0] * other[1] - n[1] * other[0]});
  const CubeDirection b{n[1] * a[2] - n[2] * a[1], n[2] * a[0] - n[0] * a[2], n[0] * a[1] - n[1] * a[0]};
  constexpr int kRings = 400;
  constexpr int kAround = 48;
  double light = 0.0;
  double weights = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double t = (i + 0.5) / kRings;
    const double angle = 0.5 * M_PI * t * t * t;
    const double ring = 0.5 * M_PI * 3.0 * t * t / kRings * std::sin(angle);
    const double nh = std::cos(0.5 * angle);
    const double base = nh * nh * (alpha * alpha - 1.0) + 1.0;
    const double weight = ring * std::cos(angle) * alpha * alpha / (M_PI * base * base);
    for (int k = 0; k < kAround; ++k) {
      const double around = 2.0 * M_PI * (k + 0.5) / kAround;
      CubeDirection l{};
      for (std::size_t c = 0; c < 3; ++c) {
        l[c] = std::cos(angle) * n[c] + std::sin(angle) * (std::cos(around) * a[c] + std::sin(around) * b[c]);
      }
      light += weight * sky(l);
      weights += weight;
    }
  }
  return light / weights;
}

TEST(Prefilter, CubePointsAreTheirDirections) {
  for (std::size_t face = 0; face < kCubeFaces; ++face) {
    const CubePoint at = cube_point(cube_direction({face, 0.3, -0.7}));
    EXPECT_EQ(at.face, face);
    EXPECT_NEAR(at.u, 0.3, 1e-15);
    EXPECT_NEAR(at.v, -0.7, 1e-15);
  }
}

TEST(Prefilter, RoughnessGrowsToOne) {
  EXPECT_EQ(mip_alpha(0, 6), 0.0);
  EXPECT_DOUBLE_EQ(mip_alpha(3, 6), 0.36);
  EXPECT_EQ(mip_alpha(5, 6), 1.0);
}

TEST(Prefilter, AnEvenSkyStaysEven) {
  for (const std::size_t side : {std::size_t{16}, std::size_t{5}}) {
    const CubeChain chain = prefiltered(faces_of(constant, side), side);
    for (const CubeFaces& faces : chain) {
      for (const std::vector<float>& face : faces) {
        for (std::size_t i = 0; i < face.size(); i += 4) {
          EXPECT_NEAR(face[i], 0.75F, 1e-5F);
          EXPECT_NEAR(face[i + 1], 1.5F, 2e-5F);
          EXPECT_EQ(face[i + 3], 1.0F);
        }
      }
    }
    EXPECT_EQ(chain.back().front().size(), 4U);
  }
}

TEST(Prefilter, TheFirstMipIsTheSkyItself) {
  const CubeFaces sky = faces_of(day, 8);
  EXPECT_EQ(prefiltered(sky, 8).front(), sky);
}

// A sky that the map resolves, at its texels of roughness 0.4, 0.6 and 0.8.
TEST(Prefilter, AMipIsTheMeanOverGgxsLobe) {
  constexpr std::size_t kSide = 64;
  for (const Sky sky : {Sky{day}, Sky{hemisphere}}) {
    const CubeChain chain = prefiltered(faces_of(sky, kSide), kSide);
    ASSERT_EQ(chain.size(), 7U);
    double worst = 0.0;
    for (const std::size_t level : {2U, 3U, 4U, 6U}) {
      const std::size_t side = kSide >> level;
      for (std::size_t face = 0; face < kCubeFaces; ++face) {
        const std::size_t x = side / 3;
        const std::size_t y = side / 2;
        const auto centre = [&](std::size_t k) {
          return 2.0 * (static_cast<double>(k) + 0.5) / static_cast<double>(side) - 1.0;
        };
        const CubeDirection n = unit(cube_direction({face, centre(x), centre(y)}));
        const double wanted = mean_toward(sky, n, mip_alpha(level, chain.size()));
        const auto found = static_cast<double>(chain[level][face][4 * (y * side + x)]);
        EXPECT_NEAR(found / wanted, 1.0, 0.01) << "mip " << level << ", face " << face;
        worst = std::max(worst, std::abs(found / wanted - 1.0));
      }
    }
    RecordProperty("worst", std::to_string(worst));
  }
}

}  // namespace
}  // namespace airlight
