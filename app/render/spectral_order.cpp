#include "app/render/spectral_order.h"

#include <algorithm>

#include "app/cli/wavelengths.h"
#include "core/error.h"
#include "core/render/tiled.h"

namespace airlight::cli {
namespace {

constexpr const char* kOption = "render: --spectral";

void require_fit(const Scene& scene, std::size_t wavelengths) {
  const auto pixels = static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height);
  const std::size_t most = std::min(kMostSpectralSamples / wavelengths, kTileBytes / (4 * sizeof(float)));
  if (pixels > most) {
    throw InputError(std::string(kOption) + ": " + std::to_string(scene.image.width) + "x" +
                     std::to_string(scene.image.height) + " are " + std::to_string(pixels) + " pixels; a spectrum of " +
                     std::to_string(wavelengths) + " wavelengths is kept in memory for at most " +
                     std::to_string(most) + " of them; give a smaller --size or a larger step");
  }
}

}  // namespace

std::optional<Nodes> spectral_wavelengths(const RenderOrder& given, const Scene& scene, const Targets& targets) {
  if (!given.spectral) {
    return std::nullopt;
  }
  Nodes nodes = wavelengths_from(*given.spectral, kOption);
  require_spectra(scene, kOption);
  if (targets.exr.empty()) {
    throw InputError(std::string(kOption) + ": spectra stand in the EXR, and none is written; give -o FILE.exr too");
  }
  const struct {
    bool given;
    const char* option;
  } others[] = {{given.picture.layers, "--layers"},
                {given.tables.has_value(), "--luts"},
                {given.tile.has_value(), "--tile"},
                {given.cube_faces, "--cube-faces"}};
  for (const auto& other : others) {
    if (other.given) {
      throw InputError(std::string(kOption) + " does not go with " + other.option +
                       ", whose files hold colours; render twice, with one of them each");
    }
  }
  require_fit(scene, nodes.nm.size());
  return nodes;
}

}  // namespace airlight::cli
