#pragma once
// What happens to a picture after the sky pass: the sun's disc, statistics, bloom, the tone curve. All append passes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

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
bool add_sun_disc(Plan& plan, const Scene& scene, std::optional<ImageId> transmittance, const Picture& picture);

// Row statistics of a picture or a table, for summarize(). `key` as for any buffer of a plan.
BufferId add_picture_statistics(Plan& plan, const Picture& picture);
BufferId add_table_statistics(Plan& plan, ImageId table);

struct Statistics {
  double log_average_luminance = 0.0;  // geometric mean over lit texels; 0 where none is lit
  double max_luminance = 0.0;
  std::uint64_t lit = 0;
  std::uint64_t not_finite = 0;
  std::uint64_t negative = 0;
  std::uint32_t first_bad_x = 0;  // of not_finite or negative, when either is not 0
  std::uint32_t first_bad_y = 0;

  bool sound() const { return not_finite == 0 && negative == 0; }
};

// `rows`: the contents of a statistics buffer; `width`: of the picture or table.
Statistics summarize(std::span<const std::byte> rows, std::uint32_t width);

// The linear factor before the tone curve: the preset's, or the one that brings the log-average luminance to 0.18.
double exposure_for(const Display& display, const Statistics& statistics);

// Whether any pixel exceeds the bloom's threshold; where none does, bloom is black and need not run.
bool bloom_glows(const Bloom& bloom, const Statistics& statistics, double exposure);

// Bloom of a picture as a finished chain, scene-linear, before `intensity` [J14]: an image of the chain's first level,
// which whoever wants it samples at its own pixels. Its width is an angle: the chain starts on a grid of 1/12 degree a
// texel (720 lines over 60 degrees), whatever the resolution.
ImageId add_bloom(Plan& plan, const Scene& scene, const Picture& picture, double exposure);

// The chain at the picture's own pixels, for who reads it on the host: four floats a pixel.
BufferId add_bloom_picture(Plan& plan, const Scene& scene, const Picture& picture, ImageId bloom);

// (picture + intensity x bloom) x exposure through the GPU tone curve, sRGB-encoded: four 16-bit channels a pixel.
// `bloom`: of add_bloom().
BufferId add_tonemap(Plan& plan, const Scene& scene, const Picture& picture, std::optional<ImageId> bloom,
                     double exposure);

}  // namespace airlight
