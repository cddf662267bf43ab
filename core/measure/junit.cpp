#include <algorithm>

#include "core/base/text.h"
#include "core/measure/report.h"
#include "core/scene/printable.h"

namespace airlight::measure {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

// Bytes of the valid UTF-8 character at `at` that XML 1.0 allows; 0 where there is none.
std::size_t character_length(std::string_view text, std::size_t at) {
  const Character c = character_at(text, at);
  const bool allowed = c.code >= 0x20U || c.code == '\t' || c.code == '\n' || c.code == '\r';
  return allowed && c.code != 0xFFFEU && c.code != 0xFFFFU ? c.bytes : 0;
}

std::string_view entity(char letter) {
  switch (letter) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&apos;";
    default:
      return "";
  }
}

std::string case_xml(const NamedReport& entry) {
  const ComparisonReport& report = entry.report;
  std::string xml = "  <testcase classname=\"airlight.diff\" name=\"" + xml_escaped(entry.name) + "\">\n";
  const bool causes_follow = report.verdict != Verdict::pass;  // describe_briefly has them then
  const std::string body = xml_escaped("A " + entry.a + "\nB " + entry.b + "\n" + describe_briefly(entry) +
                                       (causes_follow ? "" : describe_causes(entry)));
  if (report.verdict == Verdict::differ) {
    xml += "    <failure type=\"differ\" message=\"" + xml_escaped(joined(report.reasons, "; ")) + "\">" + body +
           "</failure>\n";
  } else if (report.verdict == Verdict::cannot_compare) {
    xml += "    <error type=\"cannot compare\" message=\"" + xml_escaped(report.problem) + "\">" + body + "</error>\n";
  } else {
    xml += "    <system-out>" + body + "</system-out>\n";
  }
  return xml + "  </testcase>\n";
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0) {
      escaped += kReplacement;
      ++i;
    } else if (const std::string_view named = entity(text[i]); !named.empty()) {
      escaped += named;
      ++i;
    } else {
      escaped += text.substr(i, length);
      i += length;
    }
  }
  return escaped;
}

std::string junit_xml(const std::vector<NamedReport>& entries) {
  const auto count = [&](Verdict verdict) {
    return std::to_string(
        std::ranges::count_if(entries, [&](const NamedReport& entry) { return entry.report.verdict == verdict; }));
  };
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"airlight diff\" tests=\"" +
                    std::to_string(entries.size()) + "\" failures=\"" + count(Verdict::differ) + "\" errors=\"" +
                    count(Verdict::cannot_compare) + "\">\n";
  for (const NamedReport& entry : entries) xml += case_xml(entry);
  return xml + "</testsuite>\n";
}

}  // namespace airlight::measure
