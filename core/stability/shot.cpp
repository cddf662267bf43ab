#include "core/stability/shot.h"

#include <cstring>

#include "core/methods/ready.h"

namespace airlight::stability {
namespace {

using physics::vec3;

std::vector<float> floats_of(std::span<const std::byte> bytes) {
  std::vector<float> out(bytes.size() / sizeof(float));
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

vec3 vector_at(const std::vector<float>& rgba, std::size_t i) {
  return {static_cast<double>(rgba[4 * i]), static_cast<double>(rgba[4 * i + 1]), static_cast<double>(rgba[4 * i + 2])};
}

physics::HostTable host_table(const ImageDesc& image, std::span<const std::byte> bytes) {
  physics::HostTable table;
  table.width = static_cast<int>(image.extent.width);
  table.height = static_cast<int>(image.extent.height);
  const std::vector<float> rgba = floats_of(bytes);
  for (std::size_t i = 0; 4 * i < rgba.size(); ++i) {
    table.texels.push_back(vector_at(rgba, i));
  }
  return table;
}

struct Readback {
  std::uint32_t image;
  BufferId buffer;
};

// The tables kept from plan to plan, which depend on the air and not on the picture.
std::vector<Readback> read_tables(Plan& plan) {
  std::vector<Readback> list;
  for (std::uint32_t i = 0; i < plan.images().size(); ++i) {
    if (!plan.images()[i].key.empty()) {
      list.push_back({i, plan.add_readback(ImageId{i})});
    }
  }
  return list;
}

}  // namespace

Shot shoot(const DeviceOnDemand& device, const Scene& scene, const std::vector<Direction>& directions,
           const ShotOptions& options) {
  Shot shot;
  Plan plan;
  const Stage stage = ready(scene);
  plan.scene_data = device_scene_bytes(stage.whole().air, scene);
  const View view{directions, options.as_picture};
  const SkyPasses sky = stage.method().add_passes(plan, stage.whole(), view);
  const std::vector<Readback> readbacks = options.tables ? read_tables(plan) : std::vector<Readback>();
  const RunResult result = device().run(plan);
  const std::vector<float> rgba = floats_of(result.contents(sky.radiance));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    shot.radiance.push_back(vector_at(rgba, 2 * i));
    if (!options.as_picture) {
      shot.transmittance.push_back(vector_at(rgba, 2 * i + 1));
    }
  }
  for (const Readback& readback : readbacks) {
    const ImageDesc& image = plan.images()[readback.image];
    shot.tables.emplace(image.name, host_table(image, result.contents(readback.buffer)));
  }
  return shot;
}

}  // namespace airlight::stability
