#pragma once
// What every sky pass on the device shares: its output, its view rays, its size.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/methods/method.h"
#include "core/plan/plan.h"

namespace airlight {

// The radiance buffer is carried under this key, so that a second plan can expose what the first one rendered.
inline constexpr std::string_view kRadianceKey = "frame radiance";

struct SkyTarget {
  BufferId radiance;    // shaders/shared/sky_output.glsl: radiance_out
  BufferId directions;  // the listed directions, or one unused
  Extent grid;
  std::uint32_t projection = 0;  // kProjection
};

// The buffer of a picture: carried under that key, but for a tile's.
BufferDesc radiance_buffer(const View& view, std::size_t bytes);

// What of the camera's picture the view shows.
Tile tile_of(const Scene& scene, const View& view);

// The grid of the camera's picture, or of its tile.
Extent picture_grid(const Scene& scene, const View& view);

// The key of a table that depends on the picture at hand; empty where no later plan needs it.
std::string picture_table_key(const View& view, std::string_view table);

// A buffer for LayerPasses::planes, and the constants beside the method's own that its pass takes.
BufferId add_layer_planes(Plan& plan, const Scene& scene, const Air& air, const View& view);
void add_layer_constants(std::vector<Specialization>& constants, const Scene& scene, const Air& air);

// A whole pass of that kind: what is the same in every method's is added to `pass`, whose push constants follow the
// grid's width and height.
LayerPasses add_layers_pass(Plan& plan, const Scene& scene, const Air& air, const View& view, PassDesc pass,
                            std::optional<ImageId> transmittance);

// Adds the buffers that a sky pass writes and reads for this view.
SkyTarget add_sky_target(Plan& plan, const Scene& scene, const View& view);

// Adds a sky pass whose pixels are little work, and a second one over those that the planet's edge crosses, if any. The
// pass: shaders/shared/horizon_pixels.glsl, which reads `directions`; its push constants begin with the grid's width
// and height.
void add_pass_with_edges(Plan& plan, const Scene& scene, const View& view, const SkyTarget& target, PassDesc pass);

}  // namespace airlight
