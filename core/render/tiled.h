#pragma once
// A picture rendered tile by tile, never in memory as a whole: the same pixels as render() makes, bit for bit. What
// needs to be known of the whole picture first (exposure, bloom) is measured by going through it once before.

#include <functional>

#include "core/render/render.h"

namespace airlight {

// Rows of the picture from `y` on, whole in width.
struct Band {
  int y = 0;
  Rendering rows;  // its pixels; exposure where that is known before the last band; left_out
};

// `count` rows of a picture's pixels from `first` on, with whatever stands beside them.
RadianceImage rows_of(const RadianceImage& whole, int first, int count);
Rendering rows_of(const Rendering& whole, int first, int count);

struct TiledRequest {
  ImageSize tile;                   // its height is cut where a row of tiles would fill more than kBandBytes
  RenderRequest picture;            // as of render()
  bool exposure_first = false;      // the bands are to come with their exposure
  bool past_faults = false;         // go on where a band holds what is no radiance
  std::function<void(Band&)> sink;  // from the top, to be emptied at will; what it throws is passed on
  std::function<void(double done)> report = {};  // after each band, done in 0 to 1; empty: nobody listens
};

// The device's buffers for one tile, at most: what every device takes in one (Mesa's software device no more).
inline constexpr std::size_t kTileBytes = std::size_t{128} << 20;
// The host's for one band, and the device's for its rows.
inline constexpr std::size_t kBandBytes = std::size_t{64} << 20;

// The bytes that one pixel takes in the greatest of a tile's buffers on the device, and on the host.
std::size_t tile_pixel_bytes(const Scene& scene, bool layers);
std::size_t band_pixel_bytes(const Scene& scene, bool layers);

// Whole rows that make a tile of about 32 MiB of radiance: what a picture is cut into when nobody says how.
ImageSize usual_tile(const Scene& scene, bool layers);

// The rendering comes without pixels; a fault ends it before the band that has it, unless past_faults. A method on the
// host renders the whole picture first, and its rows are handed on in bands.
Rendering render_tiled(const DeviceOnDemand& device, const Scene& scene, const TiledRequest& request);

}  // namespace airlight
