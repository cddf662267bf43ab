#pragma once
// The sky in patches of nearly equal solid angle, for daylight matrices: Tregenza's 145 (1987), each divided by
// Reinhart's factor in both directions, and one patch for all directions below the horizon.
//
// Rows of equal height from the horizon up have 30, 30, 24, 24, 18, 12 and 6 patches times the factor; one patch is
// left at the zenith. The first patch of a row looks north, the next ones go clockwise: east is a quarter of the row
// later.

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/radiance_image.h"

namespace airlight {

inline constexpr int kMostSkyDivisions = 4;

class SkyPatches {
 public:
  // Divides each of Tregenza's patches in `factor` by `factor`, 1 to kMostSkyDivisions: 146, 578, 1298, 2306 patches.
  explicit SkyPatches(int factor);

  std::size_t count() const { return solid_angles_.size(); }                    // patch 0 is the ground
  double solid_angle(std::size_t patch) const { return solid_angles_[patch]; }  // sr; 2 pi of the ground

  // Unit vector to the patch's middle: x east, y up, z south, as core/render/lighting.h has them. Not of the ground.
  std::array<double, 3> centre(std::size_t patch) const;

  // The patch at an elevation and an azimuth clockwise from north, radians.
  std::size_t at(double elevation, double azimuth) const;

  // The four patches around a direction above the horizon, each with its share of a light from there. Between the
  // lowest row's middle and the zenith the shares give a level surface what the light gives it: they are linear in the
  // sine of the elevation, and in the azimuth along a row.
  struct Share {
    std::size_t patch;
    double share;
  };
  std::array<Share, 4> around(double elevation, double azimuth) const;

 private:
  struct Row {
    std::size_t first = 0;
    int count = 1;
  };
  double height_;  // of a row, radians
  std::vector<Row> rows_;
  std::vector<double> solid_angles_;
};

// Mean radiance of each patch in equirectangular pictures of one size whose centre looks north. Pixels are shared out
// by a grid of points in each, so that a patch's light is that of its solid angle to 0.5 %, and the sum over the
// patches is the picture's.
class PatchMeans {
 public:
  PatchMeans(const SkyPatches& patches, int width, int height);

  // Three channels a patch. The picture is of that size.
  std::vector<std::array<double, 3>> of(const RadianceImage& latlong) const;

 private:
  struct Piece {  // of a pixel
    std::size_t pixel;
    std::size_t patch;
    double weight;
  };
  std::vector<Piece> pieces_;  // those of a patch have weights that add up to 1
  std::size_t count_;
};

}  // namespace airlight
