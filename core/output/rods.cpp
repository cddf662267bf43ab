#include "core/output/rods.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/srgb.h"

namespace airlight {
namespace {

using Triple = std::array<double, 3>;

// Cones of Hunt, Pointer and Estevez, 1 each for D65, from linear Rec.709.
constexpr std::array<Triple, 3> kToCones{
    {{0.31399, 0.63951, 0.04650}, {0.15537, 0.75789, 0.08670}, {0.01775, 0.10944, 0.87257}}};

Triple times(const std::array<Triple, 3>& rows, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = rows[i][0] * v[0] + rows[i][1] * v[1] + rows[i][2] * v[2];
  }
  return out;
}

// By Cramer's rule.
std::array<Triple, 3> inverse(const std::array<Triple, 3>& m) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3;
    const std::size_t b = (i + 2) % 3;
    const std::size_t c = (j + 1) % 3;
    const std::size_t d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  std::array<Triple, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      out[j][i] = minor(i, j) / determinant;
    }
  }
  return out;
}

// Share of the rods, of linear Rec.709 in cd/m2 added to it.
Triple with_rods(const Triple& colour, double share) {
  constexpr double kPupil = 38.5;                    // mm2, of an eye in the dark, 7 mm wide: cd/m2 to trolands
  constexpr Triple kMost{0.63721, 0.39242, 1.6064};  // of the cones' sensitivities
  constexpr Triple kRods{0.2, 0.2, 0.3};             // their strength beside each kind of cone
  constexpr double kScale = 45.0;
  constexpr double kSaturation = 10.0;
  constexpr double kSurround = 0.6;
  constexpr double kWhite = 0.139;
  constexpr double kLong = 0.6189;  // share of the long cones
  static const std::array<Triple, 3> from_cones = inverse(kToCones);
  Triple cones = times(kToCones, colour);
  const double rods = kPupil * std::max(rods_luminance(colour[0], colour[1], colour[2]), 0.0);
  Triple gain{};
  for (std::size_t i = 0; i < 3; ++i) {
    cones[i] *= kPupil;
    gain[i] = kRods[i] / kMost[i] / std::sqrt(1.0 + 0.33 / kMost[i] * std::max(cones[i] + kRods[i] * rods, 0.0));
  }
  const double mean = kLong * gain[0] + (1.0 - kLong) * gain[1];
  const double factor = share * rods * kScale / kSaturation;
  const double red_green = factor * ((1.0 + kSurround * kWhite) * gain[1] - (kSurround + kWhite) * gain[0]);
  const double blue_yellow = factor * (kSurround * mean + gain[2]);
  const double light = factor * kSaturation * mean;
  cones[0] += 0.5 * (light - red_green);
  cones[1] += 0.5 * (light + red_green);
  cones[2] += blue_yellow + light;
  Triple seen = times(from_cones, cones);
  std::ranges::for_each(seen, [](double& channel) { channel /= kPupil; });
  return seen;
}

double luminance_of(const Triple& colour) {
  return bt709_luminance(colour[0], colour[1], colour[2]);
}

}  // namespace

double rods_luminance(double red, double green, double blue) {
  return -0.0162 * red + 0.6404 * green + 0.3758 * blue;
}

void see_by_rods(RadianceImage& rows, double one) {
  constexpr double kRodsAlone = 0.005;  // cd/m2
  constexpr double kConesAlone = 3.0;
  const double decades = std::log10(kConesAlone / kRodsAlone);
  for (std::size_t i = 0; i + 3 < rows.rgba.size(); i += 4) {
    const Triple colour{one * static_cast<double>(rows.rgba[i]), one * static_cast<double>(rows.rgba[i + 1]),
                        one * static_cast<double>(rows.rgba[i + 2])};
    const double luminance = luminance_of(colour);
    if (!(luminance > 0.0 && luminance < kConesAlone)) {
      continue;
    }
    const double share = std::min(std::log10(kConesAlone / luminance) / decades, 1.0);
    const double grey = luminance_of(with_rods({luminance, luminance, luminance}, share));
    const Triple seen = with_rods(colour, share);
    for (std::size_t c = 0; c < 3; ++c) {
      rows.rgba[i + c] = static_cast<float>(std::max(seen[c], 0.0) * (luminance / grey / one));
    }
  }
}

}  // namespace airlight
