#include "core/scene/json_format.h"
#include "core/scene/readers.h"

namespace airlight {
namespace {

constexpr double kMetres = 1e3;   // a km
constexpr double kGrey = 0.18;    // of a grey card
constexpr double kChrome = 0.55;  // of chromium at normal incidence, much the same over all that the eye sees

// "grey-18" and "chrome" stand for a material and its albedo.
void take_material(std::size_t choice, Sphere& sphere) {
  const std::string_view name = kMaterialNames.at(choice);
  const bool grey = name == "grey-18";
  if (grey || name == "chrome") {
    sphere.material = grey ? SphereMaterial::matte : SphereMaterial::mirror;
    const double share = grey ? kGrey : kChrome;
    sphere.albedo.fill(share);
    sphere.albedo.curve = constant_curve(share);
  }
}

Sphere read_sphere(Section section) {
  section.refuse_unknown_keys();
  Sphere sphere;
  const auto choice = section.choice("material");
  if (!choice) {
    return sphere;
  }
  section.choose(kMaterialNames[*choice]);
  section.fill(sphere);
  take_material(*choice, sphere);
  const PresetValue* radius = section.find("radius_m");
  if (radius != nullptr && sphere.distance > 0.0 && sphere.radius >= sphere.distance) {
    section.complain("radius_m", *radius,
                     format_number(sphere.radius * kMetres) + " m is not below distance_m, " +
                         format_number(sphere.distance * kMetres) +
                         " m: the camera would stand inside; make it smaller or put it farther away");
  }
  return sphere;
}

}  // namespace

std::vector<Sphere> read_spheres(const Section& root) {
  const Section section = root.child("scene");
  section.refuse_unknown_keys();
  const PresetValue* value = section.find("spheres");
  if (value == nullptr) {
    return {};
  }
  const PresetArray* array = section.list("spheres", *value, "spheres");
  if (array == nullptr) {
    return {};
  }
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < array->size(); ++i) {
    spheres.push_back(read_sphere(section.element("spheres", *array, i)));
  }
  return spheres;
}

}  // namespace airlight
