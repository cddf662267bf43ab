#pragma once
// A terrain's maps in a plan.

#include "core/plan/plan.h"
#include "core/things/terrain.h"

namespace airlight {

struct TerrainBuffers {
  BufferId heights;
  BufferId shadows;
  BufferId colours;
};

// Adds the heights, for tracing, as a buffer of this name (shaders/shared/terrain_maps.glsl).
BufferId add_terrain_heights(Plan& plan, const char* name, const physics::HostTerrain& terrain);

// Adds all maps, for tracing and lighting; `terrain` has its shadow.
TerrainBuffers add_terrain(Plan& plan, const physics::HostTerrain& terrain);

}  // namespace airlight
