#include <gtest/gtest.h>

#include <memory>

#include "app/cli/scene_options.h"
#include "app/render/publish.h"
#include "core/base/error.h"
#include "core/methods/ready.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

// A rendering in tiles with invalid values; publish_test.cpp has whole ones.
TEST(TiledPicture, AFaultIsShownByTheDiagnosticView) {
  const Scratch scratch;
  scratch.write("sky.json", small_preset());
  cli::SceneOptions options;
  options.preset = scratch.path() / "sky.json";
  Scene scene = cli::load_scene(options);
  scene.sun.irradiance = {1e38, 1e38, 1e38};  // not possible in a preset
  scene.sun.disc.radiance_scale = 1e30;
  scene.sun.disc.angular_radius = 0.2;
  std::unique_ptr<Executor> executor;
  const std::optional<DisplayTransform> none;
  const auto message = [&] {
    cli::Stopwatch watch;
    const auto context = [](const Scene& part, const Rendering& rows) { return cli::PictureContext{part, rows, {}}; };
    cli::PictureWriter writer({.parts = {{scene, 0, {scratch.path() / "a.exr", scratch.path() / "a.png"}}},
                               .transform = none,
                               .options = {},
                               .depth = {},
                               .source = "sky.json",
                               .context = context});
    try {
      const Stage stage = ready(scene);
      Rendering rendering =
          render_bands(cli::device_on_demand(options, executor), stage, writer.bands(ImageSize{9, 5}, {}));
      writer.publish(rendering, watch);
    } catch (const RunError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  scene.display.view = "gpu";
  EXPECT_TRUE(contains(message(), "no picture was written; --png FILE --view diagnostic shows where")) << message();
  EXPECT_EQ(scratch.files(), (Names{"sky.json"}));
  scene.display.view = "diagnostic";
  EXPECT_TRUE(contains(message(), "NaN magenta"));
  EXPECT_EQ(scratch.files(), (Names{"a.png", "sky.json"}));
}

}  // namespace
}  // namespace airlight::test
