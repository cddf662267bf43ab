// `sequence`: valid key frames, and the same checks for a key in them as for the key itself.

#include <gtest/gtest.h>

#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/readers.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

std::string sequence_problems(const std::string& sequence) {
  return problems_of(with_one_medium("\"sequence\": " + sequence));
}

void expect_problem(const std::string& sequence, const std::vector<std::string>& parts) {
  const std::string problems = sequence_problems(sequence);
  EXPECT_NE(problems, "") << sequence;
  for (const std::string& part : parts) {
    EXPECT_NE(problems.find(part), std::string::npos) << "expected '" << part << "' in: " << problems;
  }
}

TEST(KeyFrames, AreReadWithTheirValues) {
  const Scene scene = scene_from(with_one_medium(
      R"("sequence": {"frames": [{"at": 0, "/sun/elevation_deg": -6, "/planet/ground_albedo": [0.1, 0.2, 0.3]},
                                 {"at": 24, "/sun/elevation_deg": 6, "/render/steps": 16, "/media/0/phase/g": 0.5}],
                      "interpolation": "linear"})"));
  ASSERT_TRUE(scene.sequence.has_value());
  const KeyFrames& sequence = *scene.sequence;
  ASSERT_EQ(sequence.frames.size(), 2U);
  EXPECT_EQ(sequence.frames[1].at, 24);
  EXPECT_EQ(sequence.frames[0].values.at("/planet/ground_albedo"), (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(sequence.frames[1].values.at("/sun/elevation_deg"), std::vector<double>{6.0});
  EXPECT_EQ(sequence.whole, (std::set<std::string, std::less<>>{"/render/steps"}));
}

TEST(KeyFrames, ComeBackFromThePresetWritten) {
  const Scene scene = scene_from(with_one_medium(
      R"("sequence": {"frames": [{"at": 3, "/image/width": 17, "/sun/irradiance": [1, 2, 3.5]}, {"at": 9}]})"));
  const std::string json = to_json(scene);
  const Scene again = scene_from(json);
  expect_same(scene, again);
  ASSERT_TRUE(again.sequence.has_value());
  EXPECT_EQ(again.sequence->frames[0].values, scene.sequence->frames[0].values);
  EXPECT_EQ(again.sequence->frames[1].at, 9);
  EXPECT_EQ(again.sequence->whole, scene.sequence->whole);
  EXPECT_EQ(to_json(again), json);
  EXPECT_FALSE(scene_from(with_one_medium("")).sequence.has_value());
}

TEST(KeyFrames, AreJudgedAsTheKeysThatTheySet) {
  expect_problem(R"({"frames": [{"at": 0, "/sun/elevation_deg": 91}]})",
                 {"test:1: /sequence/frames/0/~1sun~1elevation_deg: 91 is outside -90 to 90"});
  expect_problem(R"({"frames": [{"at": 0}, {"at": 1, "/sun/elevaton_deg": 1}]})",
                 {"/sequence/frames/1/~1sun~1elevaton_deg: unknown key", "elevation_deg"});
  expect_problem(R"({"frames": [{"at": 0, "/media/1/phase/g": 1}]})", {"/sequence/frames/0", "no element \"1\""});
  expect_problem(R"({"frames": [{"at": 0, "/render/method": 1}]})", {"/sequence/frames/0/~1render~1method"});
  expect_problem(R"({"frames": [{"at": 0, "/sun/disc/visible": 1}]})", {"/~1sun~1disc~1visible: ", "true or false"});
  expect_problem(R"({"frames": [{"at": 0, "/image/width": 1.5}]})", {"/~1image~1width: ", "whole"});
  expect_problem(R"({"frames": [{"at": 0, "/render/steps": 0}]})", {"/~1render~1steps: "});
  expect_problem(R"({"frames": [{"at": 0, "/camra/pitch_deg": 1}]})",
                 {"/sequence/frames/0/~1camra~1pitch_deg: unknown"});
  expect_problem(R"({"frames": [{"at": 0, "/sun/irradiance": [1, -2, 3]}]})",
                 {"/sequence/frames/0/~1sun~1irradiance/1: -2 is"});
}

// Beside those of the preset and of other frames, each once.
TEST(KeyFrames, AreToldWithAllOtherProblems) {
  EXPECT_EQ(problems_of(with_one_medium(R"("camera": {"pitch_deg": 95}, "sequence": {"frames": [
{"at": 0, "sun": 1, "/camera/yaw_deg": 3},
{"at": 0, "/sun/elevation_deg": 91}]})")),
            "test:1: /camera/pitch_deg: 95 is outside -90 to 90 degrees\n"
            "test:2: /sequence/frames/0/sun: unknown key; expected `at`, or a JSON pointer such as /sun/elevation_deg\n"
            "test:2: /sequence/frames/0/~1camera~1yaw_deg: unknown key; expected one of altitude_km, azimuth_deg, "
            "cube_layout, julian_date, latitude_deg, longitude_deg, pitch_deg, polariser, projection, roll_deg, "
            "vertical_fov_deg\n"
            "test:3: /sequence/frames/1/at: 0 is not above the frame before it (0); expected ascending numbers\n"
            "test:3: /sequence/frames/1/~1sun~1elevation_deg: 91 is outside -90 to 90 degrees");
}

TEST(KeyFrames, ThatAreNoneAreRefused) {
  expect_problem("3", {"/sequence", "not an object"});
  expect_problem("{}", {"/sequence/frames", "missing"});
  expect_problem(R"({"frames": []})", {"/sequence/frames", "empty"});
  expect_problem(R"({"frames": {"at": 0}})", {"/sequence/frames", "not an array"});
  expect_problem(R"({"frames": [3]})", {"/sequence/frames/0", "not an object"});
  expect_problem(R"({"frames": [{}]})", {"/sequence/frames/0/at", "missing"});
  expect_problem(R"({"frames": [{"at": -1}]})", {"/sequence/frames/0/at", "-1 is outside 0 to 1e7"});
  expect_problem(R"({"frames": [{"at": 0.5}]})", {"/sequence/frames/0/at", "whole"});
  expect_problem(R"({"frames": [{"at": 2}, {"at": 2}]})",
                 {"/sequence/frames/1/at", "2 is not above the frame before it"});
  expect_problem(R"({"frames": [{"at": 0, "sun": 1}]})", {"/sequence/frames/0/sun", "JSON pointer"});
  expect_problem(R"({"frames": [{"at": 0, "/name": "x"}]})", {"\"x\" cannot be animated"});
  expect_problem(R"({"frames": [{"at": 0, "/sun/irradiance": [1, 2]}]})", {"cannot be animated"});
  expect_problem(R"({"frames": [{"at": 0, "/sequence/frames/0/at": 2}]})", {"cannot change itself"});
  expect_problem(R"({"frames": [{"at": 0}], "interpolation": "cubic"})", {"/sequence/interpolation", "\"linear\""});
  expect_problem(R"({"frames": [{"at": 0}], "intepolation": "linear"})", {"unknown key", "interpolation"});
}

TEST(KeyFrames, NameTheLineOfTheValue) {
  const std::string problems = problems_of(
      "{\"airlight\": 1, \"media\": [{\"name\": \"a\", \"density\": {\"profile\": "
      "\"exponential\", \"scale_height_km\": 8}}],\n\"sequence\": {\"frames\": [\n"
      "{\"at\": 0,\n\"/sun/elevation_deg\": 99}]}}");
  EXPECT_NE(problems.find(":4: /sequence/frames/0/~1sun~1elevation_deg: "), std::string::npos) << problems;
}

// Each is checked as a scene of its own, so there is a bound.
TEST(KeyFrames, AreBounded) {
  std::string frames;
  for (std::size_t i = 0; i <= kMostKeyFrames; ++i) {
    frames += (i == 0 ? "" : ",") + std::string("{\"at\": ") + std::to_string(i) + "}";
  }
  EXPECT_EQ(problems_of(R"({"airlight": 1, "media": [{"name": "a", "density": {"profile": "exponential",
                           "scale_height_km": 8}}], "sequence": {"frames": [)" +
                        frames + "]}}"),
            "test:2: /sequence/frames: an array of 20001; expected an array of 1 to 20000 {\"at\": NUMBER, "
            "\"/POINTER\": VALUE, ...}: leave out those that lie between others");
}

}  // namespace
}  // namespace airlight::test
