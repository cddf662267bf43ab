#pragma once
// The camera in a picture's header, as a preset has it.

#include <array>
#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace airlight::composite {

// p_out = p_in * M with row vectors, row by row, as OpenEXR's M44f.
using Matrix = std::array<double, 16>;

enum class UpAxis { y, z };  // of the other program's world: y up with -z north, or z up with y north (Blender's)

struct FileCamera {
  double altitude = 0.0;  // km
  double azimuth = 0.0;   // rad
  double pitch = 0.0;
  double roll = 0.0;
  std::optional<double> vertical_fov;  // rad; known from world_to_ndc alone
};

// Takes the camera from the matrices that exist; world_to_ndc, which also holds the lens, has precedence. Without it
// the camera looks along -z if its space is right-handed, as in airlight and Blender, and along +z if it is
// left-handed, as in RenderMan. `unit_km`: the world's unit. Throws InputError, beginning with `file`: neither matrix,
// one that cannot be inverted, a shifted lens, no perspective.
FileCamera camera_of(const std::string& file, const std::optional<Matrix>& world_to_camera,
                     const std::optional<Matrix>& world_to_ndc, UpAxis up, double unit_km);

}  // namespace airlight::composite
