// Syntax: comments, lines and columns, errors found before the rules apply. Also texts that nobody would write: the
// result is always an InputError, never a crash.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "core/base/error.h"
#include "tests/scene/random_preset.h"
#include "tests/scene/scene_fixture.h"
#include "tests/without_root.h"

namespace airlight::test {
namespace {

TEST(Syntax, TakesComments) {
  EXPECT_EQ(problems_of("// before\n" + with_one_medium("// within\n\"name\": \"a // b\"") + "// after"), "");
  EXPECT_EQ(scene_from(with_one_medium("\"name\": \"a // b\"")).name, "a // b");
}

// The reason is the JSON library's text; the place and the text after it are ours.
void expect_syntax_error(const std::string& text, const std::string& place) {
  const std::string message = problems_of(text);
  const std::string expected = "test:" + place + ": not JSON: syntax error";
  EXPECT_EQ(message.substr(0, expected.size()), expected) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Syntax, NamesLineAndColumn) {
  expect_syntax_error("{\n  \"airlight\": 1\n  \"name\": \"x\"\n}", "3:3");
  expect_syntax_error("{\n  \"airlight\": 1\n  \"a \\\" b\": \"x\"\n}", "3:3");
  expect_syntax_error("{\"airlight\": 1,}", "1:16");
  expect_syntax_error("{\n\"a\": tru\n}", "2:6");
  expect_syntax_error("{\"a\": 1", "1:8");
  expect_syntax_error("{} {}", "1:4");
  expect_syntax_error("{\"a\": 01}", "1:7");
  expect_syntax_error("{'a': 1}", "1:2");
  expect_syntax_error("{\"airlight\": NaN}", "1:14");
  expect_syntax_error("{\"airlight\": -Infinity}", "1:14");
  expect_syntax_error("{\"name\": \"\xff\"}", "1:11");
  expect_syntax_error("}", "1:1");
}

TEST(Syntax, CountsLinesPastNumbersAndWindowsLineEnds) {
  EXPECT_EQ(problems_of("{\"airlight\":\n1\n,\r\n\"media\": 5\n\n,\n\"name\": 7}"),
            "test:4: /media: 5 is no list of media; expected an array of 1 to 8 media\n"
            "test:7: /name: 7 is not a string; expected a string");
}

// The parser reads a line break before it knows that a number has ended.
TEST(Syntax, CountsTheLineOfANumberThatEndsItsLine) {
  EXPECT_EQ(problems_of(with_one_medium("\n\"planet\": {\"ground_albedo\": [\n2\n,\n0\n,\n3]}")),
            "test:3: /planet/ground_albedo/0: 2 is outside 0 to 1\n"
            "test:7: /planet/ground_albedo/2: 3 is outside 0 to 1");
}

TEST(Syntax, RefusesDuplicateKeys) {
  EXPECT_EQ(problems_of("{\n\"airlight\": 1,\n\"sun\": {\"disc\": {\"visible\": true,\n\"visible\": false}}}"),
            "test:4: /sun/disc/visible: duplicate key; the first stands on line 3; keep one of them");
  EXPECT_EQ(problems_of("{\"media\": [{}, {\"name\": \"a\", \"name\": \"a\"}]}"),
            "test:1: /media/1/name: duplicate key; the first stands on line 1; keep one of them");
}

TEST(Syntax, RefusesWhatIsNoObject) {
  EXPECT_EQ(problems_of("[]"), "test:1: not an object; expected {\"airlight\": 1, ...}");
  EXPECT_EQ(problems_of("5"), "test:1: not an object; expected {\"airlight\": 1, ...}");
  EXPECT_EQ(problems_of(" \n "), "test: empty; expected a JSON object, e.g. {\"airlight\": 1, \"extends\": \"earth\"}");
  EXPECT_EQ(problems_of(""), "test: empty; expected a JSON object, e.g. {\"airlight\": 1, \"extends\": \"earth\"}");
}

TEST(Syntax, RefusesNumbersBeyondADouble) {
  EXPECT_EQ(problems_of("{\"sun\": {\n\"irradiance\": [1, 1e999, 1]}}"),
            "test:2: /sun/irradiance/1: 1e999 is too large for a number; expected at most 1.8e308 in magnitude");
  EXPECT_EQ(problems_of("{\"airlight\": 1, \"image\": {\"width\": -1e999}}"),
            "test:1: /image/width: -1e999 is too large for a number; expected at most 1.8e308 in magnitude");
}

TEST(Syntax, RefusesDeepNesting) {
  const std::string message = problems_of("{\"a\": " + std::string(100000, '['));
  EXPECT_NE(message.find(": nested deeper than 64 levels; a preset needs 6"), std::string::npos);
  EXPECT_EQ(message.substr(0, 12), "test:1: /a/0");
}

TEST(Syntax, RefusesAZeroByte) {
  const std::string text = with_one_medium("") + std::string("\n \0 rest", 8);
  EXPECT_EQ(problems_of(text), "test:2:2: not JSON: a zero byte; expected text");
}

void expect_input_error_or_scene(const std::string& text) {
  try {
    scene_from(text);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()), "");
  }
}

TEST(Fuzz, TruncatedTextsAreRefused) {
  const std::string text = random_preset(3);
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_NE(problems_of(text.substr(0, length)), "") << length;
  }
}

TEST(Fuzz, ChangedBytesNeverCrash) {
  std::mt19937_64 random(11);
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    std::string text = random_preset(seed % 20);
    for (std::uint64_t changes = 1 + random() % 4; changes > 0; --changes) {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    expect_input_error_or_scene(text);
  }
}

TEST(Fuzz, GarbageNeverCrashes) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 1000; ++i) {
    std::string text(random() % 200, '\0');
    for (char& c : text) {
      c = static_cast<char>(random() % 256);
    }
    EXPECT_NE(problems_of(text), "");
  }
}

// Values of every type under every key.
TEST(Fuzz, AnyTypeAnywhereIsRefusedOrTaken) {
  constexpr std::array<std::string_view, 12> kValues = {"null", "true", "-1", "1e300",      "\"\"",      "\"x\"",
                                                        "[]",   "[[]]", "{}", "{\"a\": 1}", "[1, 2, 3]", "4e-320"};
  constexpr std::array<std::string_view, 20> kPointers = {"/airlight",
                                                          "/name",
                                                          "/planet",
                                                          "/planet/ground_albedo",
                                                          "/media",
                                                          "/media/0",
                                                          "/media/0/name",
                                                          "/media/0/density",
                                                          "/media/0/density/profile",
                                                          "/media/0/density/scale_height_km",
                                                          "/media/0/phase",
                                                          "/sun",
                                                          "/sun/disc",
                                                          "/camera",
                                                          "/camera/projection",
                                                          "/image/width",
                                                          "/render",
                                                          "/render/sun_fade",
                                                          "/bloom",
                                                          "/display/exposure"};
  for (const std::string_view pointer : kPointers) {
    for (const std::string_view value : kValues) {
      Preset preset = parse_preset(with_one_medium(""), "test", {});
      apply_override(preset, std::string(pointer) + "=" + std::string(value));
      try {
        const Scene scene = resolve(preset, local_methods());
        expect_same(scene, scene_from(to_json(scene)));
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("--set " + std::string(pointer)), std::string::npos) << error.what();
      }
    }
  }
}

TEST_F(FolderTest, FilesThatCannotBeReadAreRefused) {
  EXPECT_EQ(problems_of_file(folder_),
            folder_.string() + ": cannot be read: is a directory; expected a preset (a JSON file)");
  EXPECT_EQ(problems_of_file(folder_ / "absent.json"), (folder_ / "absent.json").string() +
                                                           ": cannot be read: No such file or directory; expected a "
                                                           "preset (a JSON file)");
  EXPECT_EQ(problems_of_file(write("empty.json", "")),
            (folder_ / "empty.json").string() +
                ": empty; expected a JSON object, e.g. {\"airlight\": 1, \"extends\": \"earth\"}");
  EXPECT_EQ(
      problems_of_file(write("large.json", std::string((16U << 20U) + 1U, ' '))),
      (folder_ / "large.json").string() + ": cannot be read: is larger than 16 MiB; expected a preset (a JSON file)");
  EXPECT_EQ(problems_of_file(""), ": cannot be read: No such file or directory; expected a preset (a JSON file)");
}

TEST(Files, ThatFailWhileTheyAreReadAreRefused) {
  EXPECT_EQ(problems_of_file("/proc/self/mem"),
            "/proc/self/mem: cannot be read: Input/output error; expected a preset (a JSON file)");
}

TEST_F(FolderTest, FilesWithoutPermissionAreRefused) {
  const std::filesystem::path file = write("secret.json", with_one_medium(""));
  std::filesystem::permissions(file, std::filesystem::perms::none);
  const std::string told = without_root([&] { return problems_of_file(file); });
  EXPECT_EQ(told, file.string() + ": cannot be read: Permission denied; expected a preset (a JSON file)");
}

}  // namespace
}  // namespace airlight::test
