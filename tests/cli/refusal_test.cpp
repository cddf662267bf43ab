// Refusals of render, luts and check: presets, pictures, places.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

class Refusal : public SmallSky {};

TEST_F(Refusal, CheckFindsEveryProblemOfEveryFile) {
  scratch_.write("one.json", R"({"airlight": 1, "media": [], "camera": {"pitch_deg": 95, "pich": 1}})");
  scratch_.write("two.json", R"({"airlight": 1,)");
  const Outcome outcome = tool({"check", "one.json", "sky.json", "two.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.out, "sky.json: good")) << outcome.out;
  for (const char* part : {"/media", "/camera/pitch_deg", "95", "-90 to 90", "/camera/pich", "two.json"}) {
    EXPECT_TRUE(contains(outcome.err, part)) << part << " is missing in\n" << outcome.err;
  }
  EXPECT_GE(lines_of(outcome.err).size(), 4U);
  const Outcome verbose = tool({"check", "-v", "sky.json"});
  EXPECT_TRUE(contains(verbose.out, "scale height 8 km")) << verbose.out;
}

struct WrongPreset {
  const char* what;
  std::string text;
  Names parts;
};

// Each preset is small_preset() with one mistake.
std::vector<WrongPreset> bad_presets() {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = small_preset();
    const std::size_t at = text.find(from);
    return text.replace(at, from.size(), to);
  };
  return {
      {"syntax", with("\"media\": [", "\"media\" ["), {"sky.json", "2"}},
      {"unknown key", with("\"camera\"", "\"camra\""), {"/camra", "camera"}},
      {"wrong type", with("\"pitch_deg\": 10", "\"pitch_deg\": \"up\""), {"/camera/pitch_deg", "up"}},
      {"out of range", with("\"pitch_deg\": 10", "\"pitch_deg\": 91"), {"/camera/pitch_deg", "91", "-90 to 90"}},
      {"NaN", with("\"pitch_deg\": 10", "\"pitch_deg\": NaN"), {"sky.json"}},
      {"infinity", with("\"pitch_deg\": 10", "\"pitch_deg\": 1e999"), {"sky.json"}},
      {"missing media", R"({"airlight": 1})", {"/media"}},
      {"missing version", with("\"airlight\": 1,", ""), {"/airlight"}},
      {"duplicate medium",
       with("\"media\": [", R"("media": [{"name": "air", "density": {"profile": "constant", "below_km": 1}}, )"),
       {"air"}},
      {"duplicate key", with("\"camera\": {", "\"camera\": {\"pitch_deg\": 1, "), {"pitch_deg"}},
      {"extends a missing file",
       with("\"airlight\": 1,", "\"airlight\": 1, \"extends\": \"none.json\","),
       {"none.json"}},
      {"extends itself",
       with("\"airlight\": 1,", "\"airlight\": 1, \"extends\": \"sky.json\","),
       {"/extends", "sky.json"}},
      {"inside the planet", with("\"pitch_deg\": 10", "\"altitude_km\": -1"), {"/camera/altitude_km", "-1"}},
      {"field of view", with("\"pitch_deg\": 10", "\"vertical_fov_deg\": 180"), {"/camera/vertical_fov_deg", "180"}},
      {"no picture", with("\"width\": 32", "\"width\": 0"), {"/image/width", "0", "65536"}},
      {"large picture", with("\"width\": 32", "\"width\": 65537"), {"/image/width", "65537", "65536"}},
      {"unknown method",
       with("\"camera\"", "\"render\": {\"method\": \"marsh\"}, \"camera\""),
       {"/render/method", "march"}},
      {"unknown parameter", with("\"camera\"", "\"render\": {\"step\": 3}, \"camera\""), {"/render/step", "steps"}},
      {"not a preset", "# Title\n", {"sky.json"}},
      {"empty", "", {"sky.json"}},
  };
}

TEST_F(Refusal, ABadPresetIsOneLineAndNoFile) {
  for (const WrongPreset& bad : bad_presets()) {
    scratch_.write("sky.json", bad.text);
    const Outcome outcome = tool({"render", "sky.json"});
    EXPECT_EQ(outcome.exit_code, 2) << bad.what << ": " << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << bad.what << ": " << outcome.err;
    EXPECT_EQ(outcome.out, "") << bad.what;
    for (const std::string& part : bad.parts) {
      EXPECT_TRUE(contains(outcome.err, part)) << bad.what << ": no '" << part << "' in " << outcome.err;
    }
    EXPECT_EQ(scratch_.files(), Names{"sky.json"}) << bad.what;
  }
}

TEST_F(Refusal, AForeignOrDamagedExrIsRefused) {
  scratch_.write("foreign.exr", "\x76\x2f\x31\x01 and then nothing of use");
  EXPECT_EQ(tool({"render", "foreign.exr", "-o", "a.exr"}).exit_code, 2);
  scratch_.write("named.exr", std::string("\x01\x02\0\x03", 4));
  const Outcome named = tool({"render", "named.exr", "-o", "a.exr"});
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_TRUE(contains(named.err, "named.exr: is no picture")) << named.err;
  ASSERT_EQ(tool({"render", "sky.json", "-q", "-o", "ours.exr"}).exit_code, 0);
  scratch_.write("cut.exr", scratch_.read("ours.exr").substr(0, 100));
  const Outcome outcome = tool({"render", "cut.exr", "-o", "a.exr"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"cut.exr", "foreign.exr", "named.exr", "ours.exr", "sky.json"}));
}

TEST_F(Refusal, PlacesThatCannotBeWrittenAreSaidFirst) {
  // Without a driver a render would exit 1; exit 2 shows that the place is checked first.
  const Start no_driver = without_driver();
  std::filesystem::create_directory(scratch_.path() / "folder.exr");
  EXPECT_EQ(tool({"render", "sky.json", "-o", "folder.exr"}, no_driver).exit_code, 2);
  EXPECT_EQ(tool({"render", "sky.json", "-o", "no/where.exr"}, no_driver).exit_code, 2);
  EXPECT_EQ(tool({"render", "sky.json", "-o", "sky.json/a.exr"}, no_driver).exit_code, 2);
  EXPECT_EQ(tool({"luts", "sky.json", "-o", "sky.json"}, no_driver).exit_code, 2);
  scratch_.write("out", "a file where the folder should be");
  EXPECT_EQ(tool({"render", "sky.json"}, no_driver).exit_code, 2);
  std::filesystem::create_directory(scratch_.path() / "locked");
  std::filesystem::permissions(scratch_.path() / "locked", std::filesystem::perms::owner_read);
  Start as_others = no_driver;
  as_others.without_root = true;
  EXPECT_EQ(tool({"render", "sky.json", "-o", "locked/a.exr"}, as_others).exit_code, 2);
}

}  // namespace
}  // namespace airlight::test
