#pragma once
// The one door from a scene to what renders it.

#include "core/stage/stage.h"

namespace airlight {

// Makes a scene ready to be rendered by its method. Of another stage, as that of the frame before or of another
// quality, all is taken over that is equal: air, wavelengths, terrain and its shadow, maps.
Stage ready(const Scene& scene);
Stage ready(const Scene& scene, const Stage& like);

// The same with these wavelengths as its parts; the scene must have spectra.
Stage ready_at(const Scene& scene, const Nodes& nodes, const Stage& like);

// Part `g` of such a stage as a scene of its own, whose three channels are wavelengths, with the stage's night sky in
// them. `group`: the part's scene, whose seed may be another.
Stage ready_part(Scene group, const Stage& listed, std::size_t g);

// Whether rays are bent in the scene as it is rendered: its air does, its method does, and no things stand in it, to
// whose true distances rays are straight.
bool bends_light(const Scene& scene);

}  // namespace airlight
