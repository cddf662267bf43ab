#pragma once
// A picture rendered tile by tile, never in memory as a whole, with the same pixels as render()'s, bit for bit. A first
// pass over the picture measures its exposure where that must be known.

#include <functional>

#include "core/render/render.h"

namespace airlight {

// Rows of the picture from `y` on, whole in width.
struct Band {
  int y = 0;
  Rendering rows;  // its pixels; left_out; the exposure where it is known before the last band
};

// `count` rows from `first` on, of a picture's pixels and of all further planes.
RadianceImage rows_of(const RadianceImage& whole, int first, int count);
Rendering rows_of(const Rendering& whole, int first, int count);

struct TiledRequest {
  ImageSize tile;                   // its height is cut where a row of tiles would fill more than kBandBytes
  RenderRequest picture;            // as of render()
  bool exposure_first = false;      // the bands must have their exposure
  bool past_faults = false;         // continue where a band holds values that are no radiance
  std::function<void(Band&)> sink;  // gets bands from the top and may empty them; its exceptions are passed on
  std::function<void(double done)> report = {};  // after each band, with the share done, 0 to 1; may be empty
};

// Most bytes in a device's buffer for one tile: the most that every device takes (Mesa's software device takes no
// more).
inline constexpr std::size_t kTileBytes = std::size_t{128} << 20;
// Most bytes of one band on the host, and of its rows on the device.
inline constexpr std::size_t kBandBytes = std::size_t{64} << 20;

// Bytes of one pixel in the greatest of a tile's buffers on the device, and of a band's on the host.
std::size_t tile_pixel_bytes(const Stage& stage, bool layers);
std::size_t band_pixel_bytes(const Stage& stage, bool layers);

// Size of a default tile: whole rows with about 32 MiB of radiance.
ImageSize usual_tile(const Stage& stage, bool layers);

// Whether the request asks for a bloom chain: it is made of the whole picture, and no tiles have it.
bool needs_whole_picture(const Scene& scene, const RenderRequest& request);

// The rendering comes without pixels. A fault ends it before the faulty band, unless past_faults. A method on the host
// renders the whole picture first and passes its rows on in bands.
Rendering render_tiled(const DeviceOnDemand& device, const Stage& stage, const TiledRequest& request);

}  // namespace airlight
