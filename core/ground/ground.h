#pragma once
// The ground of a scene by maps as those who light it want it: albedo and water with means of them, and what waves
// mirror. What the files hold is in the scene already; nothing here reads a file.

#include <memory>
#include <string>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// As the camera stands over it, north up in the preset's frame; null where the planet has one albedo. The maps of a
// planet are the same object as long as they are the last ones asked for.
std::shared_ptr<const physics::HostGround> ground_of(const Scene& scene);

// Mean reflectance of the map over the planet, by area: what the air is lit by from below.
Spectrum mean_albedo(const GroundFiles& files);

// Two grounds of one key have the same maps, wherever the camera is.
std::string ground_key(const Scene& scene);

// Share of the sun's light that an ocean of this slope variance mirrors, by quadrature over the slopes of its waves.
double glint_share(double slope_variance, double mu_sun);

}  // namespace airlight
