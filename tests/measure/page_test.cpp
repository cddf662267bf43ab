// The page's structure and its pictures. tests/cli/page_test.cpp looks at it in a browser.
#include "core/measure/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/measure/judge.h"
#include "core/measure/reduce_pictures.h"

namespace airlight::measure {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Red alone, `columns` x `rows`, B all 1.
PicturePair picture_pair(int columns, int rows, std::vector<float> a) {
  PicturePair pair;
  pair.frame = {.width = columns, .height = rows, .left = 0, .top = 0, .columns = columns, .rows = rows};
  std::vector<float> b(a.size(), 1.0F);
  pair.planes.push_back({.name = "Y", .a = std::move(a), .b = std::move(b), .sigma = {}});
  return pair;
}

double red(const std::vector<std::byte>& rgbe, std::size_t pixel) {
  const auto part = [&](std::size_t k) { return std::to_integer<int>(rgbe[4 * pixel + k]); };
  return part(0) * std::ldexp(1.0, part(3) - 136);
}

TEST(ReducePictures, KeepsEveryMagnitudeWithin8Bits) {
  const std::vector<float> values = {0.0F, 1e-30F, 3.3e-9F, 0.999F, 1.0F, 0.5F, 14700.0F, 65504.0F, 1e30F, 255.99F};
  const PicturePair pair = picture_pair(10, 1, values);
  const ShownPictures shown = reduce_pictures(pair, std::vector<float>(10, 0.0F), {}, 100);
  EXPECT_EQ(shown.reduced, 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = static_cast<double>(values[i]);
    EXPECT_NEAR(red(shown.a, i), value, value / 256.0) << value;
  }
}

TEST(ReducePictures, MarksWhatIsNotFiniteAndShowsNegativesAsBlack) {
  const PicturePair pair = picture_pair(4, 1, {kInfinity, -kInfinity, std::nanf(""), -1.0F});
  const ShownPictures shown = reduce_pictures(pair, {kInfinity, 0.0F, 5.0F, 1e-9F}, {}, 100);
  for (const std::size_t pixel : {0U, 1U, 2U}) EXPECT_EQ(std::to_integer<int>(shown.a[4 * pixel + 3]), 255);
  EXPECT_EQ(red(shown.a, 3), 0.0);
  EXPECT_EQ(shown.errors, (std::vector<std::byte>{std::byte{255}, std::byte{0}, std::byte{254}, std::byte{0}}));
}

TEST(ReducePictures, TakesMeansOfPicturesAndTheLargestOfErrors) {
  // 5 x 3 pixels in blocks of 2: the last column and row of blocks are half blocks.
  std::vector<float> a(15, 2.0F);
  std::vector<float> errors(15, 0.0F);
  a[0] = 6.0F;
  errors[6] = 1e-2F;  // column 1, row 1
  errors[14] = kInfinity;
  const ShownPictures shown = reduce_pictures(picture_pair(5, 3, a), errors, {}, 6);
  EXPECT_EQ(shown.reduced, 2);
  EXPECT_EQ(shown.width, 3);
  EXPECT_EQ(shown.height, 2);
  EXPECT_EQ(red(shown.a, 0), 3.0);
  EXPECT_EQ(red(shown.a, 1), 2.0);
  EXPECT_EQ(red(shown.a, 5), 2.0);
  EXPECT_EQ(shown.errors[0], std::byte{254});
  EXPECT_EQ(shown.errors[1], std::byte{0});
  EXPECT_EQ(shown.errors[5], std::byte{255});
}

TEST(Page, PicturesOfAnyNumberOfPairsAreBounded) {
  EXPECT_EQ(page_pixels(1), 960U * 540U);
  for (const std::size_t pairs : {2U, 10U, 288U, 100000U}) EXPECT_LE(pairs * page_pixels(pairs), 1500000U);
  const ShownPictures shown =
      reduce_pictures(picture_pair(1000, 3, std::vector<float>(3000, 1.0F)), std::vector<float>(3000, 0.0F), {}, 1);
  EXPECT_EQ(shown.width * shown.height, 1);
}

NamedReport compared(const std::string& name, float value) {
  NamedReport entry{.name = name, .a = "new/" + name, .b = "old/" + name, .report = {}, .pictures = {}};
  const PicturePair pair = picture_pair(2, 2, {value, 1.0F, 1.0F, 1.0F});
  Limits limits = limits_in_force({}, false);
  limits.relative_mean = 0.5;
  limits.warn = 1e-9;
  const std::vector<float> errors = analyse(pair, limits, entry.report);
  judge(limits, false, entry.report);
  entry.report.presets_known = true;
  entry.report.preset_keys = {{"/media/0/name", "\"<b>\"", ""}};
  entry.report.shown = reduce_pictures(pair, errors, scale_for(errors, false, {}), page_pixels(3));
  return entry;
}

NamedReport unknown(const std::string& name) {
  NamedReport entry{.name = name, .a = "", .b = "old/" + name, .report = {}, .pictures = {}};
  entry.report.problem = "is not there & never was";
  return entry;
}

std::string sample_page() {
  return html_page({compared("small.exr", 1.25F), unknown("gone.exr"), compared("</title><script>x", 1.5F)}, "<a>",
                   "b & c");
}

// Throws where an element is closed that was not the last one opened. HTML treats script and style as text.
void check_nesting(std::string page) {
  constexpr std::array<std::string_view, 3> kVoid = {"meta", "input", "br"};
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at)) {
    if (page.compare(at, 4, "<!--") == 0) {
      at = page.find("-->", at);
      continue;
    }
    const bool closes = page[at + 1] == '/';
    const std::size_t start = at + (closes ? 2 : 1);
    const std::string name = page.substr(start, page.find_first_of(" >\n", start) - start);
    at = page.find('>', start);
    if (at == std::string::npos) throw std::runtime_error("tag without an end: " + name);
    if (name == "!DOCTYPE" || std::find(kVoid.begin(), kVoid.end(), name) != kVoid.end()) continue;
    if (!closes) {
      open.push_back(name);
      if (name == "script" || name == "style") at = page.find("</" + name + ">", at);
    } else if (open.empty() || open.back() != name) {
      throw std::runtime_error("</" + name + "> closes " + (open.empty() ? "nothing" : open.back()));
    } else {
      open.pop_back();
    }
  }
  if (!open.empty()) throw std::runtime_error(open.back() + " is not closed");
}

TEST(Page, IsWellFormedWhateverTheNames) {
  const std::string page = sample_page();
  EXPECT_NO_THROW(check_nesting(page));
  EXPECT_THROW(check_nesting("<p><b></p></b>"), std::runtime_error);
  EXPECT_NE(page.find("&lt;/title&gt;&lt;script&gt;x"), std::string::npos);
  EXPECT_EQ(page.find("</title><script>x"), std::string::npos);
  EXPECT_NE(page.find("<h1>airlight diff: &lt;a&gt; against b &amp; c</h1>"), std::string::npos);
  EXPECT_EQ(page.find("{{c"), std::string::npos) << "a place in the template was not filled";
  EXPECT_EQ(page.find("{{t"), std::string::npos) << "a place in the template was not filled";
}

TEST(Page, AsksTheNetworkForNothing) {
  const std::string page = sample_page();
  for (const char* word : {"http:", "https:", "src=", "url(", "@import", "<link", "<img", "fetch(", "XMLHttp"}) {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (std::size_t at = page.find("href=\""); at != std::string::npos; at = page.find("href=\"", at + 1)) {
    EXPECT_EQ(page[at + 6], '#');
  }
}

TEST(Page, PutsTheUnknownFirstThenTheWorst) {
  const std::string page = sample_page();
  const std::size_t gone = page.find("<a href=\"#pair-1\">gone.exr");
  const std::size_t worst = page.find("<a href=\"#pair-2\">&lt;/title");
  const std::size_t small = page.find("<a href=\"#pair-3\">small.exr");
  ASSERT_NE(gone, std::string::npos);
  ASSERT_NE(worst, std::string::npos);
  ASSERT_NE(small, std::string::npos);
  EXPECT_LT(gone, worst);
  EXPECT_LT(worst, small);
  EXPECT_LT(page.find("<section id=\"pair-2\">"), page.find("<section id=\"pair-3\">"));
  EXPECT_NE(page.find("is not there &amp; never was"), std::string::npos);
}

// Everything is in tables, so that it can be read without a script.
TEST(Page, TablesHoldKeysLimitsRegionsAndTheWorstPixel) {
  const std::string page = sample_page();
  for (const char* part :
       {"<td class=\"text\"><code>&quot;&lt;b&gt;&quot;</code></td><td class=\"text\">absent</td>",
        "pixels above 1e-06 (--fail)</th><td class=\"text\"><span class=\"fails\">fails</span></td><td>0 % of "
        "pixels</td><td>25 % of pixels</td>",
        "(--rel-mean)</th><td class=\"text\"><span class=\"holds\">holds</span></td><td>0.5</td><td>0.125</td>",
        "(--warn)</th><td class=\"text\"><span class=\"warns\">warns</span>",
        "<th scope=\"row\">relative</th><td>50%</td><td>(0, 0)</td><td>Y</td><td>1.5</td><td>1</td>",
        "<th scope=\"row\">picture</th><td class=\"text\">pooled</td><td>4</td><td>12.5%</td>"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

}  // namespace
}  // namespace airlight::measure
