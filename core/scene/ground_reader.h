#pragma once
// `planet.albedo_map` and `planet.ocean` of a preset.

#include <optional>

#include "core/scene/section.h"

namespace airlight {

// Nothing where the planet has neither. File names come out absolute.
std::optional<GroundMap> read_ground_map(const Section& root);

}  // namespace airlight
