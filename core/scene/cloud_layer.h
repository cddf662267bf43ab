#pragma once
// A cloud that is even all around the planet: a medium of the air, which every method renders.

#include "core/scene/section.h"

namespace airlight {

// Reads base, top, optical depth or water, and the density over the height of a layer, whose phase function and albedo
// are those of `matter`. Reports a base that is not below the top, a top outside the air, neither depth nor water, or
// both. The density is 1 at its highest; the name is empty.
Medium read_cloud_layer(const Section& section, const Planet& planet, const Cloud& matter);

}  // namespace airlight
