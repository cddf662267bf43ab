#pragma once
// Parts that all sky passes on the device share: output, view rays, size.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/methods/method.h"
#include "core/plan/plan.h"

namespace airlight {

// The radiance buffer is carried under this key, so that a second plan can expose the first one's picture.
inline constexpr std::string_view kRadianceKey = "frame radiance";

struct SkyTarget {
  BufferId radiance;    // shaders/shared/sky_output.glsl: radiance_out
  bool adds = false;    // to what the buffer holds
  BufferId directions;  // the listed directions, or one unused
  Extent grid;
  std::uint32_t projection = 0;  // kProjection
  std::uint32_t vectors = 1;     // of each direction or pixel
};

// The radiance buffer of a picture, carried under that key; a tile's is not carried.
BufferDesc radiance_buffer(const View& view, std::size_t bytes);

// The part of the camera's picture that the view shows.
Tile tile_of(const Scene& scene, const View& view);

// The grid of the camera's picture, or of its tile.
Extent picture_grid(const Scene& scene, const View& view);

// The key of a table that depends on the picture; empty where no later plan needs the table.
std::string picture_table_key(const View& view, std::string_view table);

// Vectors of each listed direction: radiance, transmittance and, where the view asks for them, Q and U.
std::size_t vectors_of(const View& view);

// A buffer for LayerPasses::planes, and the constants that its pass takes beside the method's own.
BufferId add_layer_planes(Plan& plan, const Part& part, const View& view);
void add_layer_constants(std::vector<Specialization>& constants, const Part& part);

// Adds the buffers that a sky pass of this view writes and reads, but for a canvas that is given.
SkyTarget add_sky_target(Plan& plan, const Scene& scene, const View& view, const std::optional<Canvas>& canvas = {});

// Adds a sky pass with little work per pixel, and a second one over the pixels that the planet's edge crosses, if any.
// The pass uses shaders/shared/horizon_pixels.glsl and reads `directions`; its push constants begin with the grid's
// width and height.
void add_pass_with_edges(Plan& plan, const Part& part, const View& view, const SkyTarget& target, PassDesc pass);

}  // namespace airlight
