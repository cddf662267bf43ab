#include "core/scene/cloud_pixels.h"

#include <cmath>
#include <numbers>

#include "core/base/text.h"

namespace airlight {
namespace {

double faces_across(CubeLayout layout) {
  switch (layout) {
    case CubeLayout::stack:
      return 1.0;
    case CubeLayout::strip:
      return 6.0;
    case CubeLayout::cross:
      return 4.0;
  }
  return 1.0;
}

}  // namespace

double pixel_width(const Camera& camera, const ImageSize& image, double distance) {
  switch (camera.projection) {
    case Projection::perspective:
      return distance * 2.0 * std::tan(0.5 * camera.vertical_fov) / image.height;
    case Projection::fisheye:
      return distance * camera.vertical_fov / image.height;
    case Projection::cube:
      return distance * 2.0 * faces_across(camera.cube_layout) / image.width;
    case Projection::equirectangular:
    case Projection::octahedral:
      break;
  }
  return distance * 2.0 * std::numbers::pi / image.width;
}

std::vector<std::string> cloud_warnings(const Scene& scene) {
  constexpr double kPixels = 2.0;  // a cell
  std::vector<std::string> lines;
  for (const Cloud& cloud : scene.clouds) {
    const double distance = scene.camera.altitude - cloud.top;
    const double width = distance > 0.0 ? pixel_width(scene.camera, scene.image, distance) : 0.0;
    if (cloud.kind != CloudKind::volume && width > cloud.cell / kPixels) {
      lines.push_back("/clouds/" + std::to_string(cloud.index) + "/cell_km: a pixel sees " + rounded(width, 2) +
                      " km of clouds that stand " + rounded(cloud.cell, 3) +
                      " km apart, so the picture has patterns that the field does not have; render it larger, lower "
                      "the camera, or choose larger cells");
    }
  }
  return lines;
}

}  // namespace airlight
