#include "core/measure/report.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <stdexcept>

namespace airlight::measure {
namespace {

// Checks the part of XML 1.0 that a report uses; throws where a parser would refuse.
class XmlCheck {
 public:
  explicit XmlCheck(std::string_view text) : text_(text) {}

  // The names of all elements in order.
  std::vector<std::string> elements() {
    expect("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    element();
    skip_text();
    if (at_ != text_.size()) throw std::runtime_error("text after the root");
    return names_;
  }

 private:
  void expect(std::string_view token) {
    if (text_.substr(at_, token.size()) != token) {
      throw std::runtime_error("expected " + std::string(token) + " at " + std::to_string(at_));
    }
    at_ += token.size();
  }
  bool next_is(std::string_view token) const { return text_.substr(at_, token.size()) == token; }

  std::string name() {
    const std::size_t end = text_.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at_);
    if (end == at_) throw std::runtime_error("name expected");
    const std::string word(text_.substr(at_, end - at_));
    at_ = end;
    return word;
  }

  // Character data up to markup; entities must be the five of XML.
  void skip_text(char stop = '<') {
    while (at_ < text_.size() && text_[at_] != stop) {
      const char letter = text_[at_];
      if (letter == '<') throw std::runtime_error("< in an attribute");
      const bool control = static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t';
      if (control) throw std::runtime_error("control character");
      if (letter == '&') entity();
      ++at_;
    }
  }
  void entity() {
    for (const char* known : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      if (next_is(known)) return;
    }
    throw std::runtime_error("bare &");
  }

  void element() {
    expect("<");
    const std::string opened = name();
    names_.push_back(opened);
    while (next_is(" ")) {
      expect(" ");
      name();
      expect("=\"");
      skip_text('"');
      expect("\"");
    }
    expect(">");
    for (skip_text(); !next_is("</"); skip_text()) element();
    expect("</" + opened + ">");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string> names_;
};

NamedReport entry(const std::string& name, Verdict verdict) {
  NamedReport result{.name = name, .a = "a", .b = "b", .report = {}};
  result.report.verdict = verdict;
  if (verdict == Verdict::differ) result.report.reasons = {"5 < 6 & \"so\" on"};
  if (verdict == Verdict::cannot_compare) result.report.problem = "it's <cut>\x01 short";
  return result;
}

TEST(Junit, IsWellFormedWhateverTheNames) {
  const std::string xml = junit_xml({entry("a<b>&\"c\".exr", Verdict::pass), entry("bell\x07.exr", Verdict::differ),
                                     entry("broken\xC3(\xFF.exr", Verdict::cannot_compare),
                                     entry("gr\xC3\xBC\xC3\x9F.exr", Verdict::warn)});
  EXPECT_EQ(XmlCheck(xml).elements(),
            (std::vector<std::string>{"testsuite", "testcase", "system-out", "testcase", "failure", "testcase", "error",
                                      "testcase", "system-out"}));
  EXPECT_NE(xml.find("tests=\"4\" failures=\"1\" errors=\"1\""), std::string::npos);
  EXPECT_NE(xml.find("a&lt;b&gt;&amp;&quot;c&quot;.exr"), std::string::npos);
  EXPECT_NE(xml.find("gr\xC3\xBC\xC3\x9F.exr"), std::string::npos);
}

TEST(Junit, EscapesWhatXmlForbids) {
  EXPECT_EQ(xml_escaped("a\x01z"), "a\xEF\xBF\xBDz");
  EXPECT_EQ(xml_escaped("\xC3"), "\xEF\xBF\xBD");                       // cut short
  EXPECT_EQ(xml_escaped("\xED\xA0\x80").substr(0, 3), "\xEF\xBF\xBD");  // a surrogate
  EXPECT_EQ(xml_escaped("\xF0\x9F\x8C\x9E"), "\xF0\x9F\x8C\x9E");       // four bytes, valid
  EXPECT_EQ(xml_escaped("\xEF\xBF\xBF").substr(0, 3), "\xEF\xBF\xBD");  // U+FFFF
  EXPECT_EQ(xml_escaped("line\nnext\ttab"), "line\nnext\ttab");
}

TEST(Report, WorstVerdictRules) {
  EXPECT_EQ(overall({}), Verdict::pass);
  EXPECT_EQ(overall({entry("1", Verdict::pass), entry("2", Verdict::warn)}), Verdict::warn);
  EXPECT_EQ(overall({entry("1", Verdict::differ), entry("2", Verdict::warn)}), Verdict::differ);
  EXPECT_EQ(overall({entry("1", Verdict::cannot_compare), entry("2", Verdict::differ)}), Verdict::cannot_compare);
}

TEST(Report, PresetKeysComeFirst) {
  NamedReport report = entry("x", Verdict::differ);
  report.report.presets_known = true;
  report.report.preset_keys = {{"/media/0/phase/g", "0.8", "0.76"}};
  report.report.notes = {"a note"};
  const std::string text = describe(report, {});
  const std::size_t key = text.find("/media/0/phase/g: A 0.8, B 0.76");
  ASSERT_NE(key, std::string::npos);
  EXPECT_LT(key, text.find("a note"));
  EXPECT_LT(key, text.find("DIFFER"));
}

TEST(Report, SummaryCountsEachVerdict) {
  const std::string text =
      describe_all({entry("1", Verdict::pass), entry("2", Verdict::pass), entry("3", Verdict::cannot_compare)});
  EXPECT_EQ(text, "3 pairs: 2 pass, 1 cannot compare\n");
}

}  // namespace
}  // namespace airlight::measure
