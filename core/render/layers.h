#pragma once
// A picture's light apart by where it comes from, and what compositing asks for beside it.

#include <string>
#include <vector>

#include "core/gpu/executor.h"
#include "core/methods/method.h"
#include "core/post/post.h"
#include "core/render/timings.h"
#include "core/scene/scene.h"

namespace airlight {

// Planes of floats, one after the other, each row by row from the top. Outside a fisheye's circle all are 0.
struct Layer {
  std::string name;       // before the dot of the EXR's channels: "rayleigh"
  std::string channels;   // a letter each: "RGB", "XYZ", "Z"
  bool is_light = false;  // one of those whose sum is the picture
  std::vector<float> planes = {};

  Layer like() const { return {name, channels, is_light, {}}; }
};

// Depth where a ray meets neither ground nor air, km: finite, and beyond all that is there.
inline constexpr float kNoDistance = 1e10F;

// The layers of a scene's picture, without planes: the single scattering of each medium that scatters, by the medium's
// name as far as a channel can be called so; multiple (scattered more than once), sun (the disc), ground (reflected by
// it, seen through the air), all W/(m2 sr); transmittance to the ground or to space; depth, the distance to the ground
// or to where the ray leaves the air, km; N, the ground's normal in the preset's frame, 0 where there is none.
std::vector<Layer> layers_of(const Scene& scene);

// Why this scene's picture cannot be told apart though its method has layers: keys of render that its march alone
// knows. Empty: it can.
std::string layers_refusal(const Scene& scene);

// The scene as its picture is rendered together with its layers.
Scene kept_apart(Scene scene);

// The methods that tell layers apart, for messages: "nested, march, sky-view, orders".
std::string methods_with_layers();

// The layers of one tile, by a method that has them. `kept_as`: as View::kept_as. Adds to `timings`.
std::vector<Layer> render_layers(Executor& executor, const Scene& scene, const Tile& tile, const std::string& kept_as,
                                 const Timings& timings);

// The layers of the whole picture, on the device in bands of at most kLayerBandBytes.
inline constexpr std::size_t kLayerBandBytes = std::size_t{32} << 20;
std::vector<Layer> render_layers(Executor& executor, const Scene& scene, const Timings& timings);

// What is not finite, or negative where that means nothing; `width`: of the rows. `signed_colours`: a channel of a
// colour may be negative, its luminance not.
Statistics layer_statistics(const Layer& layer, int width, bool signed_colours = false);

}  // namespace airlight
