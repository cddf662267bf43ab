// A picture timed in tiles equals the picture timed as a whole.
#include "core/chart/timing.h"

#include <gtest/gtest.h>

#include "core/methods/method.h"
#include "core/methods/ready.h"
#include "core/scene/preset.h"
#include "core/scene/resolve.h"

namespace airlight::chart {
namespace {

TEST(TimedPicture, IsTheSameInTiles) {
  Executor executor({});
  Scene scene = resolve(load_preset(AIRLIGHT_SOURCE_DIR "/presets/earth-hillaire2020-noon.json"), method_infos());
  scene.image = {32, 18};
  const PixelSet pixels = lattice(scene, 8, 6);
  for (const char* method : {"orders", "sky-view", "march"}) {
    scene = with_quality(scene, *find_method(method), {"default", {}});
    TableTimes tables;
    const TimingRules once{.most_runs = 1, .fewest_runs = 1};
    TimingRules tiled = once;
    tiled.tile_bytes = 5 * 32 * 16;  // four tiles, the last of three rows
    const Timing whole = time_on_device(executor, ready(scene), pixels, once, tables);
    const Timing parts = time_on_device(executor, ready(scene), pixels, tiled, tables);
    EXPECT_EQ(whole.pixels, parts.pixels) << method;
    EXPECT_EQ(tables.size(), 1U) << method << ": the tiles' own tables are no kept ones";
  }
}

}  // namespace
}  // namespace airlight::chart
