// The comparison of files, with all cases that reading them can bring.
#include "core/measure/compare.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "core/measure/report.h"
#include "core/output/exr.h"

namespace airlight::measure {
namespace {

namespace fs = std::filesystem;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const std::vector<std::string> kRgb = {"R", "G", "B"};

class Compare : public testing::Test {
 protected:
  Compare() {
    std::string pattern = (fs::temp_directory_path() / "airlight-compare-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error(pattern);
    folder_ = pattern;
  }
  ~Compare() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  // Rows of four pixels; every sample is `value`, the first pixel's `first`.
  std::string write(const std::string& name, float value, float first, const std::vector<std::string>& channels = kRgb,
                    int width = 8, const std::string& preset = "") {
    std::vector<float> samples(static_cast<std::size_t>(width) * 4, value);
    samples[0] = first;
    std::vector<ExrChannel> list;
    for (const std::string& channel : channels) {
      list.push_back({.name = channel, .first = samples.data(), .stride = 1});
    }
    ExrOptions options;
    options.half = false;
    if (!preset.empty()) {
      options.provenance = Provenance{.preset_json = preset, .method = "m", .version = "v", .device = "d"};
    }
    write_exr(path(name), width, 4, list, options);
    return path(name);
  }
  std::string write(const std::string& name, float value) { return write(name, value, value); }
  std::string put(const std::string& name, const std::string& text) {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  static ComparisonReport compare(const ComparisonRequest& request) { return measure::compare(request); }
  static ComparisonReport compare(const std::string& a, const std::string& b) {
    ComparisonRequest request;
    request.a = a;
    request.b = b;
    return compare(request);
  }

  static void expect_problem(const ComparisonRequest& request, const std::string& words) {
    const ComparisonReport report = compare(request);
    EXPECT_EQ(report.verdict, Verdict::cannot_compare);
    EXPECT_NE(report.problem.find(words), std::string::npos) << report.problem;
    EXPECT_EQ(report.problem.find('\n'), std::string::npos);
    EXPECT_TRUE(report.heatmap_png.empty());
  }

 private:
  fs::path folder_;
};

TEST_F(Compare, ReadsValuesExactly) {
  const ComparisonReport report = compare(write("a.exr", 0.5F, 0.75F), write("b.exr", 0.5F));
  EXPECT_EQ(report.verdict, Verdict::differ);
  EXPECT_EQ(report.width, 8);
  EXPECT_EQ(report.height, 4);
  EXPECT_EQ(report.channels, kRgb);
  EXPECT_EQ(report.pixels_over_fail, 1U);
  const ChannelReport& pooled = report.areas.front().channels.back();
  EXPECT_EQ(pooled.relative.max, 0.5);
  EXPECT_EQ(pooled.worst_relative.a, 0.75);
  EXPECT_EQ(pooled.worst_relative.b, 0.5);
}

// Debian's idiff passes two pictures of NaN, even with -hardfail.
TEST_F(Compare, AllNanDoesNotPass) {
  ComparisonRequest request;
  request.a = write("a.exr", kNan);
  request.b = write("b.exr", kNan);
  EXPECT_EQ(compare(request).verdict, Verdict::differ);
  request.limits.fail = 1e30;
  request.limits.fail_percent = 100.0;
  const ComparisonReport report = compare(request);
  EXPECT_EQ(report.verdict, Verdict::differ);
  EXPECT_EQ(report.unequal_nonfinite, 32U);
  ASSERT_EQ(report.nonfinite.size(), 3U);
  EXPECT_EQ(report.nonfinite[1].channel, "G");
  EXPECT_EQ(report.nonfinite[1].nan_a, 32U);
  EXPECT_EQ(report.nonfinite[1].infinite_b, 0U);
  request.allow_nonfinite = true;
  EXPECT_EQ(compare(request).verdict, Verdict::pass);
  request.b = write("c.exr", std::numeric_limits<float>::infinity());
  EXPECT_EQ(compare(request).verdict, Verdict::differ);
}

// Row by row: a later channel's earlier row comes first, and of one pixel the first channel.
TEST_F(Compare, TheFirstNonfiniteValueIsNamed) {
  ComparisonRequest request;
  request.a = write("a.exr", 0.5F);
  request.b = write("b.exr", 0.5F);
  EXPECT_FALSE(compare(request).first_nonfinite_a);
  std::vector<float> red(32, 0.5F);
  std::vector<float> green = red;
  red[2 * 8 + 1] = std::numeric_limits<float>::infinity();
  green[1 * 8 + 6] = -std::numeric_limits<float>::infinity();
  green[3 * 8 + 7] = kNan;
  const std::vector<ExrChannel> channels{
      {"R", red.data(), 1, true}, {"G", green.data(), 1, true}, {"B", red.data(), 1, true}};
  write_exr(request.b, 8, 4, channels, {});
  const ComparisonReport report = compare(request);
  EXPECT_FALSE(report.first_nonfinite_a);
  ASSERT_TRUE(report.first_nonfinite_b);
  EXPECT_EQ(report.first_nonfinite_b->x, 6);
  EXPECT_EQ(report.first_nonfinite_b->y, 1);
  EXPECT_EQ(report.first_nonfinite_b->channel, "G");
  EXPECT_NE(describe({"", "a", "b", report}, {}).find("The first of B is at column 6, row 1, channel G\n"),
            std::string::npos);
}

// Debian's idiff pads the smaller with zeros.
TEST_F(Compare, DifferentSizesAreNotPadded) {
  ComparisonRequest request;
  request.a = write("a.exr", 0.0F);
  request.b = write("b.exr", 0.0F, 0.0F, kRgb, 9);
  request.limits.fail = 1e30;
  request.heatmap = true;
  expect_problem(request, "a.exr is 8x4, ");
}

TEST_F(Compare, ChannelsMustAgreeOrBeChosen) {
  ComparisonRequest request;
  request.a = write("a.exr", 1.0F, 1.0F, {"R", "G", "B", "Z"});
  request.b = write("b.exr", 1.0F);
  expect_problem(request, "compare what both have with --channels R,G,B");
  request.channels = kRgb;
  EXPECT_EQ(compare(request).verdict, Verdict::pass);
  request.channels = {"R", "Z"};
  expect_problem(request, "b.exr: has no channel 'Z'; it has R, G, B");
}

TEST_F(Compare, AlphaOfOneAloneIsLeftOutWithANote) {
  const std::string rgb = write("rgb.exr", 1.0F);
  const std::string rgba = write("rgba.exr", 1.0F, 1.0F, {"R", "G", "B", "A"});
  const std::string other = write("other.exr", 1.0F, 2.0F, {"R", "G", "B", "A"});
  for (const auto& [a, b] : {std::pair(rgb, rgba), std::pair(rgba, rgb)}) {
    ComparisonRequest request;
    request.a = a;
    request.b = b;
    const ComparisonReport report = compare(request);
    EXPECT_EQ(report.verdict, Verdict::pass);
    EXPECT_EQ(report.channels.size(), 3U);
    EXPECT_EQ(report.notes, std::vector<std::string>{rgba + ": not compared: A, which " + rgb + " has not"});
  }
  ComparisonRequest request;
  request.a = other;
  request.b = rgb;
  EXPECT_EQ(compare(request).verdict, Verdict::differ);
}

TEST_F(Compare, LayersAreApart) {
  ComparisonRequest request;
  request.a = write("a.exr", 1.0F, 1.0F, {"R", "single.Y", "deep.down.Z"});
  request.b = write("b.exr", 1.0F, 2.0F, {"R", "single.Y", "deep.down.Z"});
  request.layer = "single";
  const ComparisonReport report = compare(request);
  EXPECT_EQ(report.channels, std::vector<std::string>{"Y"});
  EXPECT_EQ(report.verdict, Verdict::differ);
  EXPECT_EQ(report.notes.size(), 2U);
  request.layer = "deep.down";
  EXPECT_EQ(compare(request).channels, std::vector<std::string>{"Z"});
  request.layer = "down";
  expect_problem(request, "has no layer 'down'; it has the main picture, 'deep.down', 'single'");
}

TEST_F(Compare, OnlyLayerNeedsNoName) {
  const std::string only = write("a.exr", 1.0F, 1.0F, {"x.R"});
  EXPECT_EQ(compare(only, only).verdict, Verdict::pass);
  const std::string two = write("b.exr", 1.0F, 1.0F, {"x.R", "y.R"});
  ComparisonRequest request;
  request.a = two;
  request.b = two;
  expect_problem(request, "has no main picture, only the layers 'x', 'y'; name one with --layer");
}

TEST_F(Compare, StandardErrorsAddInQuadrature) {
  ComparisonRequest request;
  request.a = write("a.exr", 1.125F);
  request.b = write("b.exr", 1.0F);
  request.standard_errors = {write("s.exr", 0.125F)};
  const ComparisonReport one = compare(request);
  EXPECT_EQ(one.verdict, Verdict::pass);
  EXPECT_DOUBLE_EQ(one.areas.front().channels.back().chi_square->per_value(), 1.0);
  request.standard_errors.push_back(request.standard_errors.front());
  EXPECT_NEAR(compare(request).areas.front().channels.back().chi_square->per_value(), 0.5, 1e-6);
}

TEST_F(Compare, StandardErrorMayBeALayer) {
  ComparisonRequest request;
  request.a = write("a.exr", 1.5F);
  request.b = write("b.exr", 1.0F);
  request.standard_errors = {
      write("s.exr", 0.25F, 0.25F, {"beauty.R", "standard_error.R", "standard_error.G", "standard_error.B"})};
  EXPECT_DOUBLE_EQ(compare(request).areas.front().channels.back().chi_square->per_value(), 4.0);
  request.standard_error_layer = "nothing";
  expect_problem(request, "s.exr: has no layer 'nothing'");
}

TEST_F(Compare, StandardErrorsMustMakeSense) {
  ComparisonRequest request;
  request.a = write("a.exr", 1.0F);
  request.b = request.a;
  request.standard_errors = {write("minus.exr", -1.0F)};
  expect_problem(request, "holds -1, which is no standard error");
  request.standard_errors = {write("nan.exr", kNan)};
  expect_problem(request, "holds nan, which is no standard error");
  request.standard_errors = {write("small.exr", 1.0F, 1.0F, kRgb, 9)};
  expect_problem(request, "sizes differ");
  request.standard_errors = {write("other.exr", 1.0F, 1.0F, {"R", "G"})};
  expect_problem(request, "other.exr: has no channel 'B'");
}

TEST_F(Compare, CutShortAnywhereIsOneLine) {
  const std::string b = write("b.exr", 0.5F, 0.25F);
  std::ostringstream whole;
  whole << std::ifstream(b, std::ios::binary).rdbuf();
  const std::string bytes = whole.str();
  ComparisonRequest request;
  request.b = b;
  request.heatmap = true;
  for (std::size_t length = 0; length < bytes.size(); length += 3) {
    request.a = put("cut.exr", bytes.substr(0, length));
    expect_problem(request, "cut.exr: ");
  }
}

TEST_F(Compare, BrokenBytesNeverCrash) {
  const std::string b = write("b.exr", 0.5F, 0.25F);
  std::ostringstream whole;
  whole << std::ifstream(b, std::ios::binary).rdbuf();
  for (std::size_t place = 4; place < whole.str().size(); place += 2) {
    std::string bytes = whole.str();
    bytes[place] = static_cast<char>(bytes[place] ^ 0x55);
    const ComparisonReport report = compare(put("broken.exr", bytes), b);
    if (report.verdict == Verdict::cannot_compare) {
      EXPECT_EQ(report.problem.find('\n'), std::string::npos);
    }
  }
}

TEST_F(Compare, ALengthBeyondTheFileIsTold) {
  ComparisonRequest request;
  request.b = write("b.exr", 0.5F);
  std::ostringstream whole;
  whole << std::ifstream(request.b, std::ios::binary).rdbuf();
  std::string bytes = whole.str();
  const std::string window("dataWindow\0box2i\0", 17);
  const std::size_t last_row = bytes.find(window) + window.size() + 4 + 12;
  bytes[last_row + 3] = '\x3f';
  request.a = put("long.exr", bytes);
  expect_problem(request, "long.exr: damaged or cut short: it has fewer bytes than its header asks for");
}

TEST_F(Compare, ForeignFilesAreTold) {
  ComparisonRequest request;
  request.b = write("b.exr", 0.5F);
  request.a = put("text.exr", "this is not a picture");
  expect_problem(request, "text.exr: is not an EXR file");
  request.a = path("nowhere.exr");
  expect_problem(request, "nowhere.exr: no such file");
  request.a = path("");
  expect_problem(request, "is a directory");
}

TEST_F(Compare, PresetOfTheFilesTellsRegions) {
  const std::string noon =
      R"({"planet":{"radius_km":6360},"sun":{"elevation_deg":60,"azimuth_deg":0},"camera":{"altitude_km":0.001,)"
      R"("azimuth_deg":0,"pitch_deg":0,"roll_deg":0,"projection":"equirectangular","vertical_fov_deg":60}})";
  std::string later = noon;
  later.replace(later.find("60,\"azimuth"), 2, "59");
  const std::string a = write("a.exr", 1.0F, 1.0F, kRgb, 8, noon);
  const ComparisonReport report = compare(a, write("b.exr", 1.0F, 1.0F, kRgb, 8, later));
  EXPECT_TRUE(report.presets_known);
  ASSERT_EQ(report.preset_keys.size(), 1U);
  EXPECT_EQ(report.preset_keys[0].pointer, "/sun/elevation_deg");
  ASSERT_GT(report.areas.size(), 2U);
  EXPECT_EQ(report.areas[1].name, "sky");
  EXPECT_EQ(report.areas[1].pixels, 16U);
  const ComparisonReport broken = compare(a, write("c.exr", 1.0F, 1.0F, kRgb, 8, "{not json"));
  EXPECT_EQ(broken.verdict, Verdict::pass);
  EXPECT_EQ(broken.areas.size(), 1U);
  EXPECT_EQ(broken.notes.size(), 2U);
}

TEST_F(Compare, DrawsPng) {
  ComparisonRequest request;
  request.a = write("a.exr", 1.0F, kNan);
  request.b = write("b.exr", 1.0F, 2.0F);
  request.heatmap = true;
  request.side_by_side = true;
  const ComparisonReport report = compare(request);
  for (const std::vector<std::byte>* png : {&report.heatmap_png, &report.side_by_side_png}) {
    ASSERT_GT(png->size(), 100U);
    EXPECT_EQ((*png)[1], std::byte{'P'});
    EXPECT_EQ((*png)[3], std::byte{'G'});
  }
}

}  // namespace
}  // namespace airlight::measure
