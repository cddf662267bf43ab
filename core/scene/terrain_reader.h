#pragma once
// `planet.terrain` of a preset.

#include <optional>

#include "core/scene/curve_reader.h"

namespace airlight {

// Nothing where the planet has none. File names come out absolute. `albedo`: over the wavelength.
std::optional<Terrain> read_terrain(const Section& root, const Planet& on, CurveReader& curves, Curve& albedo);

}  // namespace airlight
