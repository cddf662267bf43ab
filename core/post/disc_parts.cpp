#include "core/post/disc_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/air/scene_block.h"

namespace airlight {
namespace {

using physics::vec3;

// The disc's bounding box in pixels from the upper left corner. Across a round picture's seam it continues below 0 or
// beyond the width.
struct Box {
  double low_x = 0.0;
  double low_y = 0.0;
  double high_x = 0.0;
  double high_y = 0.0;
};

Box whole_box(const Scene& scene) {
  return {0.0, 0.0, static_cast<double>(scene.image.width), static_cast<double>(scene.image.height)};
}

constexpr Box kNoBox{1e300, 1e300, -1e300, -1e300};

void extend(Box& box, const physics::vec2& at) {
  box = {std::min(box.low_x, at.x), std::min(box.low_y, at.y), std::max(box.high_x, at.x), std::max(box.high_y, at.y)};
}

// Enlarges the box: chords join the rim's points, and the device computes in floats.
Box with_slack(const Box& box) {
  const double slack_x = 1e-4 + 1e-3 * (box.high_x - box.low_x);
  const double slack_y = 1e-4 + 1e-3 * (box.high_y - box.low_y);
  return {box.low_x - slack_x, box.low_y - slack_y, box.high_x + slack_x, box.high_y + slack_y};
}

// Angle around the sun's seen middle in which the disc is. Air that bends light flattens the disc and parts its colours
// by a few hundredths of its radius; from space it may move the disc by more than a degree.
double seen_radius(const physics::Physics& p, const Scene& scene) {
  constexpr double kColours = 1.06;
  constexpr double kMostBending = 0.03;
  const double radius = scene.sun.disc.angular_radius;
  const bool in_space = p.scene.camera.altitude > p.scene.planet.atmosphere_height;
  return !p.refraction ? radius : kColours * radius + (in_space ? kMostBending : 0.0);
}

std::array<vec3, 720> rim_points(const vec3& sun, double radius) {
  const auto [a, b] = across(sun);
  std::array<vec3, 720> rim;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(rim.size());
    rim[i] = sun * std::cos(radius) + (a * std::cos(t) + b * std::sin(t)) * std::sin(radius);
  }
  return rim;
}

// None where the disc is behind the camera.
std::optional<Box> rim_box(physics::Physics& p, const Scene& scene) {
  const physics::uint projection = projection_code(scene.camera.projection);
  const bool round = scene.camera.projection == Projection::equirectangular;
  const vec3 sun = p.scene.sun.seen;
  const double width = scene.image.width;
  const double middle = p.pixel_of(p.scene.camera, projection, sun).x;
  const auto rim = rim_points(sun, seen_radius(p, scene));
  Box box = kNoBox;
  std::size_t behind = 0;
  for (const vec3& point : rim) {
    const auto at = p.pixel_of(p.scene.camera, projection, point);
    behind += at.in_front ? 0 : 1;
    extend(box, {round ? middle + std::remainder(at.x - middle, width) : at.x, at.y});
  }
  if (behind == rim.size()) {
    return std::nullopt;
  }
  return behind > 0 ? whole_box(scene) : box;
}

std::optional<Box> disc_box(physics::Physics& p, const Scene& scene) {
  std::optional<Box> box = rim_box(p, scene);
  if (!box) {
    return box;
  }
  const double radius = seen_radius(p, scene);
  if (scene.camera.projection == Projection::equirectangular &&
      std::abs(scene.sun.elevation) + radius > 0.5 * std::numbers::pi) {
    // The disc covers a pole: every column, from the pole to the rim.
    const bool zenith = scene.sun.elevation > 0.0;
    box = Box{0.0, zenith ? 0.0 : box->low_y, static_cast<double>(scene.image.width),
              zenith ? box->high_y : static_cast<double>(scene.image.height)};
    box->low_x -= box->high_x;
    box->high_x *= 2.0;
  }
  if (scene.camera.projection == Projection::fisheye &&
      physics::dot(p.scene.sun.seen, p.scene.camera.forward) < -std::cos(radius)) {
    return whole_box(scene);  // around the point straight behind
  }
  return with_slack(*box);
}

// A part of a map that is cut: a face of a cube, a quadrant of an octahedral map. `holds`: whether a direction, in the
// axes of in_camera, falls on it; `pixel_of`: the direction's pixel, also beyond the part's edges.
template <class Holds, class PixelOf>
std::optional<Box> part_box(physics::Physics& p, const Scene& scene, const Box& part, Holds holds, PixelOf pixel_of) {
  const vec3 sun = p.scene.sun.seen;
  const auto rim = rim_points(sun, seen_radius(p, scene));
  const auto is_held = [&](const vec3& direction) { return holds(p.in_camera(p.scene.camera, direction)); };
  if (!is_held(sun) && std::ranges::none_of(rim, is_held)) {
    return std::nullopt;
  }
  Box box = kNoBox;
  for (const vec3& point : rim) {
    extend(box, pixel_of(p.in_camera(p.scene.camera, point)));
  }
  box = with_slack(box);
  box = {std::max(box.low_x, part.low_x), std::max(box.low_y, part.low_y), std::min(box.high_x, part.high_x),
         std::min(box.high_y, part.high_y)};
  return box.low_x < box.high_x && box.low_y < box.high_y ? std::optional(box) : std::nullopt;
}

std::vector<Box> cube_boxes(physics::Physics& p, const Scene& scene) {
  const double side = p.cube_side(p.scene.camera);
  std::vector<Box> boxes;
  for (physics::uint face = 0; face < 6; ++face) {
    const auto cell = p.cube_cell(p.scene.camera, face);
    const Box part{cell.column * side, cell.row * side, (cell.column + 1.0) * side, (cell.row + 1.0) * side};
    const std::optional<Box> box = part_box(
        p, scene, part, [&](const vec3& local) { return p.cube_face_of(local) == face; },
        [&](const vec3& local) { return p.cube_pixel(p.scene.camera, p.cube_face_point(face, local)); });
    if (box) {
      boxes.push_back(*box);
    }
  }
  return boxes;
}

// A box for each quadrant, so that no two overlap: each holds an octant of the upper half and one of the lower.
std::vector<Box> octahedral_boxes(physics::Physics& p, const Scene& scene) {
  const double half_width = 0.5 * scene.image.width;
  const double half_height = 0.5 * scene.image.height;
  std::vector<Box> boxes;
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const double right = quadrant % 2;
    const double lower = quadrant / 2;
    const Box part{right * half_width, lower * half_height, (right + 1.0) * half_width, (lower + 1.0) * half_height};
    std::optional<Box> both;
    for (const double up : {1.0, -1.0}) {
      const vec3 signs(2.0 * right - 1.0, up, 1.0 - 2.0 * lower);
      const std::optional<Box> box = part_box(
          p, scene, part, [&](const vec3& local) { return physics::length(p.octant_of(local) - signs) == 0.0; },
          [&](const vec3& local) {
            const physics::vec2 square = p.octahedral_point(local, signs);
            return physics::vec2{(1.0 + square.x) * half_width, (1.0 + square.y) * half_height};
          });
      if (box && both) {
        extend(*both, {box->low_x, box->low_y});
        extend(*both, {box->high_x, box->high_y});
      } else if (box) {
        both = box;
      }
    }
    if (both) {
      boxes.push_back(*both);
    }
  }
  return boxes;
}

// Boxes of which no two overlap.
std::vector<Box> disc_boxes(physics::Physics& p, const Scene& scene) {
  if (scene.camera.projection == Projection::cube) {
    return cube_boxes(p, scene);
  }
  if (scene.camera.projection == Projection::octahedral) {
    return octahedral_boxes(p, scene);
  }
  const std::optional<Box> box = disc_box(p, scene);
  return box ? std::vector<Box>{*box} : std::vector<Box>();
}

// Width 0: the box lies outside the picture.
DiscRectangle pixels_in(const Scene& scene, const Box& box) {
  const double width = scene.image.width;
  const double height = scene.image.height;
  const bool seam = scene.camera.projection == Projection::equirectangular && (box.low_x < 0.0 || box.high_x > width);
  const double left = seam ? 0.0 : std::clamp(std::floor(box.low_x), 0.0, width);
  const double right = seam ? width : std::clamp(std::ceil(box.high_x), 0.0, width);
  const double top = std::clamp(std::floor(box.low_y), 0.0, height);
  const double bottom = std::clamp(std::ceil(box.high_y), 0.0, height);
  if (right <= left || bottom <= top) {
    return {};
  }
  return {static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top), static_cast<std::uint32_t>(right - left),
          static_cast<std::uint32_t>(bottom - top)};
}

// The part of the rectangle that lies in the tile.
DiscRectangle within(const DiscRectangle& all, const Tile& tile) {
  const auto count = [](int n) { return static_cast<std::uint32_t>(n); };
  const std::uint32_t left = std::max(all.left, count(tile.x));
  const std::uint32_t top = std::max(all.top, count(tile.y));
  const std::uint32_t right = std::min(all.left + all.width, count(tile.x + tile.width));
  const std::uint32_t bottom = std::min(all.top + all.height, count(tile.y + tile.height));
  return right > left && bottom > top ? DiscRectangle{left, top, right - left, bottom - top} : DiscRectangle{};
}

// Samples along one side of a pixel: many where the whole disc falls into a few, few where only its edge needs them.
std::uint32_t samples_for(double extent) {
  return extent < 3.0 ? 24 : extent < 12.0 ? 8 : 4;
}

bool wholly_set(physics::Physics& p, const Scene& scene) {
  const double horizon = std::asin(p.horizon_mu(p.scene.planet, p.scene.camera.altitude));
  return std::asin(p.scene.sun.seen.y) + seen_radius(p, scene) < horizon;
}

}  // namespace

std::array<vec3, 2> across(const vec3& axis) {
  const vec3 any = std::abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  const vec3 a = physics::normalize(any - axis * physics::dot(any, axis));
  return {a, physics::cross(axis, a)};
}

std::vector<DiscPart> disc_parts(physics::Physics& p, const Scene& scene, const Tile& tile) {
  std::vector<DiscPart> parts;
  if (!scene.sun.disc.visible || scene.sun.disc.radiance_scale == 0.0 || wholly_set(p, scene)) {
    return parts;
  }
  for (const Box& box : disc_boxes(p, scene)) {
    const DiscRectangle pixels = within(pixels_in(scene, box), tile);
    if (pixels.width > 0) {
      parts.push_back({pixels,
                       {{box.low_x, box.low_y},
                        {box.high_x, box.high_y},
                        samples_for(box.high_x - box.low_x),
                        samples_for(box.high_y - box.low_y)}});
    }
  }
  return parts;
}

}  // namespace airlight
