#include "core/render/after_sky.h"

#include "core/plan/bytes.h"
#include "core/render/sky.h"

namespace airlight {
namespace {

Glow add_glow(Plan& plan, const Scene& scene, const Picture& band, const Bloomed& bloom, double exposure) {
  if (scene.bloom.model == BloomModel::glare) {
    return add_glare_sources(plan, bloom.glare);
  }
  return add_bloom(plan, scene, add_bloom_base(plan, scene, band), exposure);
}

}  // namespace

bool host_measures(const Executor& executor) {
  return executor.device().is_cpu;
}

Bloomed bloom_of(const Stage& stage) {
  return stage.scene().bloom.model == BloomModel::glare ? Bloomed{glare_points_of(stage)} : Bloomed{};
}

BufferDesc uploaded_radiance(const Tile& band) {
  return {.name = "radiance", .bytes = 4 * sizeof(float) * pixels_of(band), .host_readable = true};
}

PostPasses::PostPasses(Plan& plan, const Scene& scene, const Picture& band, const RenderRequest& request,
                       const std::optional<Bloomed>& bloom, double exposure)
    : band_(band) {
  std::optional<Glow> glow;
  if (bloom && (request.bloom_picture || request.gpu_tone)) {
    glow = add_glow(plan, scene, band, *bloom, exposure);
  }
  if (glow && request.bloom_picture) {
    bloom_ = add_glow_picture(plan, scene, band, *glow);
  }
  if (request.gpu_tone) {
    encoded_ = add_tonemap(plan, scene, band, glow, exposure);
  }
}

void PostPasses::take(const RunResult& result, Pixels& rows) const {
  if (bloom_) {
    rows.bloom = RadianceImage{static_cast<int>(band_.width), static_cast<int>(band_.height),
                               values_of<float>(result.contents(*bloom_))};
  }
  if (encoded_) {
    rows.encoded = values_of<std::uint16_t>(result.contents(*encoded_));
  }
}

}  // namespace airlight
