// The default contents of a chart, and the pixels that it compares.
#include "core/chart/settings.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/chart/gnuplot.h"
#include "core/chart/pixels.h"
#include "core/chart/timing.h"
#include "core/chart/truth.h"
#include "core/measure/view_geometry.h"
#include "core/methods/ready.h"

namespace airlight::chart {
namespace {

std::string shipped() {
  std::ifstream in(AIRLIGHT_SOURCE_DIR "/presets/chart.json");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string settings_refusal(const std::string& text) {
  try {
    parse_settings(text, "chart.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Settings, ThatShipNameEightScenes) {
  const Settings settings = parse_settings(shipped(), "presets/chart.json");
  EXPECT_EQ(settings.scenes.size(), 8U);
  EXPECT_EQ(settings.image.width, 1280);
  EXPECT_GT(settings.compared_columns * settings.compared_rows, 1000);
  EXPECT_LE(settings.truth_error, 0.002);
}

TEST(Settings, ThatAreWrongAreRefusedByKey) {
  const std::string rest = R"(, "image": [64, 36], "compared_pixels": [4, 3], "truth_error": 0.01})";
  EXPECT_EQ(settings_refusal(R"({"scenes": ["earth-noon"])" + rest), "");
  EXPECT_NE(settings_refusal(R"({"scenes": [])" + rest).find("/scenes: expected an array"), std::string::npos);
  EXPECT_NE(settings_refusal(R"({"scenes": [3])" + rest).find("/scenes"), std::string::npos);
  EXPECT_NE(settings_refusal(R"({"scenes": ["a"], "colour": 1)" + rest).find("/colour"), std::string::npos);
  EXPECT_NE(settings_refusal(R"({"scenes": ["a"], "image": [64, 36], "compared_pixels": [4, 3]})").find("/truth_error"),
            std::string::npos);
  EXPECT_NE(
      settings_refusal(R"({"scenes": ["a"], "image": [64.5, 36], "compared_pixels": [4, 3], "truth_error": 0.01})")
          .find("/image: expected [width, height]"),
      std::string::npos);
  EXPECT_NE(settings_refusal("[]").find("an object"), std::string::npos);
}

Scene wide_scene() {
  Scene scene;
  scene.image = {64, 36};
  scene.camera.vertical_fov = 1.0;
  scene.camera.pitch = 0.0;
  return scene;
}

TEST(Lattice, StandsOnPixelsOfThePicture) {
  const PixelSet set = lattice(wide_scene(), 8, 4);
  ASSERT_EQ(set.places.size(), 32U);
  EXPECT_EQ(set.places.front(), 4U * 64U + 4U);
  EXPECT_EQ(set.places.back(), 31U * 64U + 60U);
  EXPECT_EQ(lattice(wide_scene(), 1000, 1000).places.size(), 64U * 35U) << "all but the row that the horizon crosses";
}

TEST(Lattice, JudgesTheSkyAloneWhereThereIsOne) {
  const Scene scene = wide_scene();
  const PixelSet all = lattice(scene, 64, 36);
  EXPECT_EQ(judged(scene, all).places.size(), 64U * 18U);
  EXPECT_FALSE(judges_whole_picture(scene, all));
  Scene above = scene;
  above.camera.altitude = 500.0;
  const PixelSet from_above = lattice(above, 64, 36);
  EXPECT_EQ(judged(above, from_above).places.size(), from_above.places.size());
  Scene down = scene;
  down.camera.pitch = -1.5;
  EXPECT_TRUE(judges_whole_picture(down, lattice(down, 8, 4)));
}

TEST(Lattice, TakesThePicturesValues) {
  PixelSet set;
  set.places = {2, 0};
  const std::vector<float> rgba{1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 0.5F, 9};
  EXPECT_EQ(values_at(rgba, set), (std::vector<float>{7, 8, 0.5F, 1, 2, 3}));
}

TEST(Truth, IsNamedByWhatItDependsOn) {
  Scene scene = wide_scene();
  scene.media.resize(1);
  scene.media[0].scattering = {1e-2, 1e-2, 1e-2};
  const PixelSet set = lattice(scene, 4, 3);
  const std::string name = truth_name(ready(scene), set);
  EXPECT_EQ(name.size(), 16U);
  EXPECT_EQ(name, truth_name(ready(scene), set));
  Scene exposed = scene;
  exposed.display.exposure = 3.0;
  exposed.render.method = "analytic";
  EXPECT_EQ(name, truth_name(ready(exposed), set)) << "what no radiance depends on makes no new truth";
  Scene lower = scene;
  lower.sun.elevation = 0.1;
  EXPECT_NE(name, truth_name(ready(lower), set));
  EXPECT_NE(name, truth_name(ready(scene), lattice(scene, 5, 3)));
}

TEST(Truth, OfSpectraIsAtAllWavelengths) {
  Scene scene = wide_scene();
  scene.media.resize(1);
  scene.spectra.emplace();
  scene.media[0].scattering.curve = constant_curve(1e-2);
  scene.planet.ground_albedo.curve = constant_curve(0.3);
  scene.spectra->sun = constant_curve(1.0);
  const PixelSet set = lattice(scene, 4, 3);
  const std::string name = truth_name(ready(scene), set);
  Scene fewer = scene;
  fewer.spectra->wavelengths = 4;
  EXPECT_EQ(name, truth_name(ready(fewer), set)) << "however many the picture has";
  Scene bluer = scene;
  bluer.media[0].scattering.curve = constant_curve(2e-2);
  EXPECT_NE(name, truth_name(ready(bluer), set));
  scene.spectra.reset();
  EXPECT_NE(name, truth_name(ready(scene), set)) << "three channels have a truth of their own";
}

TEST(Median, IsTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2.0);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7.0);
}

TEST(Script, NamesScenesAndMethodsAsTheyAre) {
  const auto point = [](std::string scene, std::string quality, double time, double error) {
    Point p;
    p.scene = std::move(scene);
    p.method = "march";
    p.quality = std::move(quality);
    p.time_ms = time;
    p.error_mean = error;
    p.floor = 0.001;
    return p;
  };
  std::vector<Point> points;
  for (const std::string scene : {"it's", "noon", "all"}) {
    points.push_back(point(scene, "8's", 1.0, 0.1));
    points.push_back(point(scene, "beaten", 5.0, 0.2));
    points.push_back(point(scene, "64", 10.0, 0.01));
    points.push_back(point(scene, "three channels", 1.0, 0.3));
  }
  mark_frontier(points);
  const std::string script = gnuplot_script({{"it's", "noon"}, {"march"}, true, "on a device", "ms"}, points);
  EXPECT_NE(script.find("s = 'it''s'"), std::string::npos) << script;
  EXPECT_NE(script.find("set label 'march: 8''s'"), std::string::npos) << script;
  EXPECT_NE(script.find("set label 'march: 64'"), std::string::npos) << script;
  EXPECT_NE(script.find("set label 'three channels'"), std::string::npos) << script;
  EXPECT_EQ(script.find("beaten"), std::string::npos) << "only the frontier and the three channels are labelled";
  EXPECT_NE(script.find("heading = 'on a device'"), std::string::npos);
  const std::string alone = gnuplot_script({{"noon"}, {"march"}, false, "on a device", "ms"}, points);
  EXPECT_NE(alone.find("s = 'noon'"), std::string::npos) << alone;
  EXPECT_EQ(alone.find("it''s"), std::string::npos) << alone;
}

// The truth costs ten thousand times what other methods do: the axis ends before it, and a line tells its points.
TEST(Script, AMethodFarFromAllOthersIsToldInALine) {
  const auto point = [](std::string method, double time, double error) {
    Point p;
    p.scene = "noon";
    p.method = std::move(method);
    p.quality = "q";
    p.time_ms = time;
    p.error_mean = error;
    p.floor = 0.001;
    return p;
  };
  std::vector<Point> points{point("march", 0.05, 0.1), point("march", 2.0, 0.01), point("path-trace", 3e4, 0.05),
                            point("path-trace", 3e5, 0.02)};
  mark_frontier(points);
  const PlotText text{{"noon"}, {"march", "path-trace"}, false, "on a device", "time"};
  const std::string script = gnuplot_script(text, points);
  EXPECT_NE(script.find("path-trace: 30 s to 300 s for 5 to 2 %"), std::string::npos) << script;
  EXPECT_NE(script.find("array methods[1] = ['march']"), std::string::npos) << script;
  EXPECT_NE(script.find("'50 \xC2\xB5s' 0.05"), std::string::npos) << "a mark has its unit\n" << script;
  EXPECT_NE(script.find("'2 ms' 2"), std::string::npos) << script;
  EXPECT_EQ(script.find("e+0"), std::string::npos) << "no mark in powers\n" << script;

  points[2].time_ms = 150.0;  // within a hundred times of the dearest other
  points[3].time_ms = 190.0;
  const std::string near = gnuplot_script(text, points);
  EXPECT_NE(near.find("array methods[2] = ['march', 'path-trace']"), std::string::npos) << near;
  EXPECT_EQ(near.find("path-trace: 0.15 s"), std::string::npos) << near;
}

}  // namespace
}  // namespace airlight::chart
