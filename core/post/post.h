#pragma once
// What happens to a picture after the sky pass: the sun's disc, statistics, bloom, the tone curve. All append passes.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/air/air.h"
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

// The chain at the pixels of the picture or of a band of its rows, for who reads it on the host: four floats a pixel.
BufferId add_bloom_picture(Plan& plan, const Scene& scene, const Picture& picture, ImageId bloom);

// (picture + intensity x bloom) x exposure through the GPU tone curve, sRGB-encoded: four 16-bit channels a pixel.
// `picture`: whole or a band of rows; `bloom`: of add_bloom().
BufferId add_tonemap(Plan& plan, const Scene& scene, const Picture& picture, std::optional<ImageId> bloom,
                     double exposure);

}  // namespace airlight
