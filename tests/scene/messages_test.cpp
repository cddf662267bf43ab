// A message quotes little of an input, and nothing that controls a terminal.
#include <algorithm>

#include "core/base/error.h"
#include "core/methods/method.h"
#include "core/scene/preset.h"
#include "core/scene/printable.h"
#include "core/scene/resolve.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

TEST(Printable, EscapesWhatATerminalObeys) {
  struct Case {
    std::string_view text;
    std::string_view shown;
  };
  for (const Case& c :
       {Case{"plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x8c\x85", "plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x8c\x85"},
        Case{"a\nb\tc\rd", "a\\nb\\tc\\u000dd"}, Case{"\x1b[31mred\x1b[0m", "\\u001b[31mred\\u001b[0m"},
        Case{"\x7f", "\\u007f"},  // delete
        Case{"\xc2\x9b"
             "31m",
             "\\u009b31m"},                          // ESC [ as one character
        Case{"\xe2\x80\xae", "\\u202e"},             // turns the writing direction
        Case{"\xe2\x81\xa6", "\\u2066"},             // likewise
        Case{"\xe2\x80\xa8", "\\u2028"},             // a separator of lines
        Case{"\xff\xc3", "\\xff\\xc3"},              // no UTF-8
        Case{"\xc0\x8a", "\\xc0\\x8a"},              // a line break in two bytes is none either
        Case{"\xed\xa0\x80", "\\xed\\xa0\\x80"}}) {  // half of a pair of UTF-16
    EXPECT_EQ(printable(c.text), c.shown);
  }
  EXPECT_EQ(printable("two\nlines\r", true), "two\nlines\\u000d");
}

TEST(Printable, IsShortenedBetweenCharacters) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc...");
  EXPECT_EQ(shortened("a\xc3\xa9z", 2), "a...");
  EXPECT_EQ(quoted_text(std::string(500, 'x')), "\"" + std::string(80, 'x') + "...\"");
  EXPECT_EQ(quoted_text("a\"b\\\n"), "\"a\\\"b\\\\\\n\"");
}

// Expects no control character but the break between two problems, and no very long line.
void expect_short_and_plain(const std::string& message, std::size_t most_lines) {
  EXPECT_FALSE(message.empty());
  EXPECT_EQ(printable(message, true), message);
  EXPECT_LE(static_cast<std::size_t>(std::ranges::count(message, '\n')), most_lines - 1);
  for (std::size_t start = 0; start < message.size();) {
    const std::size_t end = std::min(message.find('\n', start), message.size());
    EXPECT_LT(end - start, 700U) << message.substr(start, 200);
    start = end + 1;
  }
}

TEST(Messages, QuoteLittleOfAnyInput) {
  const std::string million(1000000, 'x');
  for (const std::string& text :
       {"{\"airlight\": 1 /* " + million,                         // a comment that does not end
        "{\"airlight\": \"" + million,                            // a string that does not end
        million,                                                  // no JSON
        "{\"airlight\": 1" + std::string(100000, '0') + "e999}",  // a number of many digits
        with_one_medium("\"render\": {\"method\": \"" + million + "\"}"),
        with_one_medium("\"sun\": {\"elevation_deg\": \"" + million + "\"}"),
        with_one_medium("\"" + million + "\": 1"),                          // a key
        with_one_medium("\"" + million + "\": 1, \"" + million + "\": 1"),  // a key twice
        with_one_medium("\"render\": {\"" + million + "\": 1}"), with_one_medium("\"extends\": \"" + million + "\"")}) {
    SCOPED_TRACE(text.substr(0, 60));
    expect_short_and_plain(problems_of(text), 1);
  }
}

TEST(Messages, EscapeWhatATerminalObeys) {
  for (const std::string evil :
       {R"(\u001b[2J)", R"(a\nairlight: all is well)", R"(\u009b31m)", R"(\u202e)", R"(\u007f)"}) {
    for (const std::string& text :
         {with_one_medium("\"" + evil + "\": 1"), with_one_medium("\"sun\": {\"elevation_deg\": \"" + evil + "\"}"),
          with_one_medium("\"render\": {\"method\": \"" + evil + "\"}"),
          with_one_medium("\"camera\": {\"projection\": \"" + evil + "\"}"),
          "{\"" + evil + "\": 1, \"" + evil + "\": 2}", "{\"airlight\": 1, \"extends\": \"" + evil + "\"}"}) {
      SCOPED_TRACE(text);
      const std::string message = problems_of(text);
      EXPECT_FALSE(message.empty());
      EXPECT_EQ(printable(message, true), message);
      EXPECT_EQ(message.find("\nairlight: all is well"), std::string::npos);
    }
  }
  expect_short_and_plain(problems_of("{\"a\": \x1b[31m}"), 1);
  expect_short_and_plain(problems_of("{\"a\": \"\xff\"}"), 1);
}

TEST(Messages, TellTwentyProblemsAndCountTheRest) {
  std::string keys;
  for (int i = 0; i < 1000; ++i) {
    keys += (keys.empty() ? "\n\"" : ",\n\"") + std::string("unknown_") + std::to_string(i) + "\": 1";
  }
  const std::string message = problems_of(with_one_medium(keys));
  expect_short_and_plain(message, 21);
  EXPECT_EQ(std::ranges::count(message, '\n'), 20);
  EXPECT_TRUE(message.starts_with("test:2: /unknown_0: unknown key"));  // by line, whatever the order of the keys
  EXPECT_NE(message.find("test:21: /unknown_19"), std::string::npos);
  EXPECT_TRUE(message.ends_with("\ntest: 980 problems more")) << message;
  EXPECT_TRUE(InputError::of_lines("a\nb").has_lines);
  EXPECT_FALSE(InputError("a\nb").has_lines);
}

// Text 77002527 of the fuzzer: a second message quoted the method's name as JSON does, which leaves U+202E as it is.
TEST(Messages, NoNameInThemIsObeyedByATerminal) {
  const std::string text =
      with_one_medium(R"("planet": {"terrain": {"ridge": {}, "width_km": 40}}, "render": {"method": "\u202e"})");
  std::string problems;
  try {
    resolve(parse_preset(text, "test", {}), method_infos());
  } catch (const InputError& error) {
    problems = error.what();
  }
  EXPECT_NE(problems.find("knows no terrain"), std::string::npos) << problems;
  EXPECT_EQ(printable(problems, true), problems);
}

// A NUL ended the message where it stands.
TEST(Messages, ANameWithANulIsToldWhole) {
  const std::string problems = problems_of(
      R"({"airlight": 1, "media": [{"name": "a", "scattering_per_km": {"file": "a\u0000b.csv"},
          "density": {"profile": "exponential", "scale_height_km": 8}}]})");
  EXPECT_NE(problems.find("a\\u0000b.csv cannot be read: no file has a NUL in its name; expected lines of nm,value"),
            std::string::npos)
      << problems;
}

// The search for what was meant is for people, not for a million keys.
TEST(Messages, AMillionUnknownKeysAreNotSearchedFor) {
  std::string keys;
  for (int i = 0; i < 1000; ++i) {
    keys += ", \"altitude_km" + std::to_string(i) + "\": 1";
  }
  const std::string problems = problems_of(R"({"airlight": 1, "camera": {"roll_deg": 0)" + keys + "}}");
  EXPECT_NE(problems.find("did you mean \"altitude_km\"?"), std::string::npos) << problems;
  EXPECT_NE(problems.find("problems more"), std::string::npos) << problems;
}

}  // namespace
}  // namespace airlight::test
