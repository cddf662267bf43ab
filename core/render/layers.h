#pragma once
// A picture's light kept apart by its origin, and further planes for compositing.

#include <string>
#include <vector>

#include "core/gpu/executor.h"
#include "core/methods/method.h"
#include "core/post/post.h"
#include "core/render/timings.h"
#include "core/scene/scene.h"

namespace airlight {

// What is kept apart beside a picture.
enum class LayerSet {
  none,
  light,   // all but Q and U
  stokes,  // these too, of a method that has them
};

// Planes of floats, one after the other, each row by row from the top. Outside a fisheye's circle all are 0.
struct Layer {
  std::string name;       // before the dot of the EXR's channels: "rayleigh"
  std::string channels;   // a letter each: "RGB", "XYZ", "Z"
  bool is_light = false;  // one of those whose sum is the picture
  bool is_signed = false;
  std::vector<float> planes = {};

  Layer like() const { return {name, channels, is_light, is_signed, {}}; }
};

// Depth where a ray meets neither ground nor air, km: finite, and beyond everything in the scene.
inline constexpr float kNoDistance = 1e10F;

// The layers of a stage's picture, without planes. Light, all in W/(m2 sr): the single scattering of each medium that
// scatters, named after the medium as far as a channel's name permits; multiple (scattered more than once), sun (the
// disc), ground (sent back by the ground and things, seen through the air). Others: transmittance to the ray's end;
// depth, the distance to the ground, to a thing or to where the ray leaves the air, km; N, the normal there in the
// preset's frame, 0 where there is none; Q and U of all light, as ProbeResult has them. Among clouds all light and the
// transmittance are seen through them, and three layers follow U: cloud, the light that clouds send; cloud_alpha, the
// share of what stands behind them that they hide; cloud_depth, the mean distance of what hides it, km.
std::vector<Layer> layers_of(const Stage& stage, LayerSet set);

// The methods that have layers, for messages.
std::string methods_with_layers();

// The layers of one tile, for a method that has them. `kept_as`: as View::kept_as. Adds to `timings`.
std::vector<Layer> render_layers(Executor& executor, const Stage& stage, LayerSet set, const Tile& tile,
                                 const std::string& kept_as, const Timings& timings);

// Counts values that are not finite, or negative in a layer where that is wrong; `width`: of the rows.
// `signed_colours`: a channel of a colour may be negative, its luminance not.
Statistics layer_statistics(const Layer& layer, int width, bool signed_colours = false);

}  // namespace airlight
