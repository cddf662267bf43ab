#include "core/output/provenance.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "core/output/exr.h"
#include "core/output/exr_header.h"
#include "core/output/png.h"
#include "core/output/provenance_keys.h"
#include "tests/output/files.h"

namespace airlight {
namespace {

using test::Folder;
using test::message_of;

const Provenance kMade = {std::string(5000, '{') + "\u03bc", "march", "1.2.3", "llvmpipe (LLVM 15)"};

void write_sky(const std::filesystem::path& file, const std::optional<Provenance>& provenance) {
  RadianceImage image{40, 30, std::vector<float>(4 * 40 * 30, 0.25F)};
  std::vector<ExrChannel> channels;
  add_channels(channels, "", image);
  ExrOptions options;
  options.provenance = provenance;
  write_exr(file, 40, 30, channels, options);
}

std::string reading_refusal(const std::filesystem::path& file) {
  return message_of<InputError>([&] { read_provenance(file); });
}

TEST(Provenance, ComesBackAsWritten) {
  const Folder folder;
  write_sky(folder / "a.exr", kMade);
  EXPECT_TRUE(is_exr(folder / "a.exr"));
  EXPECT_EQ(read_provenance(folder / "a.exr"), kMade);
}

// The whole text in one attribute, as in older files.
TEST(Provenance, OfOnePieceIsRead) {
  const Folder folder;
  const std::string start("\x76\x2f\x31\x01\x02\0\0\0airlight:preset\0string\0", 31);
  const std::string text(0x0432, 'p');
  test::put(folder / "a.exr", start + std::string("\x32\x04\0\0", 4) + text + std::string(1, '\0'));
  EXPECT_EQ(read_provenance(folder / "a.exr").preset_json, text);
}

// ffmpeg reads no more than 255 bytes of an attribute that it does not know, and then takes the rest for another.
TEST(Provenance, NoAttributeIsLongerThanFfmpegReads) {
  const Folder folder;
  for (const std::size_t length : {0U, 1U, 254U, 255U, 256U, 510U, 511U, 3000U}) {
    for (const std::string letter : {"a", "\u03bc", "\u20ac", "\U0001f31e"}) {
      Provenance made = kMade;
      made.preset_json = std::string(length % letter.size(), '.');
      while (made.preset_json.size() < length) {
        made.preset_json += letter;
      }
      write_sky(folder / "a.exr", made);
      EXPECT_EQ(read_provenance(folder / "a.exr"), made) << length << " " << letter;
      std::ifstream in(folder / "a.exr", std::ios::binary);
      for (const auto& [name, attribute] :
           read_exr_header(in, std::filesystem::file_size(folder / "a.exr")).attributes) {
        EXPECT_LE(attribute.value.size(), 255U) << name;
        const auto first = attribute.value.empty() ? '.' : attribute.value.front();
        EXPECT_NE(static_cast<unsigned char>(first) & 0xC0U, 0x80U) << name << " begins within a character";
      }
    }
  }
}

TEST(Provenance, APngTellsItToo) {
  const Folder folder;
  PngOptions options;
  options.texts = {{kPresetKey, kMade.preset_json},  // with a letter that makes it iTXt
                   {kMethodKey, kMade.method},
                   {kVersionKey, kMade.version},
                   {kDeviceKey, kMade.device}};
  write_png(folder / "a.png", {2, 1, 3, 8, std::vector<std::uint8_t>(6), {}}, options);
  EXPECT_TRUE(is_png(folder / "a.png"));
  EXPECT_EQ(read_provenance(folder / "a.png"), kMade);
  const std::string whole = test::contents_of(folder / "a.png");
  test::put(folder / "cut.png", whole.substr(0, whole.size() - 30));
  EXPECT_EQ(read_provenance(folder / "cut.png"), kMade);
  write_png(folder / "foreign.png", {2, 1, 3, 8, std::vector<std::uint8_t>(6), {}}, {});
  EXPECT_NE(reading_refusal(folder / "foreign.png").find("has no text airlight:preset"), std::string::npos);
}

TEST(Provenance, SaysWhatIsWrongWithAFile) {
  const Folder folder;
  write_sky(folder / "foreign.exr", std::nullopt);
  test::put(folder / "text.exr", "{\"airlight\": 1}");
  test::put(folder / "empty.exr", "");
  EXPECT_NE(reading_refusal(folder / "foreign.exr").find("was not written by airlight"), std::string::npos);
  EXPECT_NE(reading_refusal(folder / "text.exr").find("is not an EXR file"), std::string::npos);
  EXPECT_NE(reading_refusal(folder / "empty.exr").find("is not an EXR file"), std::string::npos);
  EXPECT_NE(reading_refusal(folder / "none.exr").find("no such file"), std::string::npos);
  EXPECT_NE(reading_refusal(folder.path()).find("is not a file"), std::string::npos);
  EXPECT_FALSE(is_exr(folder / "text.exr"));
  EXPECT_FALSE(is_exr(folder / "none.exr"));
}

// A file cut anywhere: either the header is whole and yields the same, or there is one clear error.
TEST(Provenance, CutShortIsRefusedUnlessTheHeaderIsWhole) {
  const Folder folder;
  write_sky(folder / "a.exr", kMade);
  const std::string whole = test::contents_of(folder / "a.exr");
  std::size_t read = 0, refused = 0;
  for (std::size_t length = 4; length < whole.size(); length += length < 400 ? 1 : 37) {
    test::put(folder / "cut.exr", whole.substr(0, length));
    try {
      EXPECT_EQ(read_provenance(folder / "cut.exr"), kMade) << length;
      ++read;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("damaged or cut short"), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 0U);
  EXPECT_GT(refused, 400U);
}

TEST(Provenance, ADamagedSizeTakesNoMemory) {
  const Folder folder;
  const std::string start("\x76\x2f\x31\x01\x02\0\0\0airlight:preset\0string\0", 31);
  for (const std::string size : {"\xff\xff\xff\x7f", "\xff\xff\xff\xff"}) {
    test::put(folder / "a.exr", start + size + "{}");
    EXPECT_NE(reading_refusal(folder / "a.exr").find("longer than the file"), std::string::npos)
        << reading_refusal(folder / "a.exr");
  }
}

TEST(Provenance, GarbageNeverCrashes) {
  const Folder folder;
  write_sky(folder / "a.exr", kMade);
  const std::string whole = test::contents_of(folder / "a.exr");
  std::mt19937 random(1);
  std::size_t refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string broken = whole;
    for (int k = 0; k < 1 + round % 8; ++k) {
      broken[4 + random() % (round % 2 == 0 ? 396 : broken.size() - 4)] = static_cast<char>(random());
    }
    test::put(folder / "broken.exr", broken);
    try {
      read_provenance(folder / "broken.exr");
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 30U);
}

}  // namespace
}  // namespace airlight
