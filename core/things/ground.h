#pragma once
// A scene's ground by maps, ready for lighting: albedo and water with means of them, and what waves mirror. The scene
// already holds the files' contents; nothing here reads a file.

#include <string>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// The planet's maps, without a place of the camera; `albedo`: where no map tells it.
physics::HostGround planet_maps(const GroundMap& map, const Spectrum& albedo);

// The ground as the camera stands over it, north up in the preset's frame.
physics::HostGround seen_from(physics::HostGround maps, const Camera& camera);

// Mean reflectance of the map over the planet, by area: the ground's part in lighting the air from below.
Spectrum mean_albedo(const GroundFiles& files);

// Two grounds with equal keys have the same maps, wherever the camera is.
std::string ground_key(const Scene& scene);

// Share of the sun's light that an ocean of this slope variance mirrors, by quadrature over the slopes of its waves.
double glint_share(double slope_variance, double mu_sun);

}  // namespace airlight
