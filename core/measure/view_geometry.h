#pragma once
// The direction of each pixel of a picture, and its region of the sky.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/measure/metrics.h"
#include "core/scene/angle.h"
#include "core/scene/scene.h"

namespace airlight::measure {

// The part of a scene that determines pixels' directions. Angles in radians, lengths in km.
struct Viewpoint {
  Camera camera;
  double sun_elevation = 0.0;
  double sun_azimuth = 0.0;
  double ground_radius = 6360.0;
};

// The picture's size and the stored part of it.
struct PixelFrame {
  int width = 0;  // of the whole picture
  int height = 0;
  int left = 0;  // of the stored part
  int top = 0;
  int columns = 0;
  int rows = 0;
};

struct LookDirection {
  double elevation = 0.0;
  double azimuth = 0.0;  // clockwise from north, 0 to 2 pi
  double sun_distance = 0.0;
};

// A pixel may lie in several regions.
enum Region : RegionBits {
  kAureole = 1,  // within kAureoleRadius of the sun and above the true horizon
  kHorizon = 2,  // less than kHorizonBand above the true horizon
  kZenith = 4,   // within kZenithRadius of the zenith
  kSky = 8,      // above the true horizon of the camera's altitude
  kGround = 16,  // below it
};

inline constexpr double kAureoleRadius = 10.0 * kDegree;
inline constexpr double kHorizonBand = 3.0 * kDegree;
inline constexpr double kZenithRadius = 15.0 * kDegree;

struct RegionName {
  Region region;
  std::string_view name;
};
inline constexpr std::array<RegionName, 5> kRegions = {
    {{kSky, "sky"}, {kAureole, "sun aureole"}, {kHorizon, "horizon band"}, {kZenith, "zenith"}, {kGround, "ground"}}};

// Direction of a stored pixel's centre; none outside a fisheye's circle.
std::optional<LookDirection> look_direction(const Viewpoint& viewpoint, const PixelFrame& frame, int column, int row);

// One value for each stored pixel, row by row; 0 outside a fisheye's circle.
std::vector<RegionBits> classify(const Viewpoint& viewpoint, const PixelFrame& frame);

// The viewpoint of a preset of format 1 with every key written out, as EXRs hold it. Throws InputError.
Viewpoint viewpoint_from_preset(std::string_view resolved_preset);

}  // namespace airlight::measure
