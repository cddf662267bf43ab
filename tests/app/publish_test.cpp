// Publishing of a rendering with invalid values. The preset's ranges do not permit such a rendering through the command
// line, so the test makes it by hand.
#include "app/render/publish.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "tests/cli/process.h"

namespace airlight::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Scene scene_of(int width, int height) {
  Scene scene;
  scene.image = {width, height};
  scene.display.view = "diagnostic";
  return scene;
}

// Grey, with a NaN at column 2 of row 1.
Rendering poisoned(const Scene& scene) {
  Rendering rendering;
  const auto pixels = static_cast<std::size_t>(scene.image.width) * static_cast<std::size_t>(scene.image.height);
  rendering.radiance = {scene.image.width, scene.image.height, std::vector<float>(4 * pixels, 0.5F)};
  rendering.radiance.rgba[4 * (static_cast<std::size_t>(scene.image.width) + 2)] = kNan;
  rendering.picture.not_finite = 1;
  rendering.picture.first_bad_x = 2;
  rendering.picture.first_bad_y = 1;
  return rendering;
}

cli::Targets both_in(const Scratch& scratch) {
  return {(scratch.path() / "a.exr").string(), (scratch.path() / "a.png").string()};
}

// The message of the RunError that publishing throws; empty when it throws none.
std::string refusal(const Scene& scene, const Rendering& picture, const cli::Targets& files) {
  cli::Stopwatch watch;
  const std::optional<DisplayTransform> none;
  cli::PictureWriter writer({.parts = {{scene, 0, files}},
                             .transform = none,
                             .options = {},
                             .depth = {},
                             .source = "sky.json",
                             .context = [](const Scene& part, const Rendering& rows) {
                               return cli::PictureContext{part, rows, {"{}", "march", "0", "none"}};
                             }});
  Rendering rendering = picture;
  if (picture.fault().empty() || writer.bands({}, {}).past_faults) {
    writer.add({0, picture});
  }
  try {
    writer.publish(rendering, watch);
  } catch (const RunError& error) {
    return error.what();
  }
  return {};
}

TEST(Publish, APoisonedPictureIsNotWritten) {
  const Scratch scratch;
  Scene scene = scene_of(4, 3);
  scene.display.view = "gpu";
  const std::string message = refusal(scene, poisoned(scene), both_in(scratch));
  for (const char* part : {"sky.json: the picture", "column 2", "row 1", "--view diagnostic"}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_TRUE(scratch.files().empty());
}

TEST(Publish, APoisonedTableIsNamed) {
  const Scratch scratch;
  const Scene scene = scene_of(4, 3);
  Rendering rendering = poisoned(scene);
  Statistics bad;
  bad.negative = 7;
  rendering.tables_statistics.push_back({"transmittance", bad});
  cli::Targets files = both_in(scratch);
  files.png.clear();
  const std::string message = refusal(scene, rendering, files);
  EXPECT_NE(message.find("table transmittance"), std::string::npos) << message;
  EXPECT_TRUE(scratch.files().empty());
}

TEST(Publish, TheDiagnosticViewIsWrittenNevertheless) {
  const Scratch scratch;
  const Scene scene = scene_of(4, 3);
  const std::string message = refusal(scene, poisoned(scene), both_in(scratch));
  EXPECT_NE(message.find("NaN magenta"), std::string::npos) << message;
  EXPECT_EQ(scratch.files(), Names{"a.png"});
}

TEST(Publish, ASoundPictureIsWritten) {
  const Scratch scratch;
  const Scene scene = scene_of(4, 3);
  Rendering rendering = poisoned(scene);
  rendering.radiance.rgba.assign(rendering.radiance.rgba.size(), 0.5F);
  rendering.picture = {};
  EXPECT_EQ(refusal(scene, rendering, both_in(scratch)), "");
  EXPECT_EQ(scratch.files(), (Names{"a.exr", "a.png"}));
}

TEST(Publish, DiagnosticColoursTellTheKindsApart) {
  const RadianceImage kinds{
      6, 1, {0.0F, 0.0F,  0.0F,      1.0F, 0.0F,      1.0F, 0.0F,  1.0F, 1.0F,  -1.0F, 0.0F, 1.0F,
             1.0F, -1.0F, kInfinity, 1.0F, kInfinity, kNan, -1.0F, 1.0F, -0.0F, 0.0F,  0.0F, 1.0F}};
  const RadianceImage shown = cli::diagnostic_picture(kinds);
  const auto colour = [&](int x) { return std::vector<float>(shown.at(x, 0), shown.at(x, 0) + 3); };
  const std::vector<float> black{0, 0, 0};
  const std::vector<float> grey{0.8F, 0.8F, 0.8F};
  EXPECT_EQ(colour(0), black);
  EXPECT_EQ(colour(1), grey);
  EXPECT_EQ(colour(2), (std::vector<float>{0, 0, 1}));
  EXPECT_EQ(colour(3), (std::vector<float>{1, 1, 0}));
  EXPECT_EQ(colour(4), (std::vector<float>{1, 0, 1}));
  EXPECT_EQ(colour(5), black);
}

}  // namespace
}  // namespace airlight::test
