#pragma once
// The terrain of a scene, ready for tracing and lighting: heights with maxima over their cells, albedo, and the shadow
// of the sun. The scene already holds the files' contents; nothing here reads a file. core/things/things.h makes each
// of them once.

#include <memory>
#include <string>
#include <vector>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// A ridge's heights for Terrain::ridge_heights, kept for later starts (core/gpu/kept_values.h).
std::shared_ptr<const std::vector<float>> ridge_heights_of(const Ridge& ridge);

// The heights at their place, without albedo and shadow.
physics::HostTerrain placed_heights(const Terrain& terrain);

// The heights with the terrain's albedo.
physics::HostTerrain with_albedo(const physics::HostTerrain& heights, const Terrain& terrain);

// The heights with the sun's shadow.
physics::HostTerrain with_shadow(const std::shared_ptr<const physics::HostTerrain>& heights, const Sun& sun,
                                 double planet_radius);

// Throws InputError where no point of the terrain is above the ground.
void refuse_sunken(const Terrain& terrain, const physics::HostTerrain& maps);

// Throws InputError where a camera of this altitude stands inside the terrain.
void refuse_buried_camera(double altitude, const std::shared_ptr<const physics::HostTerrain>& terrain);

// Two terrains with equal height_key() have the same heights; with equal terrain_key() the same albedo too. Two scenes
// with equal shadow_key() have the same shadow.
std::string height_key(const Terrain& terrain);
std::string terrain_key(const Terrain& terrain);
std::string shadow_key(const Scene& scene);

}  // namespace airlight
