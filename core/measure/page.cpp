#include "core/measure/page.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

#include "core/base/text.h"
#include "core/measure/colour_map.h"
#include "core/measure/words.h"

namespace airlight::measure {
namespace {

using Cells = std::vector<std::string>;  // HTML

std::string element(const std::string& tag, const std::string& inside) {
  return "<" + tag + ">" + inside + "</" + tag.substr(0, tag.find(' ')) + ">";
}

std::string code(std::string_view text) {
  return element("code", xml_escaped(text));
}

// The first `texts` columns are text, the others numbers.
std::string table(const std::string& caption, std::size_t texts, const Cells& heads, const std::vector<Cells>& rows) {
  std::string html = element("caption", caption) + "<thead><tr>";
  for (std::size_t i = 0; i < heads.size(); ++i) {
    html += element(i < texts ? "th scope=\"col\" class=\"text\"" : "th scope=\"col\"", heads[i]);
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const Cells& row : rows) {
    html += "<tr>" + element("th scope=\"row\"", row.front());
    for (std::size_t i = 1; i < row.size(); ++i) html += element(i < texts ? "td class=\"text\"" : "td", row[i]);
    html += "</tr>\n";
  }
  return "<div class=\"scroll\">" + element("table", html + "</tbody>") + "</div>\n";
}

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned int group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? std::to_integer<unsigned int>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * static_cast<unsigned int>(k)) & 63U];
    }
  }
  return text;
}

// Six hexadecimal digits for each of the codes of ShownPictures::errors.
std::string colour_list() {
  std::string list;
  for (int i = 0; i < 256; ++i) {
    const Colour colour = i == 255 ? kNotANumber : error_colour(i / 254.0);
    for (const std::uint8_t part : colour) {
      std::array<char, 3> digits{};
      std::snprintf(digits.data(), digits.size(), "%02x", static_cast<unsigned int>(part));
      list += digits.data();
    }
  }
  return list;
}

std::string verdict_html(Verdict verdict) {
  const char* const name = verdict == Verdict::pass     ? "pass"
                           : verdict == Verdict::warn   ? "warn"
                           : verdict == Verdict::differ ? "differ"
                                                        : "cannot";
  return element("span class=\"" + std::string(name) + "\"", verdict_words(verdict));
}

const ChannelReport& pooled_of(const AreaReport& area) {
  return area.channels.back();
}

std::string place_words(const PixelReport& pixel) {
  return "(" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
}

// Enough digits to tell two floats apart.
std::string value_words(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.7g", value);
  return text.data();
}

std::string overview(const std::vector<const NamedReport*>& sorted) {
  std::vector<Cells> rows;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const ComparisonReport& report = sorted[i]->report;
    Cells row = {"<a href=\"#pair-" + std::to_string(i + 1) + "\">" + xml_escaped(sorted[i]->name) + "</a>",
                 verdict_html(report.verdict)};
    if (report.areas.empty()) {
      row.push_back(xml_escaped(report.problem));
      row.insert(row.end(), 4, "");
    } else {
      const ChannelReport& pooled = pooled_of(report.areas.front());
      const std::string why = joined_of(report.reasons, xml_escaped, "<br>");
      row.insert(row.end(),
                 {why, percent(pooled.relative.mean), percent(pooled.relative.p95), percent(pooled.relative.max),
                  pooled.relative.max > 0.0 ? place_words(pooled.worst_relative) : ""});
    }
    rows.push_back(row);
  }
  return table("Pairs by the largest relative error, colour channels pooled", 3,
               {"Picture", "Verdict", "Why", "Mean", "95 %", "Largest", "There"}, rows);
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" data-") + name + "=\"" + xml_escaped(value) + "\"";
}

std::string precise(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

std::string figure(const NamedReport& entry) {
  const ShownPictures& shown = *entry.report.shown;
  const PixelReport& worst = pooled_of(entry.report.areas.front()).worst_relative;
  std::string html =
      "<figure class=\"view\"" + attribute("name", entry.name) + attribute("width", std::to_string(shown.width)) +
      attribute("height", std::to_string(shown.height)) + attribute("left", std::to_string(shown.left)) +
      attribute("top", std::to_string(shown.top)) + attribute("reduced", std::to_string(shown.reduced)) +
      attribute("low", precise(shown.low)) + attribute("high", precise(shown.high)) +
      attribute("error-name", shown.error_name) + attribute("logarithmic", shown.logarithmic ? "true" : "false") +
      attribute("exposure", precise(shown.exposure)) + attribute("worst-x", std::to_string(worst.x)) +
      attribute("worst-y", std::to_string(worst.y)) + attribute("a", base64(shown.a)) +
      attribute("b", base64(shown.b)) + attribute("errors", base64(shown.errors)) + ">\n";
  std::string caption = std::to_string(entry.report.width) + " x " + std::to_string(entry.report.height) + " pixels";
  if (shown.reduced > 1) {
    caption += ", shown at 1/" + std::to_string(shown.reduced) +
               ": a pixel here is the mean of its pixels, and its error the largest of theirs";
  }
  return html + element("figcaption", caption) +
         "<noscript><p>The pictures are drawn by JavaScript; the tables do without.</p></noscript>\n</figure>\n";
}

std::string keys_table(const ComparisonReport& report) {
  if (!report.presets_known) return "<p>The files do not both carry a preset to compare.</p>\n";
  if (report.preset_keys.empty()) return "<p>The presets are equal.</p>\n";
  std::vector<Cells> rows;
  const auto value = [](const std::string& text) { return text.empty() ? "absent" : code(text); };
  for (const KeyDifference& key : report.preset_keys) rows.push_back({code(key.pointer), value(key.a), value(key.b)});
  return table("Preset keys that differ", 3, {"Key", "New", "Reference"}, rows);
}

std::string limits_table(const ComparisonReport& report) {
  std::vector<Cells> rows;
  for (const LimitCheck& check : report.checks) {
    const char* const result = check.holds        ? "span class=\"holds\">holds"
                               : check.only_warns ? "span class=\"warns\">warns"
                                                  : "span class=\"fails\">fails";
    rows.push_back({xml_escaped(check.limit), "<" + std::string(result) + "</span>", check.allowed, check.measured});
  }
  return table("Limits", 2, {"Limit", "Result", "Allowed", "Measured"}, rows);
}

std::string worst_table(const AreaReport& area) {
  const ChannelReport& pooled = pooled_of(area);
  const auto row = [](const char* what, const std::string& error, const PixelReport& pixel) -> Cells {
    const auto degrees = [](const std::optional<double>& angle) { return angle ? number(*angle) : "unknown"; };
    return {what,
            error,
            place_words(pixel),
            xml_escaped(pixel.channel),
            value_words(pixel.a),
            value_words(pixel.b),
            degrees(pixel.elevation_deg),
            degrees(pixel.azimuth_deg)};
  };
  return table("Worst pixel", 1,
               {"Error", "Value", "Pixel", "Channel", "New", "Reference", "Elevation, degrees", "Azimuth, degrees"},
               {row("relative", percent(pooled.relative.max), pooled.worst_relative),
                row("absolute", number(pooled.absolute.max), pooled.worst_absolute)});
}

std::string regions_table(const ComparisonReport& report) {
  const bool in_sigmas = pooled_of(report.areas.front()).chi_square.has_value();
  std::vector<Cells> rows;
  for (const AreaReport& area : report.areas) {
    for (auto channel = area.channels.rbegin(); channel != area.channels.rend(); ++channel) {  // pooled first
      const ErrorSummary& e = channel->relative;
      rows.push_back({xml_escaped(area.name), xml_escaped(channel->name), std::to_string(area.pixels), percent(e.mean),
                      percent(e.p50), percent(e.p95), percent(e.p99), percent(e.max),
                      percent(channel->deviation.bias()), number(channel->deviation.rms())});
      if (in_sigmas) rows.back().push_back(channel->chi_square ? number(channel->chi_square->per_value()) : "");
    }
  }
  Cells heads = {"Region", "Channel", "Pixels", "Mean", "Median", "95 %", "99 %", "Largest", "Bias", "RMS, absolute"};
  if (in_sigmas) heads.push_back("Chi-square per value");
  return table(
      "Relative error by region: |new - reference| / max(|reference|, " + number(kRelativeFloor) + " of its mean)", 2,
      heads, rows);
}

std::string pair_section(const NamedReport& entry, std::size_t place) {
  const ComparisonReport& report = entry.report;
  const auto file = [](const std::string& name) { return name.empty() ? "none" : code(name); };
  std::string html = element("h2", xml_escaped(entry.name) + ": " + verdict_html(report.verdict)) + "\n" +
                     element("p", "New: " + file(entry.a) + "<br>Reference: " + file(entry.b)) + "\n";
  if (!report.problem.empty()) html += element("p", xml_escaped(report.problem)) + "\n";
  for (const std::string& note : report.notes) html += element("p", "Note: " + xml_escaped(note)) + "\n";
  if (report.shown) html += figure(entry);
  if (!report.areas.empty()) {
    html += keys_table(report) + limits_table(report) + worst_table(report.areas.front()) + regions_table(report);
  }
  return "<section id=\"pair-" + std::to_string(place) + "\">\n" + html + "</section>\n";
}

void fill(std::string& page, const std::string& name, const std::string& text) {
  const std::string mark = "{{" + name + "}}";
  for (std::size_t at = page.find(mark); at != std::string::npos; at = page.find(mark, at + text.size())) {
    page.replace(at, mark.size(), text);
  }
}

}  // namespace

std::size_t page_pixels(std::size_t pairs) {
  constexpr std::size_t kOnePicture = 960U * 540U;
  constexpr std::size_t kAllTogether = 1'500'000;
  return std::clamp<std::size_t>(kAllTogether / std::max<std::size_t>(pairs, 1), 1, kOnePicture);
}

std::string html_page(const std::vector<NamedReport>& entries, std::string_view a, std::string_view b) {
  const std::vector<const NamedReport*> sorted = worst_first(entries);
  std::string content = element("p", verdict_html(overall(entries)) + ". " + xml_escaped(describe_all(entries))) + "\n";
  if (sorted.size() > 1) content += overview(sorted);
  for (std::size_t i = 0; i < sorted.size(); ++i) content += pair_section(*sorted[i], i + 1);
  std::string page(page_template());
  fill(page, "colours", colour_list());
  fill(page, "title", xml_escaped("airlight diff: " + std::string(a) + " against " + std::string(b)));
  fill(page, "content", content);  // last, since text inside it is not searched
  return page;
}

}  // namespace airlight::measure
