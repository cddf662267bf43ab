// What a picture's header asks for is judged before a pixel is decoded, and a picture is whole or refused.

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "core/foreign/foreign_picture.h"
#include "tests/output/files.h"

namespace airlight::foreign {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int k = 0; k < bytes; ++k) {
    text += static_cast<char>(value >> (8 * k) & 0xffU);
  }
  return text;
}

// One strip of one float a pixel, behind the directory.
std::string tiff_of(std::uint32_t columns, std::uint32_t rows) {
  std::string text = std::string("II*\0", 4) + little_endian(8, 4) + little_endian(10, 2);
  const std::uint32_t pixels = 8 + 2 + 12 * 10 + 4;
  const auto entry = [&](std::uint32_t tag, std::uint32_t value) {
    text += little_endian(tag, 2) + little_endian(4, 2) + little_endian(1, 4) + little_endian(value, 4);
  };
  entry(256, columns);
  entry(257, rows);
  entry(258, 32);
  entry(259, 1);
  entry(262, 1);
  entry(273, pixels);
  entry(277, 1);
  entry(278, rows);
  entry(279, 4 * columns * rows);
  entry(339, 3);
  text += little_endian(0, 4);
  for (std::uint32_t i = 0; i < columns * rows; ++i) {
    text += little_endian(0x3f000000U, 4);  // 0.5
  }
  return text;
}

class Plates : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& bytes) const {
    test::put(folder_ / name, bytes);
    return (folder_ / name).string();
  }
  static std::string refusal(const std::string& file, const Accept& accept = {}) {
    return test::message_of<InputError>([&] { read_picture(file, accept); });
  }
  test::Folder folder_;
};

// libtiff would give black for what is missing.
TEST_F(Plates, ATiffThatIsCutShortIsRefused) {
  const std::string whole = tiff_of(8, 4);
  EXPECT_EQ(read_picture(put("whole.tif", whole)).channels.front().values, std::vector<float>(32, 0.5F));
  for (const std::size_t length : {whole.size() - 1, whole.size() - 100, std::size_t{20}}) {
    const std::string file = put("cut.tif", whole.substr(0, length));
    EXPECT_EQ(refusal(file),
              file + ": damaged or cut short: it is shorter than its directory says; write or copy it again");
  }
}

// libjpeg would give grey for what is missing. A thumbnail in the header has an end of its own.
TEST_F(Plates, AJpegThatIsCutShortIsRefused) {
  const std::string start("\xff\xd8\xff\xe1\0\6\xff\xd9zz\xff\xda\0\2", 14);
  const std::string cut = put("cut.jpg", start + "pixels");
  EXPECT_EQ(refusal(cut), cut + ": damaged or cut short: it has no end; write or copy it again");
  const std::string whole = put("whole.jpg", start + "pixels\xff\xd9");
  EXPECT_EQ(refusal(whole).find("it has no end"), std::string::npos) << refusal(whole);  // though it is none
}

// libpng would write a line of its own.
TEST_F(Plates, APngThatIsCutShortOrDamagedIsRefusedInOneLine) {
  const std::string start("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\b\0\0\0\0\x3a\x7e\x9b\x55", 33);
  const std::string pixels("\0\0\0\nIDAT\x78\x9c\x63\x60\0\0\0\2\0\1\x48\xaf\xa4\x71", 22);
  const std::string whole = start + pixels + std::string("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  EXPECT_EQ(read_picture(put("whole.png", whole)).channels.front().values, std::vector<float>(1, 0.0F));
  testing::internal::CaptureStderr();
  const std::string cut = put("cut.png", whole.substr(0, 50));
  EXPECT_EQ(refusal(cut), cut + ": damaged or cut short: it has no end; write or copy it again");
  std::string other = whole;
  other[45] = '?';
  const std::string damaged = put("damaged.png", other);
  EXPECT_EQ(refusal(damaged), damaged +
                                  ": damaged or cut short: the checksum of its chunk IDAT does not fit; write or "
                                  "copy it again");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(Plates, TheHeaderIsJudgedBeforeThePixels) {
  const auto refuse = [](const Picture& header) { throw InputError("no " + std::to_string(header.width)); };
  // Behind this header there are no pixels.
  const std::string file = put("large.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4096 +X 8192\n");
  EXPECT_EQ(refusal(file, refuse), "no 8192");
  EXPECT_TRUE(refusal(file).starts_with(file + ": damaged or cut short: ")) << refusal(file);
}

// The display window is not the data, and may say anything.
TEST_F(Plates, AWindowFarLargerThanTheDataIsRefused) {
  const std::string file = (folder_ / "window.exr").string();
  const std::vector<float> values(16 * 9, 0.5F);
  const auto write = [&](int side) {
    imf::Header header(Imath::Box2i({0, 0}, {side - 1, side - 1}), Imath::Box2i({0, 0}, {15, 8}));
    header.channels().insert("R", imf::Channel(imf::FLOAT));
    imf::FrameBuffer frame;
    frame.insert("R", imf::Slice::Make(imf::FLOAT, values.data(), header.dataWindow()));
    imf::OutputFile out(file.c_str(), header);
    out.setFrameBuffer(frame);
    out.writePixels(9);
  };
  write(30001);
  EXPECT_EQ(refusal(file), file +
                               ": its display window is 30001x30001 pixels, and 16x9 are stored; crop the window "
                               "to what is there");
  write(1000);
  EXPECT_EQ(read_picture(file).channels.front().values.size(), 1000000U);
}

TEST_F(Plates, OnlyFormatsOfPicturesAreOpened) {
  for (const char* name : {"map.null", "map.png", "map"}) {
    const std::string file = put(name, "x");
    EXPECT_EQ(refusal(file), file +
                                 ": is no picture that airlight reads; expected EXR, PNG, TIFF, HDR, JPEG, WebP, PNM, "
                                 "BMP, DPX or TGA");
  }
}

}  // namespace
}  // namespace airlight::foreign
