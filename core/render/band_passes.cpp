#include "core/render/band_passes.h"

#include "core/plan/bytes.h"

namespace airlight {

bool host_measures(const Executor& executor) {
  return executor.device().is_cpu;
}

BandPasses::BandPasses(Plan& plan, const Scene& scene, const Picture& band, const BandWork& work) : band_(band) {
  if (work.statistics) {
    rows_ = add_picture_statistics(plan, band, brightest_metered(scene), scene.spectra.has_value());
  }
  std::optional<Glow> glow;
  if (work.glare != nullptr && (work.bloom_picture || work.gpu_tone)) {
    glow = add_glare_sources(plan, *work.glare);
  }
  if (glow && work.bloom_picture) {
    bloom_ = add_glow_picture(plan, scene, band, *glow);
  }
  if (work.gpu_tone) {
    encoded_ = add_tonemap(plan, scene, band, glow, work.exposure);
  }
}

std::span<const std::byte> BandPasses::statistics(const RunResult& result) const {
  return rows_ ? result.contents(*rows_) : std::span<const std::byte>();
}

void BandPasses::take(const RunResult& result, Rendering& rows) const {
  if (bloom_) {
    rows.bloom = RadianceImage{static_cast<int>(band_.width), static_cast<int>(band_.height),
                               values_of<float>(result.contents(*bloom_))};
  }
  if (encoded_) {
    rows.encoded = values_of<std::uint16_t>(result.contents(*encoded_));
  }
}

}  // namespace airlight
