#include "core/render/pixels.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace airlight {
namespace {

// Rows of planes that stand one after the other, each as large as the picture.
std::vector<float> rows_of(const std::vector<float>& planes, std::size_t count, const Tile& rows) {
  std::vector<float> part;
  const std::size_t plane = planes.size() / count;
  for (std::size_t i = 0; i < count; ++i) {
    const auto begin = planes.begin() + static_cast<std::ptrdiff_t>(i * plane + pixels_of(rows.width, rows.y));
    part.insert(part.end(), begin, begin + static_cast<std::ptrdiff_t>(pixels_of(rows)));
  }
  return part;
}

}  // namespace

void put(RadianceImage& band, std::span<const std::byte> tile_bytes, const Tile& tile) {
  const std::size_t row = 4 * sizeof(float) * static_cast<std::size_t>(tile.width);
  for (int y = 0; y < tile.height; ++y) {
    std::memcpy(band.rgba.data() + 4 * (pixels_of(band.width, y) + static_cast<std::size_t>(tile.x)),
                tile_bytes.data() + static_cast<std::size_t>(y) * row, row);
  }
}

void put(std::vector<Layer>& layers, const Tile& band, const std::vector<Layer>& tile_layers, const Tile& tile) {
  const std::size_t plane = pixels_of(band);
  const std::size_t first = pixels_of(band.width, tile.y - band.y) + static_cast<std::size_t>(tile.x);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::size_t channels = layers[i].channels.size();
    layers[i].planes.resize(plane * channels);
    const float* from = tile_layers[i].planes.data();
    for (std::size_t c = 0; c < channels; ++c) {
      for (int y = 0; y < tile.height; ++y, from += tile.width) {
        std::copy(from, from + tile.width, layers[i].planes.data() + c * plane + first + pixels_of(band.width, y));
      }
    }
  }
}

Pixels rows_of(const Pixels& whole, const Tile& rows) {
  const auto first = static_cast<std::ptrdiff_t>(4 * pixels_of(rows.width, rows.y));
  const auto end = first + static_cast<std::ptrdiff_t>(4 * pixels_of(rows));
  const auto cut = [&](const auto& values) {
    return values.empty() ? values
                          : std::remove_cvref_t<decltype(values)>(values.begin() + first, values.begin() + end);
  };
  const auto image = [&](const RadianceImage& all) { return RadianceImage{rows.width, rows.height, cut(all.rgba)}; };
  Pixels part;
  part.radiance = image(whole.radiance);
  part.standard_error = whole.standard_error ? std::optional(image(*whole.standard_error)) : std::nullopt;
  part.bloom = whole.bloom ? std::optional(image(*whole.bloom)) : std::nullopt;
  part.encoded = cut(whole.encoded);
  for (const Layer& layer : whole.layers) {
    part.layers.push_back(layer.like());
    part.layers.back().planes = rows_of(layer.planes, layer.channels.size(), rows);
  }
  if (whole.spectrum) {
    part.spectrum = whole.spectrum->like();
    for (const std::vector<float>& plane : whole.spectrum->planes) {
      part.spectrum->planes.push_back(rows_of(plane, 1, rows));
    }
  }
  return part;
}

}  // namespace airlight
