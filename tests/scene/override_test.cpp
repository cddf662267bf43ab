// "POINTER=JSON" from the command line.

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

Scene scene_with(const std::vector<std::string>& assignments, std::string_view extra = "") {
  Preset preset = parse_preset(with_one_medium(extra), "test", {});
  for (const std::string& assignment : assignments) {
    apply_override(preset, assignment);
  }
  return resolve(preset, local_methods());
}

std::string problems_with(const std::vector<std::string>& assignments, std::string_view extra = "") {
  try {
    scene_with(assignments, extra);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Override, SetsAValueThatIsThere) {
  EXPECT_EQ(scene_with({"/image/width=5"}, R"("image": {"width": 7, "height": 9})").image.width, 5);
  EXPECT_EQ(scene_with({"/image/width=5"}, R"("image": {"width": 7, "height": 9})").image.height, 9);
}

TEST(Override, MakesWhatThePresetIsSilentAbout) {
  EXPECT_FALSE(scene_with({"/sun/disc/visible=false"}).sun.disc.visible);
  EXPECT_EQ(scene_with({"/media/0/phase/g=0.5"}).media[0].phase_g, 0.5);
}

TEST(Override, TakesObjectsAndArrays) {
  EXPECT_EQ(scene_with({"/planet/ground_albedo=[0.1, 0.2, 0.3]"}).planet.ground_albedo, (Spectrum{0.1, 0.2, 0.3}));
  EXPECT_EQ(scene_with({R"(/media/0/density={"profile": "constant", "below_km": 3})"}).media[0].density.below, 3);
}

TEST(Override, TakesWhatIsNotJsonAsText) {
  EXPECT_EQ(scene_with({"/camera/projection=fisheye"}).camera.projection, Projection::fisheye);
  EXPECT_EQ(scene_with({"/name=a=b"}).name, "a=b");
  EXPECT_EQ(scene_with({"/name=2024-06-21"}).name, "2024-06-21");
  EXPECT_EQ(scene_with({"/name="}).name, "");
  EXPECT_EQ(scene_with({R"(/name="12")"}).name, "12");
}

TEST(Override, TheLastOneWins) {
  EXPECT_EQ(scene_with({"/image/width=5", "/image/width=6"}).image.width, 6);
}

TEST(Override, IsValidatedAsThePresetIs) {
  EXPECT_EQ(problems_with({"/camera/pitch_deg=200"}),
            "--set /camera/pitch_deg=200: /camera/pitch_deg: 200 is outside -90 to 90 degrees");
  EXPECT_EQ(problems_with({"/sun/elevation_deg=NaN"}),
            "--set /sun/elevation_deg=NaN: /sun/elevation_deg: \"NaN\" is not a number; expected a number, -90 to 90 "
            "degrees");
  EXPECT_EQ(problems_with({"/sun/elevation_deg=1e999"}),
            "--set /sun/elevation_deg=1e999: 1e999 is too large for a number; expected at most 1.8e308 in magnitude");
  EXPECT_EQ(problems_with({"/sun/elevatoin_deg=1"}),
            "--set /sun/elevatoin_deg=1: /sun/elevatoin_deg: unknown key; did you mean \"elevation_deg\"?");
  EXPECT_EQ(problems_with({"/extends=earth.json"}),
            "--set /extends=earth.json: /extends: \"earth.json\" comes too late; `extends` is followed in a preset's "
            "file only");
  EXPECT_EQ(problems_with({R"(/sun={"elevation_deg": 1, "elevation_deg": 2})"}),
            R"(--set /sun={"elevation_deg": 1, "elevation_deg": 2}: /elevation_deg: duplicate key; keep one of them)");
}

TEST(Override, ReportsWithTheFilesProblems) {
  EXPECT_EQ(problems_with({"/image/width=0"}, R"("sun": {"elevation_deg": 91})"),
            "--set /image/width=0: /image/width: 0 is outside 1 to 65536 pixels\n"
            "test:1: /sun/elevation_deg: 91 is outside -90 to 90 degrees");
}

TEST(Override, RefusesPointersThatLeadNowhere) {
  EXPECT_EQ(problems_with({"/camera/pitch_deg"}),
            "--set /camera/pitch_deg: no '='; expected POINTER=JSON, e.g. /camera/pitch_deg=20");
  EXPECT_EQ(problems_with({"camera/pitch_deg=2"}),
            "--set camera/pitch_deg=2: \"camera/pitch_deg\" is not a JSON pointer; expected a path such as "
            "/camera/pitch_deg");
  EXPECT_EQ(problems_with({"=2"}), "--set =2: \"\" is not a JSON pointer; expected a path such as /camera/pitch_deg");
  EXPECT_EQ(problems_with({"/a~2b=2"}),
            "--set /a~2b=2: \"/a~2b\" has a lone ~; expected ~0 for ~ and ~1 for / in a JSON pointer");
  EXPECT_EQ(problems_with({"/media/1/name=b"}),
            "--set /media/1/name=b: /media/1: there is no element \"1\"; expected an index from 0 to 0");
  for (const std::string index : {"-", "00", "x", "-1", "1.0", ""}) {
    EXPECT_EQ(problems_with({"/media/" + index + "=1"}), "--set /media/" + index + "=1: /media/" + index +
                                                             ": there is no element \"" + index +
                                                             "\"; expected an index from 0 to 0");
  }
  EXPECT_EQ(problems_with({"/airlight/x=1"}),
            "--set /airlight/x=1: /airlight/x: /airlight is a single value and has no keys; expected a pointer to a "
            "key of format 1");
  EXPECT_EQ(problems_with({"/name=\xff"}),
            "--set /name=\xff: the value is neither JSON nor UTF-8 text; expected POINTER=JSON");
}

TEST(Override, UnescapesThePointer) {
  EXPECT_EQ(problems_with({"/a~1b~0c=1"}).substr(0, 35), "--set /a~1b~0c=1: /a~1b~0c: unknown");
}

TEST(Override, AnotherMethodIgnoresWhatTheFileSaysForItsOwn) {
  const Scene scene = scene_with({"/render/method=still"}, R"("render": {"method": "orders", "color": "warm"})");
  EXPECT_EQ(scene.render.method, "still");
  EXPECT_FALSE(scene.render.parameters.contains("color"));
  EXPECT_EQ(problems_with({"/render/method=still", "/render/color=warm"}),
            "--set /render/color=warm: /render/color: the method \"still\" does not take this key; it belongs to "
            "orders: remove it");
  EXPECT_EQ(problems_with({"/render/method=still"}, R"("render": {"clor": "warm"})"),
            "test:1: /render/clor: unknown key; `airlight methods` lists them");
}

}  // namespace
}  // namespace airlight::test
