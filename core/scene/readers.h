#pragma once
// The parts of a preset, each read in a file of its own; resolve() puts them together. They report problems.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/curve_reader.h"
#include "core/scene/key_frames.h"
#include "core/scene/method_info.h"
#include "core/scene/section.h"

namespace airlight {

std::vector<Medium> read_media(const Section& root, const Planet& planet);

// Reads `planet.refraction`; none where the preset has none or n - 1 is 0. `on` has the planet's size.
std::optional<Refraction> read_refraction(const Section& planet, const Planet& on, const std::vector<Medium>& media);

// Reads `planet.terrain`, and the planet's maps; none where the preset has none. File names become absolute.
std::optional<Terrain> read_terrain(const Section& planet, const Planet& on);
std::optional<GroundMap> read_ground_map(const Section& planet);

std::vector<Sphere> read_spheres(const Section& root);

// Reads `clouds` and the files that they name. A layer is added to `media`.
std::vector<Cloud> read_clouds(const Section& root, const Planet& planet, std::vector<Medium>& media);

// Reads `moon`; none where the preset has none. `sun`, `camera`, `planet`: of the scene, as read.
std::optional<Moon> read_moon(const Section& root, const Scene& scene);

// Lets a moon before the sun cover it. Its light loses the covered share, by the law of the limb's darkening.
void cover_the_sun(Sun& sun, const Moon& moon);

// Share of a disc's light that another, whose centre is `apart` from its own, leaves. All in one unit; discs so small
// that they are flat.
double uncovered_share(double radius, double limb_darkening, double cover_radius, double apart);

// The moon's irradiance in the scene's channels, once the sun's is known there.
Spectrum moon_irradiance(const Moon& moon, const Sun& sun, const BandColours& colours);

// Read `night_sky` and `stars`; none where the preset has none.
std::optional<NightSky> read_night_sky(const Section& root);
std::optional<Stars> read_stars(const Section& root);

// Reads the parts that depend on the projection: `camera`, the picture's size, which a map's layout restricts, and
// `bloom`, which is none where it would stop at the edges of a map that is cut.
Camera read_camera(const Section& root);
ImageSize read_image(const Section& root, const Camera& camera);
Bloom read_bloom(const Section& root, const Camera& camera);

// A scene is checked for each of them.
inline constexpr std::size_t kMostKeyFrames = 20000;

// Reads `sequence`; none where the preset has none. Here the keys' values are only checked to be numbers.
std::optional<KeyFrames> read_key_frames(const Section& root, std::span<const MethodInfo> methods);

// A key frame and its place in the preset.
struct FrameValues {
  std::string pointer;
  const std::map<std::string, std::vector<double>, std::less<>>& values;
};

// Calls `use` with the preset at each of its key frames, without `sequence`: the values that read_key_frames() took are
// put in, each with its own line. Throws InputError for a pointer that leads nowhere.
void for_each_key_frame(const Preset& preset, const KeyFrames& sequence,
                        const std::function<void(const Preset& frame, const FrameValues& of)>& use);

// Reports things that the scene's method does not support.
void refuse_misfits(const Section& root, const Scene& scene, std::span<const MethodInfo> methods);

}  // namespace airlight
