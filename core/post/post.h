#pragma once
// A picture's post-processing after the sky pass: the sun's disc, statistics, bloom, the tone curve. All append passes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/physics/physics.h"
#include "core/plan/plan.h"
#include "core/scene/scene.h"
#include "core/stage/stage.h"

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

// Adds the sun's disc where the camera can see it. Returns false, and adds nothing, where the disc is switched off,
// outside the picture or tile, or wholly behind the planet. The disc is seen through the method's transmittance table;
// where there is none, one is added here.
// `colours`: what its channels add to the picture's.
bool add_sun_disc(Plan& plan, const Part& part, std::optional<ImageId> transmittance, const Picture& picture,
                  const std::array<Rgb, 3>& colours = kAsTheyAre);

// Whether add_sun_disc() would add the disc.
bool sun_disc_shows(const Scene& scene, const Picture& picture);

// A table of transmittance that is fine enough for the disc.
ImageId add_disc_transmittance(Plan& plan, const Air& air);

// Row statistics of a picture, for summarize(). `brightest`: from brightest_metered(). `signed_colours`: channels may
// be negative, luminance not.
BufferId add_picture_statistics(Plan& plan, const Picture& picture, double brightest, bool signed_colours = false);

struct Statistics {
  double metered_luminance = 0.0;  // geometric mean, each texel weighed by the root of its luminance; 0: all is black
  double max_luminance = 0.0;
  std::uint64_t not_finite = 0;
  std::uint64_t negative = 0;
  std::uint64_t outside = 0;      // for signed colours: pixels with a negative channel, outside the working space
  std::uint32_t first_bad_x = 0;  // of not_finite or negative, if either is above 0
  std::uint32_t first_bad_y = 0;

  bool sound() const { return not_finite == 0 && negative == 0; }
};

// `rows`: the contents of a statistics buffer; `width`: of the picture or table.
Statistics summarize(std::span<const std::byte> rows, std::uint32_t width);

// The linear factor before the tone curve: the preset's, or that of an eye adapted to the picture's meter
// (exposure.cpp), times the compensation. For metering of day or a frame see core/render/metering.h; here both are
// metered on the picture itself.
double exposure_for(const Scene& scene, const Statistics& statistics);

// Upper limit of the meter's luminance: a white surface in full sunlight above the air. With it neither the sun's disc
// nor the part of it in the picture moves the exposure.
double brightest_metered(const Scene& scene);

// Whether there is bloom to see: a light before the camera (`glares`), or, for a chain, any pixel above the threshold.
bool bloom_glows(const Scene& scene, bool glares, const Statistics& statistics, double exposure);

// Why there is no bloom, for people.
std::string no_bloom(const Scene& scene);

// Points of the sun's disc as the camera sees them through the air, their sum first, for the glare around them
// (physics/glare.glsl).
std::vector<physics::GlarePoint> glare_points(const Part& part);

// The points on the device.
struct GlareSources {
  BufferId points;
  std::uint32_t count = 0;
};

GlareSources add_glare_sources(Plan& plan, const std::vector<physics::GlarePoint>& points);

// Whether any light of the disc reaches the camera past the planet, from before the camera.
bool sun_glares(const Part& part);

// Bloom, scene-linear, before `intensity`, as passes that show it read it: a finished chain, or sources of glare.
using Glow = std::variant<ImageId, GlareSources>;

// The bloom's finest grid: the picture at 1/12 degree a texel (720 lines over 60 degrees), whatever the resolution, so
// that the glow's width is an angle. It is never finer than the picture.
ImageId add_bloom_base(Plan& plan, const Scene& scene, const Picture& picture);

// Bloom of a picture as a finished chain, scene-linear, before `intensity` [J14]: an image of the chain's first level,
// to be sampled at the picture's own pixels. `base`: the finest grid.
ImageId add_bloom(Plan& plan, const Scene& scene, ImageId base, double exposure);

// The glow at the pixels of the picture or of a band of its rows, for the host: four floats a pixel. Glare needs the
// plan's scene data to be of that band.
BufferId add_glow_picture(Plan& plan, const Scene& scene, const Picture& picture, const Glow& glow);

// (picture + intensity x glow) x exposure through the GPU tone curve, sRGB-encoded: four 16-bit channels a pixel.
// `picture`: whole or a band of rows.
BufferId add_tonemap(Plan& plan, const Scene& scene, const Picture& picture, const std::optional<Glow>& glow,
                     double exposure);

// Angle of a pixel at the picture's centre, radians.
double pixel_angle(const Scene& scene);

// Radius by which a pixel's own width rounds off a source's glare, radians.
double glare_pixel_blur(const Scene& scene);

}  // namespace airlight
