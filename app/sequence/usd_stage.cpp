#include "app/sequence/usd_stage.h"

#include <memory>
#include <vector>

#include "app/cli/interruption.h"
#include "app/cli/terminal.h"
#include "app/render/usd_file.h"
#include "core/base/error.h"
#include "core/methods/ready.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {

void check_usd_stage(const UsdStageOrder& order, const SequenceJob& job) {
  require_ending(order.file, "sequence: --usd", ".usda");
  if (!job.exr) {
    throw InputError("sequence: --usd: the stage names the EXRs of the whole sky; give -o 'sky.####.exr' too");
  }
  require_latlong_dome(job.scene, job.picture, "sequence");
  if (job.shard.count > 1) {
    throw InputError(
        "sequence: --usd: one stage is for all frames, and this is a shard; run once more without --shard when all "
        "shards are done: frames that are whole stay");
  }
  require_writable(order.file);
}

void write_usd_stage(const UsdStageOrder& order, const SequenceJob& job) {
  const Interruption interruption;
  std::unique_ptr<Executor> executor;
  const DeviceOnDemand device = device_on_demand(job.scene_options, executor);
  Stage stage = *job.stage;
  std::vector<UsdSample> skies;
  for (std::size_t i = 0; i < sequence::frame_count(job.source); ++i) {
    if (Interruption::signal() != 0) {
      return;
    }
    const sequence::Frame frame = sequence::frame_at(job.source, i);
    stage = ready(scene_of(job, frame), stage);
    UsdSample& sky =
        skies.emplace_back(UsdSample{frame.number, exr_from_stage(order.file, files_of(job, frame.number).exr),
                                     stage.scene().camera.azimuth, sun_light(device, stage)});
    for (const Stage& other : stage.others()) {
      sky.moon = sun_light(device, other);
    }
  }
  require_valid_vulkan();
  const std::string doc = std::string("airlight ") + AIRLIGHT_VERSION + ", " + job.scene.name;
  write_file(order.file, usd_text(skies, order.up, doc, job.frames_a_second));
  if (!job.quiet) {
    tell(order.file + "\n");
  }
}

}  // namespace airlight::cli
