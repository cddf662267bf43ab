#pragma once
// The terrain of a scene as those who trace and light it want it: heights with maxima over their cells, albedo, and the
// shadow that the sun casts. What its files hold is in the scene already; nothing here reads a file.

#include <memory>
#include <string>

#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// The terrain's heights and albedo; the shadow is blank. The last few asked for are kept: who asks for one again gets
// the same object, and all of the same heights share those. Throws InputError where the camera stands inside the
// terrain.
std::shared_ptr<const physics::HostTerrain> terrain_of(const Scene& scene);

// The terrain with the shadow of the scene's sun.
std::shared_ptr<const physics::HostTerrain> shadowed_terrain(const Scene& scene);

// How far from the camera, km along the ground, a shadow may stand.
double shadow_reach(const physics::TerrainData& shape);

// Two terrains of one key have the same heights; of the second kind the same albedo too.
std::string height_key(const Terrain& terrain);
std::string terrain_key(const Terrain& terrain);

}  // namespace airlight
