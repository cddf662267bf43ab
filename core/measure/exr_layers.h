#pragma once
// The layers of an EXR, as the comparison needs them.

#include <optional>
#include <string>
#include <vector>

#include "core/measure/luminance.h"
#include "core/measure/view_geometry.h"

namespace airlight::measure {

// Channels of one layer in one part. The layer is the part of a channel's name before the last dot. Channels without a
// dot belong to the main picture in the first part, and to a layer of the part's name in the others.
struct ExrLayer {
  std::string name;       // empty: the main picture
  std::string part_name;  // empty: the part has none
  int part = 0;
  PixelFrame frame;
  std::vector<std::string> channels;    // "R"; colours first, then alpha, depth, the rest by name
  std::vector<std::string> full_names;  // of the same: "bloom.R"
};

struct LayeredExr {
  std::string file;
  std::vector<ExrLayer> layers;
  Chromaticities chromaticities = kBt709;
  std::optional<std::string> preset;
  std::string version;  // of the airlight that wrote it; empty: another program did
};

// Throws InputError: missing, a directory, not an EXR, damaged, deep data, channels of fewer samples than pixels.
LayeredExr read_exr_layers(const std::string& file);

// An empty name means the main picture, or the only layer. Throws InputError that lists the existing layers.
const ExrLayer& find_layer(const LayeredExr& exr, const std::string& name);

// Channels of the layer, by their index there. Throws InputError when the file is damaged or cut short.
std::vector<std::vector<float>> read_exr_channels(const LayeredExr& exr, const ExrLayer& layer,
                                                  const std::vector<std::size_t>& places);

}  // namespace airlight::measure
