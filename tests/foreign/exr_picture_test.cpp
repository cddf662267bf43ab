// EXRs as OpenEXR reads them, against OpenImageIO, whose module reads all other pictures.
#include "core/foreign/exr_picture.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfDeepTiledOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include "core/foreign/module.h"
#include "tests/output/files.h"

namespace airlight::foreign {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;
using test::contents_of;

Picture by_module(const std::string& file) {
  Picture picture;
  std::string problem;
  reinterpret_cast<ReadFunction>(module_entry(kReadEntry))(file, {}, picture, problem);
  EXPECT_EQ(problem, "");
  return picture;
}

void expect_same(const std::string& file) {
  const Picture found = read_picture(file);
  const Picture expected = by_module(file);
  EXPECT_EQ(found.file, expected.file);
  EXPECT_EQ(found.width, expected.width);
  EXPECT_EQ(found.height, expected.height);
  EXPECT_EQ(found.deep, expected.deep);
  EXPECT_EQ(found.samples, expected.samples);
  EXPECT_EQ(found.world_to_camera, expected.world_to_camera);
  EXPECT_EQ(found.world_to_ndc, expected.world_to_ndc);
  EXPECT_EQ(found.chromaticities, expected.chromaticities);
  EXPECT_EQ(found.srgb, expected.srgb);
  EXPECT_EQ(found.is_airlight, expected.is_airlight);
  EXPECT_EQ(found.channel_list(), expected.channel_list());
  ASSERT_EQ(found.channels.size(), expected.channels.size());
  for (std::size_t c = 0; c < found.channels.size(); ++c) {
    EXPECT_EQ(found.channels[c].half, expected.channels[c].half) << found.channels[c].name;
    EXPECT_EQ(found.channels[c].values, expected.channels[c].values) << found.channels[c].name;
  }
}

class ForeignExr : public testing::Test {
 protected:
  std::string file() const { return (folder_ / "a.exr").string(); }

  test::Folder folder_;
};

constexpr int kColumns = 7;
constexpr int kRows = 5;

// Values of one channel for each pixel of a window of at most kColumns x kRows.
std::vector<float> values_of(float first) {
  std::vector<float> values(static_cast<std::size_t>(kColumns * kRows));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = first + static_cast<float>(i) / 8.0F;
  return values;
}

imf::FrameBuffer frame_of(const imf::Header& header, std::vector<std::vector<float>>& planes) {
  imf::FrameBuffer frame;
  float first = 0.0F;
  planes.reserve(10);
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    planes.push_back(values_of(first += 1.0F));
    frame.insert(channel.name(), imf::Slice::Make(imf::FLOAT, planes.back().data(), header.dataWindow()));
  }
  return frame;
}

void write_flat(const std::string& file, imf::Header header, const std::vector<std::string>& halves) {
  header.channels().insert("depth.Z", imf::Channel(imf::FLOAT));
  for (const std::string& name : halves) header.channels().insert(name, imf::Channel(imf::HALF));
  std::vector<std::vector<float>> planes;
  imf::OutputFile out(file.c_str(), header);
  // OpenEXR writes halves from halves alone.
  std::vector<std::vector<half>> half_planes(halves.size());
  imf::FrameBuffer frame;
  planes.push_back(values_of(100.0F));
  frame.insert("depth.Z", imf::Slice::Make(imf::FLOAT, planes.back().data(), header.dataWindow()));
  for (std::size_t c = 0; c < halves.size(); ++c) {
    for (const float value : values_of(static_cast<float>(c))) half_planes[c].emplace_back(value);
    frame.insert(halves[c], imf::Slice::Make(imf::HALF, half_planes[c].data(), header.dataWindow()));
  }
  out.setFrameBuffer(frame);
  out.writePixels(header.dataWindow().size().y + 1);
}

TEST_F(ForeignExr, ChannelsLayersAndAttributes) {
  imf::Header header(kColumns, kRows);
  imf::addChromaticities(header, imf::Chromaticities({0.7F, 0.3F}, {0.2F, 0.7F}, {0.1F, 0.05F}, {0.3F, 0.32F}));
  Imath::M44f camera;
  camera[3][2] = 5.0F;
  camera[0][1] = 0.25F;
  header.insert("worldToCamera", imf::M44fAttribute(camera));
  camera[1][3] = 2.0F;
  header.insert("worldToNDC", imf::M44fAttribute(camera));
  header.insert("airlight:preset", imf::StringAttribute("{}"));
  write_flat(file(), header, {"A", "B", "G", "R", "bloom.B", "bloom.G", "bloom.R"});
  expect_same(file());
  EXPECT_TRUE(read_picture(file()).is_airlight);
  EXPECT_EQ(read_picture(file()).channel_list(), "R, G, B, A, bloom.R, bloom.G, bloom.B, depth.Z");
}

TEST_F(ForeignExr, AStoredPartBesideOrWithinTheDisplayWindow) {
  for (const Imath::V2i& corner : {Imath::V2i(1, 2), Imath::V2i(-2, -1), Imath::V2i(5, 4), Imath::V2i(0, -9),
                                   Imath::V2i(-9, 0), Imath::V2i(9, 1)}) {
    const Imath::Box2i data(corner, corner + Imath::V2i(3, 2));
    write_flat(file(), imf::Header(Imath::Box2i({0, 0}, {kColumns - 1, kRows - 1}), data), {"B", "G", "R"});
    SCOPED_TRACE(corner.x);
    expect_same(file());
  }
  // The display window itself need not begin at zero.
  write_flat(file(), imf::Header(Imath::Box2i({10, -4}, {16, 0}), Imath::Box2i({9, -3}, {12, 1})), {"Y"});
  expect_same(file());
}

TEST_F(ForeignExr, Tiles) {
  imf::Header header(kColumns, kRows);
  header.channels().insert("R", imf::Channel(imf::FLOAT));
  header.setTileDescription(imf::TileDescription(4, 2, imf::MIPMAP_LEVELS));
  std::vector<std::vector<float>> planes;
  {
    imf::TiledOutputFile out(file().c_str(), header);
    out.setFrameBuffer(frame_of(header, planes));
    for (int level = 0; level < out.numLevels(); ++level) {
      out.writeTiles(0, out.numXTiles(level) - 1, 0, out.numYTiles(level) - 1, level);
    }
  }
  expect_same(file());
}

TEST_F(ForeignExr, PartsOfTheSameSize) {
  std::array<imf::Header, 3> parts = {imf::Header(kColumns, kRows), imf::Header(kColumns, kRows),
                                      imf::Header(kColumns, kRows)};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].setName("part" + std::to_string(i));
    parts[i].setType(imf::SCANLINEIMAGE);
    parts[i].channels().insert("R", imf::Channel(imf::FLOAT));
    parts[i].channels().insert("mist.Z", imf::Channel(imf::FLOAT));
  }
  std::vector<std::vector<std::vector<float>>> planes(parts.size());
  {
    imf::MultiPartOutputFile out(file().c_str(), parts.data(), static_cast<int>(parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      imf::OutputPart part(out, static_cast<int>(i));
      part.setFrameBuffer(frame_of(parts[i], planes[i]));
      part.writePixels(kRows);
    }
  }
  expect_same(file());
  EXPECT_EQ(read_picture(file()).channel_list(), "R, mist.Z, part1.R, part1.mist.Z, part2.R, part2.mist.Z");
}

// Whole numbers stay what they are; OpenImageIO makes fractions of them.
TEST_F(ForeignExr, WholeNumbers) {
  imf::Header header(2, 1);
  header.channels().insert("id", imf::Channel(imf::UINT));
  std::array<std::uint32_t, 2> ids = {3, 70000};
  {
    imf::FrameBuffer frame;
    frame.insert("id", imf::Slice::Make(imf::UINT, ids.data(), header.dataWindow()));
    imf::OutputFile out(file().c_str(), header);
    out.setFrameBuffer(frame);
    out.writePixels(1);
  }
  EXPECT_EQ(read_picture(file()).find("id")->values, (std::vector<float>{3.0F, 70000.0F}));
}

// Pixel i of the window has i % 3 samples.
template <class Out, class Write>
void write_deep(const std::string& file, const imf::Header& header, const Write& write) {
  const Imath::Box2i& data = header.dataWindow();
  const std::size_t columns = static_cast<std::size_t>(data.size().x + 1);
  const std::size_t pixels = columns * static_cast<std::size_t>(data.size().y + 1);
  std::vector<unsigned> counts(pixels);
  std::array<std::vector<std::array<float, 2>>, 2> samples;
  std::array<std::vector<float*>, 2> pointers;
  for (std::size_t c = 0; c < 2; ++c) {
    samples[c].resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      counts[i] = static_cast<unsigned>(i % 3);
      samples[c][i] = {static_cast<float>(10 * i + c), static_cast<float>(10 * i + c) + 0.5F};
      pointers[c].push_back(samples[c][i].data());
    }
  }
  const auto base = [&](auto* first) {
    return reinterpret_cast<char*>(first - data.min.x - data.min.y * static_cast<std::ptrdiff_t>(columns));
  };
  imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(
      imf::Slice(imf::UINT, base(counts.data()), sizeof(unsigned), sizeof(unsigned) * columns));
  frame.insert("A", imf::DeepSlice(imf::FLOAT, base(pointers[0].data()), sizeof(float*), sizeof(float*) * columns,
                                   sizeof(float)));
  frame.insert("Z", imf::DeepSlice(imf::FLOAT, base(pointers[1].data()), sizeof(float*), sizeof(float*) * columns,
                                   sizeof(float)));
  Out out(file.c_str(), header);
  out.setFrameBuffer(frame);
  write(out);
}

TEST_F(ForeignExr, DeepLinesAndTiles) {
  for (const Imath::V2i& corner : {Imath::V2i(0, 0), Imath::V2i(2, 1), Imath::V2i(-2, -1), Imath::V2i(-20, 0)}) {
    imf::Header header(Imath::Box2i({0, 0}, {kColumns - 1, kRows - 1}),
                       Imath::Box2i(corner, corner + Imath::V2i(kColumns - 1, kRows - 1)));
    header.channels().insert("A", imf::Channel(imf::FLOAT));
    header.channels().insert("Z", imf::Channel(imf::FLOAT));
    header.compression() = imf::ZIPS_COMPRESSION;
    SCOPED_TRACE(corner.x);
    header.setType(imf::DEEPSCANLINE);
    write_deep<imf::DeepScanLineOutputFile>(file(), header,
                                            [](imf::DeepScanLineOutputFile& out) { out.writePixels(kRows); });
    expect_same(file());
    EXPECT_TRUE(read_picture(file()).deep);
    header.setType(imf::DEEPTILE);
    header.setTileDescription(imf::TileDescription(4, 2));
    write_deep<imf::DeepTiledOutputFile>(file(), header, [](imf::DeepTiledOutputFile& out) {
      out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
    });
    expect_same(file());
  }
}

TEST_F(ForeignExr, DamageIsOneLine) {
  const auto refusal = [&](const std::string& bytes) -> std::string {
    test::put(file(), bytes);
    try {
      read_picture(file());
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  };
  write_flat(file(), imf::Header(kColumns, kRows), {"B", "G", "R"});
  const std::string whole = contents_of(file());
  for (std::size_t length = 4; length < whole.size(); length += 3) {
    const std::string said = refusal(whole.substr(0, length));
    EXPECT_TRUE(said.starts_with(file() + ": ")) << length << ": " << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  EXPECT_NE(refusal(whole.substr(0, whole.size() - 2)).find("damaged or cut short"), std::string::npos);
  imf::Header header(4, 4);
  header.channels().insert("BY", imf::Channel(imf::HALF, 2, 2));
  imf::OutputFile(file().c_str(), header);
  EXPECT_NE(refusal(contents_of(file())).find("channel 'BY' has fewer samples"), std::string::npos);
}

}  // namespace
}  // namespace airlight::foreign
