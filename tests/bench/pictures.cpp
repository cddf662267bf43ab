#include "tests/bench/pictures.h"

#include "core/base/error.h"
#include "core/render/render.h"
#include "tests/bench/scenes.h"
#include "tests/of_scene.h"

namespace airlight::bench {
namespace {

constexpr ImageSize kCheckedSize{256, 144};

// Each of the 65536 steps by its middle, so that no value is 0 and its logarithm is finite.
std::vector<float> displayed(const std::vector<std::uint16_t>& encoded) {
  std::vector<float> values;
  values.reserve(encoded.size());
  for (const std::uint16_t code : encoded) values.push_back((static_cast<float>(code) + 0.5f) / 65536.0f);
  return values;
}

}  // namespace

Checksums render_checked_pictures(Executor& executor) {
  const DeviceOnDemand device = [&]() -> Executor& { return executor; };
  RenderRequest request;
  request.bloom = true;
  request.bloom_picture = false;
  request.gpu_tone = true;
  Checksums found;
  for (const SkyMethod& method : methods()) {
    if (method.add_passes == nullptr) continue;
    for (const NamedScene& named : scenes()) {
      const Rendering rendering = render(device, rendered_by(method, named.scene, kCheckedSize), request);
      const std::string method_name(method.info.name);
      const std::string scene_name(named.name);
      if (const std::string fault = rendering.fault(); !fault.empty()) {
        throw RunError(method_name + ' ' + scene_name + " on " + executor.device().name + ": " + fault);
      }
      found[{method_name, scene_name}] = moments_of(rendering.radiance.rgba);
      found[{method_name, scene_name + "/display"}] = moments_of(displayed(rendering.encoded));
    }
  }
  return found;
}

}  // namespace airlight::bench
