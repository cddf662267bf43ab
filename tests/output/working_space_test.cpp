// Colour spaces against matrices from their primaries, with the Bradford adaptation where the whites differ.
#include "core/output/working_space.h"

#include <gtest/gtest.h>

#include <cmath>

namespace airlight {
namespace {

using Vector = std::array<double, 3>;

Vector times(const ColorMatrix& m, const Vector& v) {
  Vector out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  }
  return out;
}

ColorMatrix times(const ColorMatrix& a, const ColorMatrix& b) {
  ColorMatrix out{};
  for (std::size_t column = 0; column < 3; ++column) {
    const Vector v = times(a, Vector{b[0][column], b[1][column], b[2][column]});
    for (std::size_t row = 0; row < 3; ++row) {
      out[row][column] = v[row];
    }
  }
  return out;
}

// Cramer's rule.
ColorMatrix inverse(const ColorMatrix& m) {
  ColorMatrix out{};
  double determinant = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto at = [&](std::size_t r, std::size_t c) { return m[(j + r) % 3][(i + c) % 3]; };
      out[i][j] = at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
    }
    determinant += m[0][i] * out[i][0];
  }
  for (Vector& row : out) {
    for (double& value : row) {
      value /= determinant;
    }
  }
  return out;
}

Vector xyz(double x, double y) {
  return {x / y, 1.0, (1.0 - x - y) / y};
}

// SMPTE RP 177: the columns are the primaries, scaled so that RGB (1, 1, 1) is the white.
ColorMatrix to_xyz(const Chromaticities& c) {
  ColorMatrix m{};
  for (std::size_t primary = 0; primary < 3; ++primary) {
    // From x, y and z themselves, since a primary may have y = 0.
    const double x = static_cast<double>(c[2 * primary]);
    const double y = static_cast<double>(c[2 * primary + 1]);
    m[0][primary] = x;
    m[1][primary] = y;
    m[2][primary] = 1.0 - x - y;
  }
  const Vector scale = times(inverse(m), xyz(static_cast<double>(c[6]), static_cast<double>(c[7])));
  for (Vector& row : m) {
    for (std::size_t primary = 0; primary < 3; ++primary) {
      row[primary] *= scale[primary];
    }
  }
  return m;
}

// Lam 1985, as in ICC.1 annex E.
ColorMatrix bradford(const Vector& from, const Vector& to) {
  const ColorMatrix cones = {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
  const Vector a = times(cones, from);
  const Vector b = times(cones, to);
  const ColorMatrix scale = {{{b[0] / a[0], 0, 0}, {0, b[1] / a[1], 0}, {0, 0, b[2] / a[2]}}};
  return times(inverse(cones), times(scale, cones));
}

ColorMatrix expected(WorkingSpace space) {
  const Chromaticities ours = chromaticities_of(WorkingSpace::linear_rec709);
  const Chromaticities theirs = chromaticities_of(space);
  const auto white = [](const Chromaticities& c) { return xyz(static_cast<double>(c[6]), static_cast<double>(c[7])); };
  return times(inverse(to_xyz(theirs)), times(bradford(white(ours), white(theirs)), to_xyz(ours)));
}

TEST(WorkingSpace, MatricesAreThoseOfThePrimariesByBradford) {
  for (const std::string& name : working_space_names()) {
    const WorkingSpace space = *working_space(name);
    const ColorMatrix found = from_rec709(space);
    const ColorMatrix wanted = expected(space);
    for (std::size_t i = 0; i < 3; ++i) {
      double white = 0.0;
      for (std::size_t j = 0; j < 3; ++j) {
        // BT.2087 prints four digits.
        EXPECT_NEAR(found[i][j], wanted[i][j], 1e-4) << name << ", " << i << ", " << j;
        EXPECT_GE(found[i][j], 0.0) << name;
        white += found[i][j];
      }
      EXPECT_NEAR(white, 1.0, 1e-4) << name;
    }
  }
}

// The Academy's published values for BT.709 to ACEScg with Bradford, TB-2014-004 and its transforms.
TEST(WorkingSpace, AcescgIsAsPublished) {
  const ColorMatrix found = from_rec709(WorkingSpace::acescg);
  EXPECT_NEAR(found[0][0], 0.6131, 1e-4);
  EXPECT_NEAR(found[0][1], 0.3395, 1e-4);
  EXPECT_NEAR(found[1][1], 0.9164, 1e-4);
  EXPECT_NEAR(found[2][2], 0.8698, 1e-4);
}

TEST(WorkingSpace, ThereAndBackAndAlphaUnchanged) {
  const RadianceImage image{2, 1, {0.25F, 4.0F, 1.5F, 0.5F, 100.0F, 0.0F, 1e-3F, 0.0F}};
  for (const std::string& name : working_space_names()) {
    const WorkingSpace space = *working_space(name);
    const RadianceImage there = converted(image, WorkingSpace::linear_rec709, space);
    EXPECT_EQ(there.rgba[3], 0.5F);
    const RadianceImage back = converted(there, space, WorkingSpace::linear_rec709);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(back.rgba[i], image.rgba[i], 5e-5F * (1.0F + image.rgba[i])) << name << ", " << i;
    }
  }
  EXPECT_FALSE(working_space("rec709").has_value());
}

}  // namespace
}  // namespace airlight
