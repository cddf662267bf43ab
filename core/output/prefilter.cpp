#include "core/output/prefilter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/output/parallel.h"

namespace airlight {
namespace {

using std::numbers::pi;

// Directions of light around the normal, drawn as GGX's facets are distributed: equal steps of the distribution and the
// golden angle around it. Each looks up the finest mip whose texels are not finer than the share of the sphere it
// stands for [Krivanek and Colbert 2008, Real-time shading with filtered importance sampling].
constexpr int kSamples = 512;

struct LobeSample {
  CubeDirection direction{};  // the normal is +z
  float weight = 0.0F;
  std::size_t mip = 0;
};

std::vector<LobeSample> lobe_of(double alpha, std::size_t side, std::size_t mips) {
  constexpr double kGoldenAngle = pi * (3.0 - 2.23606797749978969641);
  const double texel = 4.0 * pi / (6.0 * static_cast<double>(side * side));
  const double a2 = alpha * alpha;
  std::vector<LobeSample> lobe;
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double u = (i + 0.5) / kSamples;
    const double cos2 = (1.0 - u) / (1.0 + (a2 - 1.0) * u);  // of the facet's angle
    const double cosine = 2.0 * cos2 - 1.0;
    if (cosine <= 0.0) {
      break;  // this and all later ones lie below the surface
    }
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const double around = kGoldenAngle * i;
    const double base = cos2 * (a2 - 1.0) + 1.0;
    const double density = a2 / (4.0 * pi * base * base);  // of light's directions, 1/sr
    const double finer = 0.5 * std::log2(1.0 / (kSamples * density * texel));
    const double mip = std::clamp(std::floor(finer), 0.0, static_cast<double>(mips - 1));
    lobe.push_back({{sine * std::cos(around), sine * std::sin(around), cosine},
                    static_cast<float>(cosine),
                    static_cast<std::size_t>(mip)});
    sum += cosine;
  }
  for (LobeSample& sample : lobe) {
    sample.weight /= static_cast<float>(sum);
  }
  return lobe;
}

// A texel of a face, or of the next face where the place lies beyond this one's edge.
const float* texel_at(const CubeFaces& faces, std::size_t side, std::size_t face, std::int64_t x, std::int64_t y) {
  const auto last = static_cast<std::int64_t>(side) - 1;
  auto column = static_cast<std::size_t>(x);
  auto row = static_cast<std::size_t>(y);
  if (x < 0 || y < 0 || x > last || y > last) {
    const auto centre = [&](std::int64_t i) {
      return 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(side) - 1.0;
    };
    const CubePoint there = cube_point(cube_direction({face, centre(x), centre(y)}));
    face = there.face;
    column = cube_index(there.u, side);
    row = cube_index(there.v, side);
  }
  return &faces[face][4 * (row * side + column)];
}

// Adds the light from a direction, bilinear between texels.
void add_light(const CubeFaces& faces, std::size_t side, const CubeDirection& direction, float weight,
               std::array<float, 3>& sum) {
  const CubePoint at = cube_point(direction);
  const double x = 0.5 * (at.u + 1.0) * static_cast<double>(side) - 0.5;
  const double y = 0.5 * (at.v + 1.0) * static_cast<double>(side) - 0.5;
  const double left = std::floor(x);
  const double top = std::floor(y);
  const auto fx = static_cast<float>(x - left);
  const auto fy = static_cast<float>(y - top);
  for (const int j : {0, 1}) {
    for (const int i : {0, 1}) {
      const float share = weight * (i == 0 ? 1.0F - fx : fx) * (j == 0 ? 1.0F - fy : fy);
      const float* const rgba =
          texel_at(faces, side, at.face, static_cast<std::int64_t>(left) + i, static_cast<std::int64_t>(top) + j);
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += share * rgba[c];
      }
    }
  }
}

// A direction given around +z, around the normal instead [Duff et al. 2017].
struct NormalBasis {
  CubeDirection a{}, b{}, n{};

  explicit NormalBasis(const CubeDirection& given) {
    const double length = std::hypot(given[0], given[1], given[2]);
    n = {given[0] / length, given[1] / length, given[2] / length};
    const double sign = std::copysign(1.0, n[2]);
    const double p = -1.0 / (sign + n[2]);
    const double q = n[0] * n[1] * p;
    a = {1.0 + sign * n[0] * n[0] * p, sign * q, -sign * n[0]};
    b = {q, sign + n[1] * n[1] * p, -n[1]};
  }
  CubeDirection turned(const CubeDirection& d) const {
    CubeDirection out{};
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = d[0] * a[c] + d[1] * b[c] + d[2] * n[c];
    }
    return out;
  }
};

// A row of texels; rows are counted through all faces, each `small` texels high.
void blur_row(const CubeChain& mips, std::size_t side, const std::vector<LobeSample>& lobe, std::size_t row,
              std::size_t small, CubeFaces& out) {
  const auto centre = [&](std::size_t i) {
    return 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(small) - 1.0;
  };
  const std::size_t face = row / small;
  for (std::size_t column = 0; column < small; ++column) {
    const NormalBasis basis(cube_direction({face, centre(column), centre(row % small)}));
    std::array<float, 3> sum{};
    for (const LobeSample& sample : lobe) {
      add_light(mips[sample.mip], side >> sample.mip, basis.turned(sample.direction), sample.weight, sum);
    }
    std::ranges::copy(sum, &out[face][4 * (row % small * small + column)]);
  }
}

}  // namespace

double mip_alpha(std::size_t level, std::size_t count) {
  const double roughness = count < 2 ? 0.0 : static_cast<double>(level) / static_cast<double>(count - 1);
  return roughness * roughness;
}

CubeChain prefiltered(const CubeFaces& sky, std::size_t side) {
  const CubeChain mips = mips_of(sky, side);
  CubeChain out = mips;
  for (std::size_t level = 1; level < out.size(); ++level) {
    const std::vector<LobeSample> lobe = lobe_of(mip_alpha(level, out.size()), side, mips.size());
    const std::size_t small = side >> level;
    for_row_strips(static_cast<int>(kCubeFaces * small), [&](int first, int end) {
      for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(end); ++row) {
        blur_row(mips, side, lobe, row, small, out[level]);
      }
    });
  }
  return out;
}

}  // namespace airlight
