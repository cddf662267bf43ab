#include <algorithm>
#include <array>

#include "core/scene/json_format.h"
#include "core/scene/readers.h"

namespace airlight {
namespace {

std::string_view name_of_map(Projection projection) {
  switch (projection) {
    case Projection::cube:
      return "a cube map";
    case Projection::octahedral:
      return "an octahedral map";
    default:
      return "an equirectangular picture";
  }
}

// Refuses a tilt for a map: a map is the whole sphere in its upright frame, and the tilt would have no effect.
void refuse_tilt(const Section& camera, std::string_view key, Projection projection) {
  const PresetValue* value = camera.find(key);
  const auto* degrees = value == nullptr ? nullptr : std::get_if<double>(&value->data);
  if (degrees != nullptr && *degrees != 0.0) {
    camera.complain(key, *value,
                    format_number(*degrees) + " is not 0; " + std::string(name_of_map(projection)) +
                        " cannot be tilted: set it to 0");
  }
}

// Refuses a filter for a map, in which no side is up.
void refuse_filter_of_map(const Section& camera, Projection projection) {
  if (is_map(projection)) {
    camera.complain("polariser", *camera.find("polariser"),
                    "a polarising filter turns with the camera, and " + std::string(name_of_map(projection)) +
                        " has none; choose the projection \"perspective\" or \"fisheye\", or remove it");
  }
}

// Empty where the size suits the projection; else the rule for the size, with the nearest suitable one.
std::string wanted_size(const Camera& camera, const ImageSize& image) {
  if (!is_cut(camera.projection)) {
    return {};
  }
  ImageSize cells{1, 1};
  std::string what = "an octahedral map is square";
  if (camera.projection == Projection::cube) {
    const std::array<ImageSize, 3> layouts = {{{1, 6}, {6, 1}, {3, 4}}};
    cells = layouts.at(static_cast<std::size_t>(camera.cube_layout));
    what = "a cube's " + std::string(kCubeLayoutNames.at(static_cast<std::size_t>(camera.cube_layout))) + " is " +
           std::to_string(cells.width) + " x " + std::to_string(cells.height) + " square faces";
  }
  const int side = std::max(1, std::min(image.width / cells.width, image.height / cells.height));
  if (image.width == side * cells.width && image.height == side * cells.height) {
    return {};
  }
  return what + ": give for example " + std::to_string(side * cells.width) + "x" + std::to_string(side * cells.height);
}

}  // namespace

Camera read_camera(const Section& root) {
  Section section = root.child("camera");
  section.refuse_unknown_keys();
  Camera camera;
  const auto projection = section.choice("projection");
  if (!projection) {
    return camera;
  }
  section.choose(kProjectionNames[*projection]);
  section.fill(camera);
  if (section.find("polariser") != nullptr) {
    const Section filter = section.child("polariser");
    filter.refuse_unknown_keys();
    filter.fill(camera);
    refuse_filter_of_map(section, camera.projection);
  }
  if (is_map(camera.projection)) {
    refuse_tilt(section, "pitch_deg", camera.projection);
    refuse_tilt(section, "roll_deg", camera.projection);
    camera.vertical_fov = 0.0;
  }
  return camera;
}

ImageSize read_image(const Section& root, const Camera& camera) {
  const Section section = root.child("image");
  section.refuse_unknown_keys();
  ImageSize image;
  section.fill(image);
  if (const std::string wanted = wanted_size(camera, image); !wanted.empty()) {
    const PresetValue* place = section.find("width") != nullptr ? section.find("width") : section.find("height");
    root.problems().add(place != nullptr ? *place : root.context(), "/image",
                        std::to_string(image.width) + "x" + std::to_string(image.height) + " does not fit; " + wanted);
  }
  return image;
}

Bloom read_bloom(const Section& root, const Camera& camera) {
  const Section section = root.child("bloom");
  section.refuse_unknown_keys();
  Bloom bloom;
  section.fill(bloom);
  bloom.in_exr = bloom.enabled && section.find("enabled") != nullptr;
  if (is_cut(camera.projection)) {
    if (bloom.in_exr) {
      section.complain("enabled", *section.find("enabled"),
                       "true is not possible for " + std::string(name_of_map(camera.projection)) +
                           ", where the glow would stop at the edges; set it to false");
    }
    bloom.enabled = false;
    bloom.in_exr = false;
  }
  return bloom;
}

}  // namespace airlight
