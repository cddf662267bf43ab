#pragma once
// Light for glossy surfaces, as engines look it up: the first sum of the split-sum approximation [Karis 2013, Real
// Shading in Unreal Engine 4], a cube map whose mips are the sky seen by ever rougher mirrors.
//
// The mip i of n has the roughness i / (n - 1), and GGX's alpha is its square [Burley 2012]. A texel toward N is the
// mean of the sky L over directions l, for a view and a normal of N:
//   sum of L(l) (N.l) D(h) / sum of (N.l) D(h),   h halfway between N and l,
//   D(h) = alpha^2 / (pi ((N.h)^2 (alpha^2 - 1) + 1)^2)                             [Walter et al. 2007, eq. 33]
// over the half of the sphere above N. The sharpest mip is the sky itself.

#include "core/output/cube_faces.h"

namespace airlight {

// GGX's alpha of the mip `level` of `count`; 0 of the first.
double mip_alpha(std::size_t level, std::size_t count);

// The sky, and its mips for growing roughness. Within 1 % of that mean for a sky that the map itself resolves.
CubeChain prefiltered(const CubeFaces& sky, std::size_t side);

}  // namespace airlight
