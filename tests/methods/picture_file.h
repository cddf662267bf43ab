#pragma once
// Reads EXRs and small JSON files for the picture tests.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/radiance_image.h"
#include "core/measure/view_geometry.h"
#include "core/scene/scene.h"

namespace airlight::test {

// R, G and B of a layer ("" for the picture itself) of a float EXR, alpha 1; absent where the file has no such layer.
std::optional<RadianceImage> read_layer(const std::filesystem::path& file, std::string_view layer = "");

// A preset resolved by the methods of the registry.
Scene scene_from_file(const std::filesystem::path& file);

// Numbers by their path in a JSON object of objects: "sky/median".
std::map<std::string, double> numbers_in(const std::filesystem::path& file);

struct RegionError {
  std::string region;
  std::size_t values = 0;  // pixels times channels
  double mean = 0.0;
  double median = 0.0;
  double p95 = 0.0;
  double max = 0.0;
};

// The picture with the reference's pixels where the planet's edge crosses them: a reference traced at the pixels'
// middles has no mean over their area. The tests HorizonPixels check those pixels.
RadianceImage without_edge(const Scene& scene, RadianceImage picture, const RadianceImage& reference);

// Relative errors as in core/measure, channels pooled, for each region of the view that has any pixel.
std::vector<RegionError> region_errors(const Scene& scene, const RadianceImage& a, const RadianceImage& b);

}  // namespace airlight::test
