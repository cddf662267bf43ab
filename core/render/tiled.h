#pragma once
// A picture rendered tile by tile, never in memory as a whole: the same pixels as render() makes, bit for bit.

#include <functional>

#include "core/render/render.h"

namespace airlight {

// Rows of the picture from `y` on, whole in width.
struct Band {
  int y = 0;
  RadianceImage radiance;
  std::vector<Layer> layers;          // where they were asked for
  std::vector<std::string> left_out;  // as Rendering::left_out, known before the first band
};

struct TiledRequest {
  ImageSize tile;                   // its height is cut where a row of tiles would fill more than kBandBytes
  bool layers = false;              // of a method that has them
  std::function<void(Band&)> sink;  // from the top, to be emptied at will; what it throws is passed on
  std::function<bool(double done)> report = {};  // after each band, done in 0 to 1; empty: nobody listens
};

// The device's buffers for one tile, at most: what every device takes in one (Mesa's software device no more).
inline constexpr std::size_t kTileBytes = std::size_t{128} << 20;
// The host's for one band.
inline constexpr std::size_t kBandBytes = std::size_t{256} << 20;

// The bytes that one pixel takes in the greatest of a tile's buffers on the device, and on the host.
std::size_t tile_pixel_bytes(const Scene& scene, bool layers);
std::size_t band_pixel_bytes(const Scene& scene, bool layers);

// Whole rows that make a tile of about 32 MiB of radiance: what a picture is cut into when nobody says how.
ImageSize usual_tile(const Scene& scene, bool layers);

// Of a method on the device. The rendering comes without pixels; a fault ends it after the band that has it.
Rendering render_tiled(const DeviceOnDemand& device, const Scene& scene, const TiledRequest& request);

}  // namespace airlight
