#pragma once
// The terrain of a scene, ready for tracing and lighting: heights with maxima over their cells, albedo, and the shadow
// of the sun. The scene already holds the files' contents; nothing here reads a file.

#include <memory>
#include <string>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// The terrain's heights and albedo, with a blank shadow. The last few terrains are kept: a second request gets the same
// object, and terrains of the same heights share these. Throws InputError where the camera stands inside the terrain.
std::shared_ptr<const physics::HostTerrain> terrain_of(const Scene& scene);

// The terrain with the shadow of the scene's sun.
std::shared_ptr<const physics::HostTerrain> shadowed_terrain(const Scene& scene);

// Greatest distance of a shadow from the camera, km along the ground.
double shadow_reach(const physics::TerrainData& shape);

// Two terrains with equal height_key() have the same heights; with equal terrain_key() the same albedo too.
std::string height_key(const Terrain& terrain);
std::string terrain_key(const Terrain& terrain);

}  // namespace airlight
