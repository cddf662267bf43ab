#pragma once
// The one way of a picture from scene to sink: bands of its rows go through sky, disc, statistics, exposure, bloom,
// tone curve and layers. A picture that fits into memory is one band. The pixels are the same bit for bit, whatever the
// bands and tiles.

#include <functional>

#include "core/render/render.h"

namespace airlight {

// Rows of the picture from `y` on, whole in width.
struct Band {
  int y = 0;
  Rendering rows;  // its pixels; left_out; the exposure where it is known before the last band
};

struct BandsRequest {
  // A band is a row of such tiles, of at most kBandBytes (tile_sizes.h). None: one band.
  std::optional<ImageSize> tile = {};
  RenderRequest picture;            // as of render()
  bool exposure_first = false;      // the bands must have their exposure; one band has it anyway
  bool is_last = false;             // no picture is to follow soon: what is done with on the device is freed
  bool past_faults = false;         // continue where a band holds values that are no radiance
  std::function<void(Band&)> sink;  // gets bands from the top and may empty them; its exceptions are passed on
};

// Whether the request asks for a bloom chain: it is made of the whole picture, and no tiles have it.
bool needs_whole_picture(const Scene& scene, const RenderRequest& request);

// The rendering comes without pixels: the sink has them. A fault ends it before the faulty band, unless past_faults. A
// method on the host renders the whole picture first and passes its rows on in bands, and so do the wavelengths of a
// spectrum. Throws as render() does.
Rendering render_bands(const DeviceOnDemand& device, const Stage& stage, const BandsRequest& request);

// The same of a picture of which the pixels in `given` are made already, with its disc.
Rendering render_bands(const DeviceOnDemand& device, const Stage& stage, const BandsRequest& request, Rendering given);

}  // namespace airlight
