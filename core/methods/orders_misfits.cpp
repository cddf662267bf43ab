// Scenes with clouds that `orders` cannot render, although it knows all that stands in them.

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/orders_parts.h"
#include "core/scene/thing_kinds.h"

namespace airlight::orders {
namespace {

// Whether the cloud may hold water. Of a file of OpenVDB that is yet to be read nothing is known.
bool stands(const Cloud& cloud) {
  const bool is_file = cloud.kind == CloudKind::volume;
  return cloud.top > cloud.base && (is_file || (cloud.cover > 0.0 && cloud.water > 0.0));
}

std::string reach(const Cloud& cloud) {
  return "from " + rounded(cloud.base, 6) + " to " + rounded(cloud.top, 6) + " km";
}

bool has_things(const Scene& scene) {
  return scene.terrain || has_bodies(scene) || scene.ground;
}

}  // namespace

std::vector<Misfit> cloud_misfits(const Scene& scene) {
  std::vector<Misfit> misfits;
  if (scene.clouds.empty()) {
    return misfits;
  }
  const auto add = [&](const std::string& pointer, const std::string& what) {
    misfits.push_back(
        {pointer, "the method \"orders\" " + what + ", or choose path-trace with render.method or --method"});
  };
  std::vector<const Cloud*> clouds;
  for (const Cloud& cloud : scene.clouds) {
    if (stands(cloud)) {
      clouds.push_back(&cloud);
    }
  }
  std::ranges::stable_sort(clouds, {}, &Cloud::base);
  for (std::size_t i = 1; i < clouds.size(); ++i) {
    const Cloud& below = *clouds[i - 1];
    const Cloud& above = *clouds[i];
    if (above.base < below.top) {
      add("/clouds/" + std::to_string(above.index) + (above.kind == CloudKind::volume ? "/file" : "/base_km"),
          "renders fields of cloud one above the other, and the one " + reach(above) +
              " begins below the top of the one " + reach(below) + "; move one of them");
    }
  }
  if (const auto mirror = far_mirror(scene)) {
    add("/scene/spheres/" + std::to_string(*mirror) + "/material",
        "renders clouds in mirrors within 2 km of the camera and 20 m of its altitude; move the mirror, choose another "
        "material, remove the clouds");
  }
  if (scene.camera.polariser && has_things(scene)) {
    add("/camera/polariser",
        "renders no clouds through a polarising filter where terrain, spheres or ground maps stand; remove one of the "
        "three");
  }
  return misfits;
}

std::string no_layers_of(const Scene& scene) {
  if (scene.clouds.empty() || !has_things(scene)) {
    return {};
  }
  return "the method \"orders\" renders layers and composites with clouds where no terrain, spheres or ground maps "
         "stand, and pictures and irradiance among them; remove these or the clouds";
}

void refuse_around_clouds(const Scene& scene, bool no_picture) {
  for (const Misfit& misfit : cloud_misfits(scene)) {
    throw InputError(misfit.pointer + ": " + misfit.message);
  }
  if (const std::string why = no_picture ? no_layers_of(scene) : std::string(); !why.empty()) {
    throw InputError("clouds: " + why);
  }
}

}  // namespace airlight::orders
