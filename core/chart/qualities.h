#pragma once
// The qualities at which a method is charted on a scene.

#include <string>
#include <string_view>
#include <vector>

#include "core/methods/method.h"
#include "core/scene/scene.h"

namespace airlight::chart {

// The quality that renders a scene with spectra by its three channels alone (Scene::spectra).
inline constexpr std::string_view kThreeChannels = "three channels";

struct ChartedQuality {
  std::string label;
  Scene scene;
};

// The method's sweep. For a scene with spectra and a method that renders any number of wavelengths in one pass over the
// pixels, it also has the method's defaults at 3, 4, 6, 12 and 24 wavelengths, and the three channels.
std::vector<ChartedQuality> charted_qualities(const Scene& scene, const SkyMethod& method);

}  // namespace airlight::chart
