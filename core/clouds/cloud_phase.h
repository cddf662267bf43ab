#pragma once
// What scatters sunlight once in a cloud, all orders of small turns taken for one (shaders/physics/cloud_light.glsl).

#include <vector>

#include "core/physics/device_scene.h"
#include "core/physics/physics.h"

namespace airlight {

// Values per unit of scaled depth at kPhaseSamples angles (phase_table.glsl), a row for each of kCloudPeakRows depths.
// `p`: formulas of an air whose medium 0 is the cloud's matter; `degree`: of the harmonics that the field keeps.
std::vector<device::vec3> cloud_phase_rows(physics::Physics& p, double single_scattering_albedo, int degree);

}  // namespace airlight
