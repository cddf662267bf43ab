#pragma once
// The parts of a preset, each read by a file of its own; resolve() puts them together. What is wrong is reported.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/curve_reader.h"
#include "core/scene/key_frames.h"
#include "core/scene/method_info.h"
#include "core/scene/section.h"

namespace airlight {

// `media`. `spectra` gets the curves of each medium.
std::vector<Medium> read_media(const Section& root, const Planet& planet, CurveReader& curves, SceneSpectra& spectra);

// `planet.terrain`, and the planet's maps; nothing where it has none. File names come out absolute. `albedo`: over the
// wavelength.
std::optional<Terrain> read_terrain(const Section& planet, const Planet& on, CurveReader& curves, Curve& albedo);
std::optional<GroundMap> read_ground_map(const Section& planet);

// `scene.spheres`. `albedos`: a curve for each.
std::vector<Sphere> read_spheres(const Section& root, CurveReader& curves, std::vector<Curve>& albedos);

// What goes by the projection: `camera`, the picture's size, which a map's layout binds, and `bloom`: none where it
// would stop at the edges of a map that is cut.
Camera read_camera(const Section& root);
ImageSize read_image(const Section& root, const Camera& camera);
Bloom read_bloom(const Section& root, const Camera& camera);

// `sequence`; nothing where the preset has none. What the keys hold is looked at as numbers alone here.
std::optional<KeyFrames> read_key_frames(const Section& root, std::span<const MethodInfo> methods);

// Calls `use` with the preset at each of its key frames, without `sequence`: that frame's keys put in, each value still
// with the line where it stands. Of a preset whose `sequence` read_key_frames() found good. Throws InputError for a
// pointer that leads nowhere.
void for_each_key_frame(const Preset& preset, const std::function<void(const Preset& frame)>& use);

// Reports what terrain, a ground by maps and spheres do not go with: methods that do not know them, one another, curves
// over the wavelength. `curves`: the preset has some.
void refuse_misfits(const Section& root, const Scene& scene, bool curves, std::span<const MethodInfo> methods);

}  // namespace airlight
