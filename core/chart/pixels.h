#pragma once
// The pixels of a picture that are compared with the truth: an even lattice, since the truth of each pixel is costly.

#include <cstddef>
#include <span>
#include <vector>

#include "core/measure/metrics.h"
#include "core/methods/method.h"
#include "core/scene/scene.h"
#include "core/stage/stage.h"

namespace airlight::chart {

struct PixelSet {
  std::vector<std::size_t> places;           // y * width + x
  std::vector<Direction> directions;         // of their centres
  std::vector<measure::RegionBits> regions;  // measure::Region
};

// At most `columns` x `rows` pixels of the scene's picture; those outside a fisheye's circle are left out.
PixelSet lattice(const Scene& scene, int columns, int rows);

// Without the pixels that the edge of a thing crosses: the truth is traced at points, and such a pixel is a mean.
PixelSet without_edges_of_things(const Stage& stage, const PixelSet& pixels);

// The judged pixels: those of the sky, or every pixel where the camera stands above the air, the picture has no sky or
// things stand in the scene.
bool judges_whole_picture(const Scene& scene, const PixelSet& pixels);
PixelSet judged(const Scene& scene, const PixelSet& pixels);

// RGB of those pixels, three values each, from a picture of four values a pixel.
std::vector<float> values_at(std::span<const float> rgba, const PixelSet& pixels);

}  // namespace airlight::chart
