// EXRs whose headers promise more than the file has are refused before OpenEXR takes memory for it.
#include "core/output/exr_header.h"

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfPreviewImage.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include "core/output/picture_reader.h"
#include "tests/output/files.h"

namespace airlight {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;
using test::contents_of;
using test::Folder;

imf::Header header_of(int width, int height) {
  imf::Header header(width, height);
  header.channels().insert("R", imf::Channel(imf::FLOAT));
  header.insert("comments", imf::StringAttribute("some text of the header"));
  header.insert("multiView", imf::StringVectorAttribute({"left", "right"}));
  header.setPreviewImage(imf::PreviewImage(2, 3));
  return header;
}

std::string scan_lines(const Folder& folder) {
  const std::string file = (folder / "a.exr").string();
  {
    imf::OutputFile out(file.c_str(), header_of(8, 40));
    out.setFrameBuffer({});  // zeros
    out.writePixels(40);
  }
  return contents_of(file);
}

std::string two_parts(const Folder& folder) {
  const std::string file = (folder / "parts.exr").string();
  std::array<imf::Header, 2> parts = {header_of(8, 40), header_of(8, 3)};
  parts[0].setName("one");
  parts[1].setName("two");
  for (imf::Header& part : parts) {
    part.displayWindow() = parts[0].displayWindow();
    part.setType(imf::SCANLINEIMAGE);
    part.compression() = imf::PIZ_COMPRESSION;
  }
  parts[1].insert("lastWords", imf::StringAttribute("of the second part"));
  {
    imf::MultiPartOutputFile out(file.c_str(), parts.data(), 2);
    for (int part = 0; part < 2; ++part) {
      imf::OutputPart rows(out, part);
      rows.setFrameBuffer({});
      rows.writePixels(part == 0 ? 40 : 3);
    }
  }
  return contents_of(file);
}

// What is said of the bytes; empty if nothing.
std::string refusal(const Folder& folder, const std::string& bytes) {
  test::put(folder / "b.exr", bytes);
  try {
    require_room_for_exr(folder / "b.exr");
    return {};
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

// The text with the 4 bytes that stand `behind` bytes behind the first `name` set to a number.
std::string with_number(std::string bytes, const std::string& name, std::size_t behind, std::uint32_t number) {
  const std::size_t at = bytes.find(name);
  EXPECT_NE(at, std::string::npos) << name;
  for (std::size_t i = 0; i < 4; ++i) {
    bytes[at + name.size() + behind + i] = static_cast<char>(number >> (8 * i));
  }
  return bytes;
}

TEST(ExrRoom, WholeFilesOfEveryKindHaveIt) {
  const Folder folder;
  EXPECT_EQ(refusal(folder, scan_lines(folder)), "");
  const std::string file = (folder / "c.exr").string();
  {
    imf::Header tiled = header_of(70, 30);
    tiled.setTileDescription(imf::TileDescription(32, 16, imf::MIPMAP_LEVELS));
    imf::TiledOutputFile out(file.c_str(), tiled);
    out.setFrameBuffer({});
    for (int level = 0; level < out.numLevels(); ++level) {
      out.writeTiles(0, out.numXTiles(level) - 1, 0, out.numYTiles(level) - 1, level);
    }
  }
  EXPECT_EQ(refusal(folder, contents_of(file)), "");
  EXPECT_EQ(refusal(folder, two_parts(folder)), "");
  EXPECT_EQ(refusal(folder, "no EXR"), "");
  EXPECT_EQ(refusal(folder, ""), "");
  EXPECT_NO_THROW(require_room_for_exr(folder / "missing.exr"));
}

TEST(ExrRoom, LengthsBeyondTheFileAreRefused) {
  const Folder folder;
  const std::string whole = scan_lines(folder);
  const std::string string_type = std::string("comments\0string\0", 16);
  EXPECT_EQ(refusal(folder, with_number(whole, string_type, 0, 0x7f000000)), "its header is longer than the file");
  const std::string list_type = std::string("multiView\0stringvector\0", 23);
  EXPECT_EQ(refusal(folder, with_number(whole, list_type, 4, 0x7f000000)),
            "a text in its header is longer than the header");
  const std::string preview_type = std::string("preview\0preview\0", 16);
  EXPECT_EQ(refusal(folder, with_number(whole, preview_type, 4, 0x7000)), "its preview is longer than its header");
  EXPECT_EQ(refusal(folder, with_number(whole, preview_type, 8, 0xffffffff)), "its preview is longer than its header");
  // The last row.
  const std::string window_type = std::string("dataWindow\0box2i\0", 17);
  EXPECT_EQ(refusal(folder, with_number(whole, window_type, 4 + 12, 0x3fffffff)),
            "it has fewer bytes than its header asks for");
}

// OpenEXR reads 16 bytes of a window whatever the file says, and takes what follows for other attributes: one of 2 kB
// took 825 MiB.
TEST(ExrRoom, AnAttributeOfAnotherSizeThanItsTypeIsRefused) {
  const Folder folder;
  const std::string window_type = std::string("dataWindow\0box2i\0", 17);
  EXPECT_EQ(refusal(folder, with_number(scan_lines(folder), window_type, 0, 198)),
            "its attribute dataWindow has 198 bytes, where a box2i has 16");
}

// A damaged length before it takes an attribute's name away; OpenEXR then reads the pixels as ZIP.
TEST(ExrRoom, AHeaderThatDoesNotTellIsRefused) {
  const Folder folder;
  for (const char* const name : {"channels", "compression", "dataWindow"}) {
    std::string bytes = scan_lines(folder);
    bytes[bytes.find(std::string(name) + '\0')] = 'x';
    EXPECT_EQ(refusal(folder, bytes), std::string("its header has no attribute ") + name);
  }
}

TEST(ExrRoom, WideRowsNeedBytesByTheirCompression) {
  const Folder folder;
  const std::string file = (folder / "c.exr").string();
  for (const auto compression : {imf::NO_COMPRESSION, imf::RLE_COMPRESSION, imf::ZIPS_COMPRESSION, imf::ZIP_COMPRESSION,
                                 imf::PXR24_COMPRESSION, imf::PIZ_COMPRESSION}) {
    // Pixels of one value are compressed as well as any.
    constexpr int kWidth = 30000;
    imf::Header header(kWidth, 48);
    header.compression() = compression;
    header.channels().insert("R", imf::Channel(imf::FLOAT));
    header.channels().insert("G", imf::Channel(imf::HALF, 2, 2));
    {
      std::vector<float> row(kWidth);
      imf::FrameBuffer frame;
      frame.insert("R", imf::Slice(imf::FLOAT, reinterpret_cast<char*>(row.data()), sizeof(float), 0));
      imf::OutputFile out(file.c_str(), header);
      out.setFrameBuffer(frame);
      out.writePixels(48);
    }
    EXPECT_EQ(refusal(folder, contents_of(file)), "") << compression;
    const std::string window_type = std::string("dataWindow\0box2i\0", 17);
    const std::string wide = with_number(contents_of(file), window_type, 4 + 8, 0x3fffffff);
    EXPECT_EQ(refusal(folder, wide),
              compression == imf::PIZ_COMPRESSION ? "" : "it has fewer bytes than its header asks for")
        << compression;
  }
}

TEST(ExrRoom, TilesAndPartsAreCounted) {
  const Folder folder;
  const std::string file = (folder / "c.exr").string();
  {
    imf::Header tiled = header_of(70, 30);
    tiled.setTileDescription(imf::TileDescription(32, 16));
    imf::TiledOutputFile out(file.c_str(), tiled);
    out.setFrameBuffer({});
    for (int level = 0; level < out.numLevels(); ++level) {
      out.writeTiles(0, out.numXTiles(level) - 1, 0, out.numYTiles(level) - 1, level);
    }
  }
  const std::string window_type = std::string("dataWindow\0box2i\0", 17);
  EXPECT_EQ(refusal(folder, with_number(contents_of(file), window_type, 4 + 8, 0x3fffffff)),
            "it has fewer bytes than its header asks for");
  const std::string string_type = std::string("lastWords\0string\0", 17);
  EXPECT_EQ(refusal(folder, with_number(two_parts(folder), string_type, 0, 0x7f000000)),
            "its header is longer than the file");
}

TEST(ExrRoom, APictureIsNotReadWithoutIt) {
  const Folder folder;
  const std::string type = std::string("comments\0string\0", 16);
  test::put(folder / "b.exr", with_number(scan_lines(folder), type, 0, 0x7f000000));
  try {
    read_exr_picture(folder / "b.exr");
    FAIL() << "was read";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("its header is longer than the file"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace airlight
