#include "core/output/cube_faces.h"

#include <algorithm>
#include <cmath>

namespace airlight {
namespace {

// The mean over the pixels that each new one covers, parts of pixels by their share: the face's mean stays.
std::vector<float> halved(const std::vector<float>& face, std::size_t side, std::size_t smaller) {
  const double step = static_cast<double>(side) / static_cast<double>(smaller);
  const auto share = [&](std::size_t to, std::size_t from) {
    const double start = static_cast<double>(to) * step;
    const auto at = static_cast<double>(from);
    return std::max(0.0, std::min(at + 1.0, start + step) - std::max(at, start)) / step;
  };
  std::vector<float> out;
  for (std::size_t y = 0; y < smaller; ++y) {
    for (std::size_t x = 0; x < smaller; ++x) {
      std::array<double, 4> sum{};
      const auto first_row = static_cast<std::size_t>(static_cast<double>(y) * step);
      const auto first_column = static_cast<std::size_t>(static_cast<double>(x) * step);
      for (std::size_t j = first_row; j < side && share(y, j) > 0.0; ++j) {
        for (std::size_t i = first_column; i < side && share(x, i) > 0.0; ++i) {
          for (std::size_t c = 0; c < 4; ++c) {
            sum[c] += share(y, j) * share(x, i) * static_cast<double>(face[4 * (j * side + i) + c]);
          }
        }
      }
      for (const double value : sum) {
        out.push_back(static_cast<float>(value));
      }
    }
  }
  return out;
}

}  // namespace

CubePoint cube_point(const CubeDirection& d) {
  const auto [x, y, z] = d;
  const double most = std::max({std::abs(x), std::abs(y), std::abs(z)});
  if (std::abs(x) == most) {
    return x > 0.0 ? CubePoint{0, -z / most, -y / most} : CubePoint{1, z / most, -y / most};
  }
  if (std::abs(y) == most) {
    return y > 0.0 ? CubePoint{2, x / most, z / most} : CubePoint{3, x / most, -z / most};
  }
  return z > 0.0 ? CubePoint{4, x / most, -y / most} : CubePoint{5, -x / most, -y / most};
}

CubeDirection cube_direction(const CubePoint& at) {
  switch (at.face) {
    case 0:
      return {1.0, -at.v, -at.u};
    case 1:
      return {-1.0, -at.v, at.u};
    case 2:
      return {at.u, 1.0, at.v};
    case 3:
      return {at.u, -1.0, -at.v};
    case 4:
      return {at.u, -at.v, 1.0};
    default:
      return {-at.u, -at.v, -1.0};
  }
}

std::size_t cube_index(double u, std::size_t side) {
  const auto texel = static_cast<std::size_t>(0.5 * (u + 1.0) * static_cast<double>(side));
  return std::min(texel, side - 1);
}

CubeChain mips_of(CubeFaces faces, std::size_t side) {
  CubeChain chain;
  while (true) {
    chain.push_back(faces);
    if (side == 1) {
      return chain;
    }
    for (std::vector<float>& face : faces) {
      face = halved(face, side, side / 2);
    }
    side /= 2;
  }
}

}  // namespace airlight
