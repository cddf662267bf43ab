// EXR files of other programs: several parts, parts of a picture, whole numbers, other primaries.
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <filesystem>
#include <stdexcept>

#include "core/measure/compare.h"

namespace airlight::measure {
namespace {

namespace fs = std::filesystem;

class ForeignExr : public testing::Test {
 protected:
  ForeignExr() {
    std::string pattern = (fs::temp_directory_path() / "airlight-foreign-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error(pattern);
    folder_ = pattern;
  }
  ~ForeignExr() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  static ComparisonReport compare(const std::string& a, const std::string& b, const std::string& layer = "") {
    ComparisonRequest request;
    request.a = a;
    request.b = b;
    request.layer = layer;
    return measure::compare(request);
  }

 private:
  fs::path folder_;
};

// One float channel "Y" of 4 x 4 whose stored part starts at (left, top) and is 2 x 2; the last sample is `last`.
void write_window(const std::string& file, int left, int top, float last) {
  Imf::Header header(Imath::Box2i({0, 0}, {3, 3}), Imath::Box2i({left, top}, {left + 1, top + 1}));
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  std::array<float, 4> samples = {1.0F, 1.0F, 1.0F, last};
  Imf::FrameBuffer buffer;
  buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, samples.data(), header.dataWindow()));
  Imf::OutputFile output(file.c_str(), header);
  output.setFrameBuffer(buffer);
  output.writePixels(2);
}

void write_number(const std::string& file, unsigned int value) {
  Imf::Header header(1, 1);
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  Imf::FrameBuffer buffer;
  buffer.insert("id", Imf::Slice::Make(Imf::UINT, &value, header.dataWindow()));
  Imf::OutputFile output(file.c_str(), header);
  output.setFrameBuffer(buffer);
  output.writePixels(1);
}

// Two parts of one float channel "Y" each, called "beauty" and "depth".
void write_parts(const std::string& file, float beauty, float depth) {
  std::array<Imf::Header, 2> headers = {Imf::Header(1, 1), Imf::Header(1, 1)};
  const std::array<const char*, 2> names = {"beauty", "depth"};
  const std::array<float, 2> values = {beauty, depth};
  for (std::size_t i = 0; i < 2; ++i) {
    headers[i].channels().insert("Y", Imf::Channel(Imf::FLOAT));
    headers[i].setName(names[i]);
    headers[i].setType(Imf::SCANLINEIMAGE);
  }
  Imf::MultiPartOutputFile output(file.c_str(), headers.data(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, &values[i], headers[i].dataWindow()));
    Imf::OutputPart part(output, static_cast<int>(i));
    part.setFrameBuffer(buffer);
    part.writePixels(1);
  }
}

void write_rgb(const std::string& file, float red, const Imf::Chromaticities& primaries) {
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, primaries);
  const float one = 1.0F;
  Imf::FrameBuffer buffer;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, *name == 'R' ? &red : &one, header.dataWindow()));
  }
  Imf::OutputFile output(file.c_str(), header);
  output.setFrameBuffer(buffer);
  output.writePixels(1);
}

TEST_F(ForeignExr, PlacesAreOfTheWholePicture) {
  write_window(path("a.exr"), 2, 1, 2.0F);
  write_window(path("b.exr"), 2, 1, 1.0F);
  const ComparisonReport report = compare(path("a.exr"), path("b.exr"));
  EXPECT_EQ(report.width, 4);
  EXPECT_EQ(report.pixels, 4U);
  EXPECT_EQ(report.areas.front().channels.front().worst_absolute.x, 3);
  EXPECT_EQ(report.areas.front().channels.front().worst_absolute.y, 2);
}

TEST_F(ForeignExr, DataWindowsMustAgree) {
  write_window(path("a.exr"), 2, 1, 1.0F);
  write_window(path("b.exr"), 1, 1, 1.0F);
  const ComparisonReport report = compare(path("a.exr"), path("b.exr"));
  EXPECT_EQ(report.verdict, Verdict::cannot_compare);
  EXPECT_NE(report.problem.find("2x2 pixels stored from (2, 1)"), std::string::npos) << report.problem;
}

TEST_F(ForeignExr, WholeNumbersKeepTheirSize) {
  write_number(path("a.exr"), 7);
  write_number(path("b.exr"), 5);
  const ComparisonReport report = compare(path("a.exr"), path("b.exr"));
  EXPECT_EQ(report.verdict, Verdict::differ);
  EXPECT_NEAR(report.areas.front().channels.front().absolute.max, 2.0, 1e-5);
}

TEST_F(ForeignExr, PartsAreLayers) {
  write_parts(path("a.exr"), 1.0F, 5.0F);
  write_parts(path("b.exr"), 1.0F, 6.0F);
  const ComparisonReport main_picture = compare(path("a.exr"), path("b.exr"));
  EXPECT_EQ(main_picture.verdict, Verdict::pass);
  ASSERT_EQ(main_picture.notes.size(), 2U);
  EXPECT_NE(main_picture.notes[0].find("not compared: depth"), std::string::npos);
  const ComparisonReport depth = compare(path("a.exr"), path("b.exr"), "depth");
  EXPECT_EQ(depth.verdict, Verdict::differ);
  EXPECT_EQ(depth.areas.front().channels.front().worst_absolute.b, 6.0);
  EXPECT_EQ(compare(path("a.exr"), path("b.exr"), "beauty").verdict, Verdict::pass);
}

// Red has 0.2627 of the luminance of BT.2020's primaries.
TEST_F(ForeignExr, LuminanceIsOfItsOwnPrimaries) {
  const Imf::Chromaticities wide({0.708F, 0.292F}, {0.170F, 0.797F}, {0.131F, 0.046F}, {0.3127F, 0.3290F});
  write_rgb(path("a.exr"), 2.0F, wide);
  write_rgb(path("b.exr"), 1.0F, wide);
  const ComparisonReport report = compare(path("a.exr"), path("b.exr"));
  const ChannelReport& luminance = report.areas.front().channels[3];
  ASSERT_EQ(luminance.name, "luminance");
  EXPECT_NEAR(luminance.absolute.max, 0.2627, 1e-4);
}

TEST_F(ForeignExr, DeepDataIsRefused) {
  Imf::Header header(1, 1);
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::NO_COMPRESSION;
  {
    Imf::DeepScanLineOutputFile output(path("deep.exr").c_str(), header);
    unsigned int count = 0;
    float* none = nullptr;
    Imf::DeepFrameBuffer buffer;
    buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&count)));
    buffer.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(&none), 0, 0, sizeof(float)));
    output.setFrameBuffer(buffer);
    output.writePixels(1);
  }
  const ComparisonReport report = compare(path("deep.exr"), path("deep.exr"));
  EXPECT_EQ(report.verdict, Verdict::cannot_compare);
  EXPECT_NE(report.problem.find("holds deep data"), std::string::npos) << report.problem;
}

}  // namespace
}  // namespace airlight::measure
