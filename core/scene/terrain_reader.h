#pragma once
// `planet.terrain` of a preset.

#include <optional>

#include "core/scene/section.h"

namespace airlight {

// Nothing where the planet has none. File names come out absolute.
std::optional<Terrain> read_terrain(const Section& root, const Planet& on);

}  // namespace airlight
