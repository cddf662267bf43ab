#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tests/cli/diff_fixture.h"

namespace airlight::test {
namespace {

using nlohmann::json;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Diff : public DiffFixture {
 protected:
  // Exit code 2, one line on standard error that holds `words`, nothing on standard output, no file written.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& words) {
    const std::vector<std::string> before = scratch_.files();
    const Outcome outcome = diff(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(scratch_.files(), before);
  }
};

TEST_F(Diff, EqualPicturesPass) {
  write("a.exr", 0.5F);
  write("b.exr", 0.5F);
  const Outcome outcome = diff({"a.exr", "b.exr"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("PASS"), std::string::npos);
}

TEST_F(Diff, DifferentPicturesFailAndTellTheWorstPixel) {
  write("a.exr", 0.5F, 0.75F);
  write("b.exr", 0.5F);
  const Outcome outcome = diff({"a.exr", "b.exr"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("Largest relative error 0.5 in R at pixel (0, 0): A 0.75, B 0.5"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("1 of 32 pixels (3.125 %) differ by more than 1e-06"), std::string::npos);
}

TEST_F(Diff, LimitsDecide) {
  write("a.exr", 0.5F, 0.75F);
  write("b.exr", 0.5F);
  const auto code = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"a.exr", "b.exr"});
    return diff(options).exit_code;
  };
  EXPECT_EQ(code({"--fail", "0.2"}), 1);
  EXPECT_EQ(code({"--failpercent", "4"}), 0);
  EXPECT_EQ(code({"--failpercent", "4", "--hardfail", "0.2"}), 1);
  EXPECT_EQ(code({"--rel-max", "0.4"}), 1);
  EXPECT_EQ(code({"--rel-mean", "0.0157"}), 0);  // 0.5 / 32
  EXPECT_EQ(code({"--rel-mean", "0.0156"}), 1);
  EXPECT_EQ(code({"--rel-p95", "0"}), 0);  // one pixel of 32 is above that rank
  const Outcome warned = diff({"a.exr", "b.exr", "--fail", "1", "--warn", "0.1", "--warnpercent", "1"});
  EXPECT_EQ(warned.exit_code, 0);
  EXPECT_NE(warned.out.find("PASS WITH WARNINGS"), std::string::npos);
  EXPECT_EQ(code({"--fail", "1", "--hardwarn", "0.1"}), 0);
  EXPECT_EQ(code({"--fail", "-1"}), 2);
  EXPECT_EQ(code({"--fail", "nan"}), 2);
  EXPECT_EQ(code({"--chi-square", "1"}), 2);
}

// Debian's idiff lets both of these pass.
TEST_F(Diff, AllNanDoesNotPass) {
  write("a.exr", kNan);
  write("b.exr", kNan);
  EXPECT_EQ(diff({"a.exr", "b.exr"}).exit_code, 1);
  EXPECT_EQ(diff({"a.exr", "b.exr", "--fail", "1e30", "--failpercent", "100"}).exit_code, 1);
  EXPECT_EQ(diff({"a.exr", "b.exr", "--allow-nonfinite"}).exit_code, 0);
  write("c.exr", 1.0F);
  EXPECT_EQ(diff({"a.exr", "c.exr", "--allow-nonfinite", "--fail", "1e30"}).exit_code, 1);
  const Outcome told = diff({"a.exr", "c.exr"});
  EXPECT_NE(told.out.find("Channel G: A holds 32 NaN and 0 infinite, B 0 NaN and 0 infinite"), std::string::npos);
  EXPECT_NE(told.out.find("The first of A is at column 0, row 0, channel R\n"), std::string::npos) << told.out;
}

TEST_F(Diff, DifferentSizesAreNotPadded) {
  write("a.exr", 0.0F);
  write("b.exr", 0.0F, 0.0F, {"R", "G", "B"}, "", 9);
  expect_refused({"a.exr", "b.exr", "--fail", "10", "--heatmap", "h.png"}, "a.exr is 8x4, b.exr is 9x4");
}

TEST_F(Diff, ChannelsMustAgreeOrBeChosen) {
  write("a.exr", 1.0F, 1.0F, {"R", "G", "B", "Z"});
  write("b.exr", 1.0F, 1.0F, {"R", "G", "B"});
  expect_refused({"a.exr", "b.exr"},
                 "a.exr has R G B Z, b.exr has R G B; compare what both have with --channels R,G,B");
  EXPECT_EQ(diff({"a.exr", "b.exr", "--channels", "R,G,B"}).exit_code, 0);
  expect_refused({"a.exr", "b.exr", "--channels", "R,Z"}, "b.exr: has no channel 'Z'; it has R, G, B");
  expect_refused({"a.exr", "b.exr", "--channels", "R,,G"}, "empty name");
}

TEST_F(Diff, CutShortIsOneLine) {
  write("b.exr", 0.5F, 0.25F);
  const std::string whole = scratch_.read("b.exr");
  scratch_.write("header.exr", whole.substr(0, 60));
  scratch_.write("pixels.exr", whole.substr(0, whole.size() - 20));
  expect_refused({"header.exr", "b.exr", "--heatmap", "h.png"}, "header.exr: damaged or cut short");
  expect_refused({"b.exr", "pixels.exr", "--heatmap", "h.png"}, "pixels.exr: damaged or cut short");
}

TEST_F(Diff, LayersAndStandardErrors) {
  write("a.exr", 1.125F, 1.125F, {"R", "G", "B", "single.R"});
  write("b.exr", 1.0F, 1.0F, {"R", "G", "B", "single.R"});
  write("s.exr", 0.125F);
  expect_refused({"a.exr", "b.exr", "--layer", "none"},
                 "a.exr: has no layer 'none'; it has the main picture, 'single'");
  EXPECT_EQ(diff({"a.exr", "b.exr", "--layer", "single", "--fail", "0.2"}).exit_code, 0);
  EXPECT_EQ(diff({"a.exr", "b.exr", "--standard-error", "s.exr"}).exit_code, 0);
  EXPECT_EQ(diff({"a.exr", "b.exr", "--standard-error", "s.exr", "--chi-square", "0.9"}).exit_code, 1);
  EXPECT_EQ(diff({"a.exr", "b.exr", "--standard-error", "s.exr", "--standard-error-layer", "x"}).exit_code, 2);
}

// CI sees the error in its report.
TEST_F(Diff, JunitTellsWhatCannotBeCompared) {
  write("b.exr", 0.5F);
  scratch_.write("text.exr", "this is not a picture");
  const Outcome outcome = diff({"text.exr", "b.exr", "--junit", "r.xml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(scratch_.read("r.xml").find("<error type=\"cannot compare\" message=\"text.exr: is not an EXR"),
            std::string::npos);
}

TEST_F(Diff, ForeignFilesAreOneLine) {
  write("b.exr", 0.5F);
  scratch_.write("text.exr", "this is not a picture");
  scratch_.write("empty.exr", "");
  expect_refused({"text.exr", "b.exr"}, "text.exr: is not an EXR file");
  expect_refused({"b.exr", "empty.exr"}, "empty.exr: is not an EXR file");
  expect_refused({"b.exr", "nowhere.exr"}, "nowhere.exr: no such file");
}

TEST_F(Diff, UnlikeKindsAndNoMatch) {
  write("a/1.exr", 0.5F);
  write("b/2.exr", 0.5F);
  expect_refused({"a", "b/2.exr"}, "a is a folder, b/2.exr is one file");
  expect_refused({"a", "b"}, "no file of a (1) has a counterpart in b (1)");
  expect_refused({"a/x.##.exr", "b/x.##.exr"}, "no frame matches");
}

TEST_F(Diff, OutputsAreRefusedBeforeWork) {
  write("a.exr", 0.5F);
  write("b.exr", 0.5F);
  expect_refused({"a.exr", "b.exr", "--heatmap", "no/where/h.png"}, "no/where");
  expect_refused({"a.exr", "b.exr", "--heatmap", "h.jpg"}, "name it *.png");
  expect_refused({"a.exr", "b.exr", "--heatmap", "h.png", "--side-by-side", "h.png"}, "written twice");
  expect_refused({"a.exr", "b.exr", "--junit", "a.exr"}, "one of the pictures compared");
  expect_refused({"missing.exr", "b.exr", "--side-by-side", "no/where/h.png"}, "no/where");  // outputs come first
  expect_refused({"a.exr", "b.exr", "--camera-from", "nowhere.json"}, "nowhere.json");
}

TEST_F(Diff, WritesPicturesAndJunit) {
  write("a.exr", 0.5F, 0.75F);
  write("b.exr", 0.5F);
  const Outcome outcome =
      diff({"a.exr", "b.exr", "--heatmap", "h.png", "--side-by-side", "s.png", "--junit", "r.xml", "--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["verdict"], "differ");
  EXPECT_EQ(result["files_written"], (json{"h.png", "s.png", "r.xml"}));
  EXPECT_EQ(result["pairs"][0]["pixels_over_fail"], 1);
  EXPECT_EQ(result["limits"]["fail"], 1e-6);
  EXPECT_EQ(result["pairs"][0]["checks"][0]["holds"], true);
  EXPECT_EQ(result["pairs"][0]["checks"][1]["limit"], "pixels above 1e-06 (--fail)");
  EXPECT_EQ(result["pairs"][0]["checks"][1]["holds"], false);
  EXPECT_NE(outcome.err.find("DIFFER"), std::string::npos);
  EXPECT_EQ(scratch_.read("h.png").substr(1, 3), "PNG");
  EXPECT_EQ(scratch_.read("s.png").substr(1, 3), "PNG");
  EXPECT_NE(scratch_.read("r.xml").find("<failure"), std::string::npos);
  EXPECT_EQ(scratch_.files(), (std::vector<std::string>{"a.exr", "b.exr", "h.png", "r.xml", "s.png"}));
}

TEST_F(Diff, SequencesArePairedWithOneSummary) {
  for (const char* frame : {"0001", "0002", "0003"}) {
    write("new/sky." + std::string(frame) + ".exr", 0.5F, std::string(frame) == "0002" ? 0.75F : 0.5F);
    write("old/sky." + std::string(frame) + ".exr", 0.5F);
  }
  const Outcome some = diff({"new/sky.####.exr", "old/sky.####.exr", "--heatmap", "h.png", "--junit", "r.xml"});
  EXPECT_EQ(some.exit_code, 1);
  EXPECT_NE(some.out.find("3 pairs: 2 pass, 1 differ; largest relative error 50% in sky.0002.exr at pixel (0, 0)"),
            std::string::npos)
      << some.out;
  EXPECT_TRUE(exists("h.sky.0001.png"));
  EXPECT_TRUE(exists("h.sky.0002.png"));
  EXPECT_NE(scratch_.read("r.xml").find("tests=\"3\" failures=\"1\" errors=\"0\""), std::string::npos);

  std::filesystem::remove(scratch_.path() / "new/sky.0003.exr");
  const Outcome missing = diff({"new", "old"});
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.out.find("sky.0003.exr: is in old but not in new"), std::string::npos) << missing.out;
  EXPECT_NE(missing.out.find("1 cannot compare"), std::string::npos);
}

TEST_F(Diff, PresetsAndRegions) {
  const Outcome checked =
      airlight(scratch_.path(), {"render", "earth-noon", "--size", "16x8", "--float", "-o", "a.exr", "--set",
                                 "/camera/projection=equirectangular", "--set", "/camera/pitch_deg=0", "-q"});
  ASSERT_EQ(checked.exit_code, 0) << checked.err;
  ASSERT_EQ(
      airlight(scratch_.path(), {"render", "a.exr", "-o", "b.exr", "--float", "--set", "/sun/elevation_deg=31", "-q"})
          .exit_code,
      0);
  const Outcome outcome = diff({"a.exr", "b.exr", "--json"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  const json pair = json::parse(outcome.out)["pairs"][0];
  ASSERT_EQ(pair["preset_differences"].size(), 1U);
  EXPECT_EQ(pair["preset_differences"][0]["pointer"], "/sun/elevation_deg");
  EXPECT_EQ(pair["preset_differences"][0]["b"], "31");
  EXPECT_EQ(pair["areas"][1]["name"], "sky");
  EXPECT_EQ(pair["areas"][1]["pixels"], 64);
  EXPECT_TRUE(pair["areas"][0]["channels"][0]["worst_relative"].contains("elevation_deg"));
  EXPECT_EQ(outcome.err.find("The presets differ:\n  /sun/elevation_deg"), outcome.err.find("The presets differ"));
}

TEST_F(Diff, CameraFromAPreset) {
  write("a.exr", 1.0F);
  write("b.exr", 1.0F);
  scratch_.write("view.json", small_preset());
  const json none = json::parse(diff({"a.exr", "b.exr", "--json"}).out);
  EXPECT_EQ(none["pairs"][0]["areas"].size(), 1U);
  const Outcome outcome = diff({"a.exr", "b.exr", "--camera-from", "view.json", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_GT(json::parse(outcome.out)["pairs"][0]["areas"].size(), 1U);
}

// Starting any other command must not pay for OpenImageIO.
TEST_F(Diff, ToolItselfDoesNotLinkOpenImageIo) {
  const Outcome outcome =
      run(scratch_.path(), {"/bin/sh", "-c", "readelf -d \"$1\" || ldd \"$1\"", "sh", tool_program()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("libc.so"), std::string::npos);
  EXPECT_EQ(outcome.out.find("OpenImageIO"), std::string::npos);
}

}  // namespace
}  // namespace airlight::test
