#include "core/chart/qualities.h"

namespace airlight::chart {

std::vector<ChartedQuality> charted_qualities(const Scene& scene, const SkyMethod& method) {
  std::vector<ChartedQuality> all;
  for (const Quality& quality : method.sweep) {
    all.push_back({std::string(quality.label), with_quality(scene, method, quality)});
  }
  if (!scene.spectra || method.add_coloured_passes == nullptr) {
    return all;
  }
  const Scene defaults = with_quality(scene, method, {});
  for (const int count : {3, 4, 6, 12, 24}) {
    all.push_back({std::to_string(count) + " wavelengths", defaults});
    all.back().scene.spectra->wavelengths = count;
  }
  all.push_back({std::string(kThreeChannels), defaults});
  all.back().scene.spectra.reset();
  return all;
}

}  // namespace airlight::chart
