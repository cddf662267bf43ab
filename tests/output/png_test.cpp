#include "core/output/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "tests/output/files.h"

namespace airlight {
namespace {

using test::Folder;

PixelImage numbered_pixels(int channels, int bits) {
  PixelImage image{33, 17, channels, bits, {}, {}};
  for (int i = 0; i < 33 * 17 * channels; ++i) {
    if (bits == 8) {
      image.bytes.push_back(static_cast<std::uint8_t>(i * 7));
    } else {
      image.words.push_back(static_cast<std::uint16_t>(i * 1009));
    }
  }
  return image;
}

// Walks the chunks itself, independently of the library that wrote them.
std::vector<std::pair<std::string, std::string>> chunks_of(const std::string& png) {
  std::vector<std::pair<std::string, std::string>> chunks;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      length = length << 8 | static_cast<std::uint8_t>(png[at + k]);
    }
    chunks.emplace_back(png.substr(at + 4, 4), png.substr(at + 8, length));
    at += 12 + length;
  }
  return chunks;
}

std::string chunk(const std::string& png, const std::string& type) {
  for (const auto& [name, data] : chunks_of(png)) {
    if (name == type) {
      return data;
    }
  }
  return "absent";
}

// Writes the picture and reads it with libpng.
void expect_that_it_comes_back(const PixelImage& image) {
  const Folder folder;
  write_png(folder / "a.png", image, {});
  png_image read{};
  read.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&read, (folder / "a.png").c_str()), 0);
  EXPECT_EQ(read.width, static_cast<unsigned>(image.width));
  EXPECT_EQ(read.height, static_cast<unsigned>(image.height));
  read.format = image.channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(read));
  ASSERT_NE(png_image_finish_read(&read, nullptr, bytes.data(), 0, nullptr), 0);
  EXPECT_EQ(read.warning_or_error, 0U) << read.message;
  EXPECT_TRUE(bytes == image.bytes);
}

TEST(Png, EightBitsComeBack) {
  for (const int channels : {3, 4}) {
    expect_that_it_comes_back(numbered_pixels(channels, 8));
  }
}

// Beyond 32 MiB rows are compressed as they come.
TEST(Png, ALargePictureComesBack) {
  PixelImage image{3000, 4000, 3, 8, {}, {}};
  for (std::size_t i = 0; i < std::size_t{3000} * 4000 * 3; ++i) {
    image.bytes.push_back(static_cast<std::uint8_t>(i / 7 + i / 9000));
  }
  expect_that_it_comes_back(image);
}

// The simplified reader knows no 16-bit sRGB: the plain one, with its bytes in file order (high byte first).
TEST(Png, SixteenBitsComeBack) {
  const Folder folder;
  for (const int channels : {3, 4}) {
    const PixelImage image = numbered_pixels(channels, 16);
    write_png(folder / "a.png", image, {});
    std::FILE* const file = std::fopen((folder / "a.png").c_str(), "rb");
    ASSERT_NE(file, nullptr);
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    EXPECT_EQ(png_get_bit_depth(png, info), 16);
    ASSERT_EQ(png_get_channels(png, info), channels);
    const png_bytepp rows = png_get_rows(png, info);
    std::size_t i = 0;
    for (std::size_t y = 0; y < 17; ++y) {
      for (std::size_t x = 0; x < 33 * static_cast<std::size_t>(channels); ++x, ++i) {
        ASSERT_EQ(rows[y][2 * x] << 8 | rows[y][2 * x + 1], image.words[i]) << i;
      }
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
  }
}

TEST(Png, CarriesTextsAsciiAndNot) {
  const Folder folder;
  PngOptions options;
  options.texts = {{"Software", "airlight 1.2.3"}, {"Description", "μ of the air"}};
  write_png(folder / "a.png", numbered_pixels(3, 8), options);
  const std::string png = test::contents_of(folder / "a.png");
  EXPECT_EQ(chunk(png, "tEXt"), std::string("Software\0airlight 1.2.3", 23));
  EXPECT_NE(chunk(png, "iTXt").find("μ of the air"), std::string::npos);
}

TEST(Png, EqualPicturesGiveEqualBytes) {
  EXPECT_EQ(encode_png(numbered_pixels(3, 8), {}), encode_png(numbered_pixels(3, 8), {}));
}

TEST(Png, AnEncoderErrorIsOurs) {
  PngOptions options;
  options.texts = {{"", "a text without a keyword, which the format forbids"}};
  EXPECT_NE(test::message_of<RunError>([&] { encode_png(numbered_pixels(3, 8), options); }).find("PNG: cannot encode"),
            std::string::npos);
}

TEST(Png, RowsMakeTheSameBytes) {
  for (const int bits : {8, 16}) {
    const PixelImage whole = numbered_pixels(3, bits);
    const PngOptions options{.colours = kSrgbCode, .texts = {{"Software", "test"}}};
    std::vector<std::byte> bytes;
    PngRows rows([&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); }, whole,
                 whole.height, options);
    for (int y = 0; y < whole.height;) {
      const int count = std::min(y == 0 ? 1 : 5, whole.height - y);
      PixelImage part{whole.width, count, whole.channels, bits, {}, {}};
      const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(whole.width) * whole.channels;
      if (bits == 8) {
        part.bytes.assign(whole.bytes.begin() + y * row, whole.bytes.begin() + (y + count) * row);
      } else {
        part.words.assign(whole.words.begin() + y * row, whole.words.begin() + (y + count) * row);
      }
      rows.add(part);
      y += count;
    }
    rows.finish();
    EXPECT_EQ(bytes, encode_png(whole, options));
  }
}

// By the PNG standard: sRGB with its chunks for older readers; else cICP, with a gamma where one comes near.
TEST(Png, SaysWhatItsColoursAre) {
  const Folder folder;
  const auto chunks = [&](const std::string& display) {
    write_png(folder / "a.png", numbered_pixels(3, 8), {.colours = colour_code_of_display(display), .texts = {}});
    const std::string png = test::contents_of(folder / "a.png");
    return std::array{chunk(png, "sRGB"), chunk(png, "cICP"), chunk(png, "gAMA"), chunk(png, "cHRM")};
  };
  using namespace std::string_literals;
  const std::string absent = "absent";
  const std::string srgb_gamma = "\0\0\xb1\x8f"s;    // 45455
  const std::string bt1886_gamma = "\0\0\xa2\xc3"s;  // 41667
  const auto srgb = chunks("sRGB - Display");
  EXPECT_EQ(chunk(test::contents_of(folder / "a.png"), "tIME"), absent);
  EXPECT_EQ(srgb[0], "\1"s);
  EXPECT_EQ(srgb[1], absent);
  EXPECT_EQ(srgb[2], srgb_gamma);
  EXPECT_EQ(srgb[3].size(), 32U);
  const auto television = chunks("Rec.1886 Rec.709 - Display");
  EXPECT_EQ(television[0], absent);
  EXPECT_EQ(television[1], "\1\1\0\1"s);
  EXPECT_EQ(television[2], bt1886_gamma);
  EXPECT_EQ(television[3], srgb[3]);
  const auto p3 = chunks("Display P3 - Display");
  EXPECT_EQ(p3[1], "\x0c\x0d\0\1"s);
  EXPECT_NE(p3[3], srgb[3]);
  const auto pq = chunks("Rec.2100-PQ - Display");
  EXPECT_EQ(pq[1], "\x09\x10\0\1"s);
  EXPECT_EQ(pq[2], absent);
  const auto unknown = chunks("Projector");
  for (const std::string& data : unknown) {
    EXPECT_EQ(data, absent);
  }
}

}  // namespace
}  // namespace airlight
