#pragma once
// The six faces of a cube map as engines sample it: OpenGL 4.6, table 8.19; Direct3D and Vulkan have the same. Face +X
// is the first, then -X, +Y, -Y, +Z, -Z. u grows along a face's columns, v down its rows, from -1 to 1.

#include <array>
#include <cstddef>
#include <vector>

namespace airlight {

inline constexpr std::size_t kCubeFaces = 6;
using CubeDirection = std::array<double, 3>;
using CubeFaces = std::array<std::vector<float>, kCubeFaces>;  // RGBA, all faces of one side
using CubeChain = std::vector<CubeFaces>;                      // sides halved, rounded down, from one to the next

struct CubePoint {
  std::size_t face = 0;
  double u = 0.0;
  double v = 0.0;
};

// Where a direction of any length is looked up, and back: the direction's greatest component is then 1.
CubePoint cube_point(const CubeDirection& direction);
CubeDirection cube_direction(const CubePoint& point);

// The texel that holds u, from 0; u within -1 to 1.
std::size_t cube_index(double u, std::size_t side);

// The faces and all their mips down to one texel. A texel is the mean of what it covers, parts of texels by their
// share, so the mean of a face stays.
CubeChain mips_of(CubeFaces faces, std::size_t side);

}  // namespace airlight
