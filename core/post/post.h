#pragma once
// What happens to a picture after the sky pass: the sun's disc, statistics, bloom, the tone curve. All append passes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/air/air.h"
#include "core/physics/physics.h"
#include "core/plan/plan.h"
#include "core/scene/scene.h"

namespace airlight {

// A picture on the device, or a tile of it: a vec4 for each pixel, rows from the top.
struct Picture {
  BufferId buffer;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t x = 0;  // of a tile's upper left pixel
  std::uint32_t y = 0;
};

Picture picture_of(BufferId buffer, const Tile& tile);

// Adds the sun's disc where the camera can see it. Returns false, and adds nothing, where it cannot: switched off,
// outside the picture or tile, or wholly behind the planet. The disc is seen through the method's transmittance table,
// or through one added here where the method has none.
bool add_sun_disc(Plan& plan, const Scene& scene, const Air& air, std::optional<ImageId> transmittance,
                  const Picture& picture);

// Whether add_sun_disc() adds it.
bool sun_disc_shows(const Scene& scene, const Picture& picture);

// The table of transmittance that is enough for the disc.
ImageId add_disc_transmittance(Plan& plan, const Air& air);

// Row statistics of a picture, for summarize(). `brightest`: of brightest_metered(). `signed_colours`:
// channels may be negative, luminance not.
BufferId add_picture_statistics(Plan& plan, const Picture& picture, double brightest, bool signed_colours = false);

struct Statistics {
  double metered_luminance = 0.0;  // geometric mean, each texel weighed by the root of its luminance; 0: all is black
  double max_luminance = 0.0;
  std::uint64_t not_finite = 0;
  std::uint64_t negative = 0;
  std::uint64_t outside = 0;      // of signed colours, pixels with a negative channel: outside the working space
  std::uint32_t first_bad_x = 0;  // of not_finite or negative, when either is not 0
  std::uint32_t first_bad_y = 0;

  bool sound() const { return not_finite == 0 && negative == 0; }
};

// `rows`: the contents of a statistics buffer; `width`: of the picture or table.
Statistics summarize(std::span<const std::byte> rows, std::uint32_t width);

// The linear factor before the tone curve: the preset's, or that of the eye adapted to what the picture's meter shows
// (exposure.cpp), and the compensation. Where day or a frame is to be metered, see core/render/metering.h: here both
// count as the picture itself.
double exposure_for(const Scene& scene, const Statistics& statistics);

// What is brighter counts as being so bright in the meter: a white surface in full sunlight above the air. Neither the
// sun's disc, nor what part of it is in the picture, moves the exposure then.
double brightest_metered(const Scene& scene);

// Whether there is bloom to see: a sun before the camera, or, of a chain, any pixel above the threshold.
bool bloom_glows(const Scene& scene, const Air& air, const Statistics& statistics, double exposure);

// Why there is none, for people.
std::string no_bloom(const Scene& scene);

// Points of the sun's disc as the camera sees them through the air, the sum of them all first, for the glare around
// them (physics/glare.glsl).
std::vector<physics::GlarePoint> glare_points(const Scene& scene, const Air& air);

// The same on the device.
struct GlareSources {
  BufferId points;
  std::uint32_t count = 0;
};

GlareSources add_glare_sources(Plan& plan, const std::vector<physics::GlarePoint>& points);

// Whether any light of the disc comes past the planet to the camera, from before it.
bool sun_glares(const Scene& scene, const Air& air);

// Bloom, scene-linear, before `intensity`, as the passes read it that show it: a finished chain, or sources of glare.
using Glow = std::variant<ImageId, GlareSources>;

// The bloom's finest grid: the picture at 1/12 degree a texel (720 lines over 60 degrees), whatever the resolution, so
// that the glow's width is an angle. Never finer than the picture.
ImageId add_bloom_base(Plan& plan, const Scene& scene, const Picture& picture);

// The same of a picture that is never whole: from bands of whole rows, to the last bit.
class BloomGathering {
 public:
  explicit BloomGathering(const Scene& scene);

  // The next band, from the top; `take` is given what the buffer then holds.
  BufferId add_band(Plan& plan, const Picture& band) const;
  void take(const Picture& band, std::span<const std::byte> sums);

  // After the last band.
  ImageId add_base(Plan& plan) const;

 private:
  struct Rows {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  Rows touched(const Picture& band) const;  // rows of the grid

  Extent picture_;
  Extent grid_;
  std::vector<float> sums_;  // four floats a texel, of the rows touched so far
};

// Bloom of a picture as a finished chain, scene-linear, before `intensity` [J14]: an image of the chain's first level,
// which whoever wants it samples at its own pixels. `base`: the finest grid. With a key it is kept for later plans.
ImageId add_bloom(Plan& plan, const Scene& scene, ImageId base, double exposure, const std::string& key = {});

// What add_bloom() of an earlier plan has left under this key.
ImageId add_kept_bloom(Plan& plan, const Scene& scene, const std::string& key);

// The glow at the pixels of the picture or of a band of its rows, for who reads it on the host: four floats a pixel.
// Glare wants the plan's scene data to be of that band.
BufferId add_glow_picture(Plan& plan, const Scene& scene, const Picture& picture, const Glow& glow);

// (picture + intensity x glow) x exposure through the GPU tone curve, sRGB-encoded: four 16-bit channels a pixel.
// `picture`: whole or a band of rows.
BufferId add_tonemap(Plan& plan, const Scene& scene, const Picture& picture, const std::optional<Glow>& glow,
                     double exposure);

// Angle of a pixel at the picture's centre, radians.
double pixel_angle(const Scene& scene);

// What a pixel's own width rounds a source's glare off by, radians.
double glare_pixel_blur(const Scene& scene);

}  // namespace airlight
