#pragma once
// The ground by maps as passes of their own over a picture whose ground is black: a picture without maps pays nothing.

#include <string>
#include <vector>

#include "core/methods/sky_pass.h"

namespace airlight {

// The method's tables that light the ground.
struct GroundLight {
  ImageId transmittance;
  ImageId irradiance;                     // of the sky on level ground, over (1 + mu_sun)/2
  bool sky = true;                        // false: `irradiance` is any image, and the sky sends none
  std::vector<Specialization> constants;  // of transmittance_lut; kMomentDegree, kDeltaScaled where the method has them
};

// The scene where its picture is to have no ground: the passes between these two read it with a black one.
// Nothing where the scene has no maps.
void begin_black_ground(Plan& plan, const Scene& scene, const View& view);
void end_black_ground(Plan& plan, const Scene& scene);

// Adds the ground's light to the target. Nothing where the scene has no maps.
void add_ground_map(Plan& plan, const Scene& scene, const SkyTarget& target, GroundLight light);

// Irradiance of the sky from the table of moments, for GroundLight. `constants`: of that table.
ImageId add_moment_irradiance(Plan& plan, ImageId moments, std::vector<Specialization> constants);

// Why layers do not go with the scene's ground; empty where they do.
std::string ground_layers_refusal(const Scene& scene);

}  // namespace airlight
