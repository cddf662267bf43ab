#pragma once
// Passes that add the ground by maps to a picture with a black ground: a picture without maps pays nothing.

#include <string>
#include <vector>

#include "core/methods/sky_pass.h"

namespace airlight {

// The method's tables for lighting the ground.
struct GroundLight {
  ImageId transmittance;
  ImageId irradiance;                     // of the sky on level ground, over (1 + mu_sun)/2
  bool sky = true;                        // false: the sky sends no light, and `irradiance` is any image
  std::vector<Specialization> constants;  // of transmittance_lut and of the table of moments
};

// Passes added between these two see the scene with a black ground. No effect where the scene has no maps.
void begin_black_ground(Plan& plan, const Part& part, const View& view);
void end_black_ground(Plan& plan, const Part& part, const View& view);

// Adds the ground's light to the target. No effect where the scene has no maps.
void add_ground_map(Plan& plan, const Part& part, const SkyTarget& target, GroundLight light);

// Irradiance of the sky from the table of moments, for GroundLight. `constants`: of that table.
ImageId add_moment_irradiance(Plan& plan, ImageId moments, std::vector<Specialization> constants);

}  // namespace airlight
