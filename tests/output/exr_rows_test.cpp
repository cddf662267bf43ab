// EXRs given some rows at a time, and the files that they are streamed into.

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/output/atomic_file.h"
#include "core/output/exr.h"
#include "tests/output/files.h"

namespace airlight {
namespace {

using test::contents_of;
using test::Folder;
using test::message_of;

constexpr int kWidth = 37;
constexpr int kHeight = 300;  // more than is converted at a time

std::vector<float> wave() {
  std::vector<float> samples(kWidth * kHeight);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = 1e4F + 1e4F * std::sin(0.37F * static_cast<float>(i));
  }
  return samples;
}

std::vector<ExrChannel> channels_from(const std::vector<float>& samples, int first_row) {
  const float* first = samples.data() + static_cast<std::ptrdiff_t>(first_row) * kWidth;
  return {{"R", first, 1, false}, {"depth.Z", first, 1, true}};
}

std::vector<std::byte> in_parts(const std::vector<float>& samples, int rows_at_once, const ExrOptions& options) {
  std::vector<std::byte> file;
  const ExrSink sink = [&](std::uint64_t position, std::span<const std::byte> bytes) {
    file.resize(std::max(file.size(), position + bytes.size()));
    std::memcpy(file.data() + position, bytes.data(), bytes.size());
  };
  ExrRows rows(sink, kWidth, kHeight, channels_from(samples, 0), options);
  for (int y = 0; y < kHeight; y += rows_at_once) {
    rows.add(std::min(rows_at_once, kHeight - y), channels_from(samples, y));
  }
  EXPECT_EQ(rows.finish({{"airlight:exposure", 2.5F}}).samples, 2 * samples.size());
  return file;
}

TEST(ExrRows, ManyPartsMakeTheBytesOfOne) {
  const std::vector<float> samples = wave();
  ExrOptions options;
  options.comments = "airlight:exposure is no attribute here";
  for (const bool half : {true, false}) {
    options.half = half;
    options.numbers["airlight:exposure"] = 2.5F;
    const std::vector<std::byte> whole = encode_exr(kWidth, kHeight, channels_from(samples, 0), options).bytes;
    options.numbers["airlight:exposure"] = 0.0F;  // known at the end alone
    for (const int rows : {1, 7, 16, 150, kHeight}) {
      EXPECT_EQ(in_parts(samples, rows, options), whole) << rows << " rows at a time";
    }
  }
}

std::vector<float> read_depth(Imf::InputFile& file) {
  std::vector<float> read(kWidth * kHeight);
  Imf::FrameBuffer frame;
  frame.insert("depth.Z", Imf::Slice::Make(Imf::FLOAT, read.data(), Imath::V2i(0, 0), kWidth, kHeight));
  file.setFrameBuffer(frame);
  file.readPixels(0, kHeight - 1);
  return read;
}

// A half near 20000 is right to 8.
TEST(ExrRows, AChannelMayBeFloatAmongHalves) {
  const Folder folder;
  const std::vector<float> samples = wave();
  write_exr(folder / "a.exr", kWidth, kHeight, channels_from(samples, 0), {});
  Imf::InputFile file((folder / "a.exr").c_str());
  EXPECT_EQ(file.header().channels().findChannel("R")->type, Imf::HALF);
  EXPECT_EQ(file.header().channels().findChannel("depth.Z")->type, Imf::FLOAT);
  EXPECT_EQ(read_depth(file), samples);
}

// Blocks that compression would make longer stand in the file as they are: noise by a linear congruence (Knuth).
TEST(ExrRows, NoiseComesBack) {
  const Folder folder;
  std::vector<float> noise(kWidth * kHeight);
  std::uint64_t state = 1;
  for (float& sample : noise) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    sample = std::bit_cast<float>(static_cast<std::uint32_t>(state >> 32) & 0xbfffffffU);  // finite
  }
  const std::vector<ExrChannel> channels{{"depth.Z", noise.data(), 1, true}};
  const ExrFile encoded = encode_exr(kWidth, kHeight, channels, {});
  EXPECT_GT(encoded.bytes.size(), sizeof(float) * kWidth * kHeight);
  write_file(folder / "a.exr", encoded.bytes);
  Imf::InputFile file((folder / "a.exr").c_str());
  EXPECT_EQ(read_depth(file), noise);
}

TEST(ExrRows, WhatTheSinkSaysIsSaid) {
  const std::vector<float> samples = wave();
  const ExrSink full = [](std::uint64_t, std::span<const std::byte>) { throw RunError("sky.exr: no space"); };
  EXPECT_EQ(message_of<RunError>([&] { ExrRows(full, kWidth, kHeight, channels_from(samples, 0), {}); }),
            "sky.exr: no space");
}

TEST(FileInProgress, AppearsWhenItIsWholeWhateverTheOrder) {
  const Folder folder;
  test::put(folder / "a.exr", "older");
  FileInProgress file(folder / "a.exr");
  file.write(5, test::text_bytes(" world"));
  file.write(0, test::text_bytes("hello"));
  EXPECT_EQ(contents_of(folder / "a.exr"), "older");
  EXPECT_EQ(folder.names().size(), 2U);
  file.commit();
  EXPECT_EQ(contents_of(folder / "a.exr"), "hello world");
  EXPECT_EQ(folder.names(), std::set<std::string>{"a.exr"});
}

TEST(FileInProgress, LeavesNothingWithoutItsEnd) {
  const Folder folder;
  test::put(folder / "a.exr", "older");
  FileInProgress(folder / "a.exr").write(0, test::text_bytes("half"));
  EXPECT_EQ(contents_of(folder / "a.exr"), "older");
  EXPECT_EQ(folder.names(), std::set<std::string>{"a.exr"});
}

// What no rename can replace is opened at the end, and gets its pieces in their order.
TEST(FileInProgress, IsHeldForAPipe) {
  const Folder folder;
  const std::string pipe = (folder / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  FileInProgress file(pipe, FileInProgress::Order::held);  // nobody reads yet: to open it would wait
  file.write(4, test::text_bytes("file"));
  file.write(0, test::text_bytes("held"));
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  file.commit();
  std::array<char, 16> found{};
  EXPECT_EQ(::read(reader, found.data(), found.size()), 8);
  EXPECT_STREQ(found.data(), "heldfile");
  ::close(reader);
}

TEST(FileInProgress, IsNoPipe) {
  EXPECT_EQ(message_of<InputError>([] { FileInProgress("/dev/stdout"); }),
            "/dev/stdout: a picture in tiles needs a file in which one can go back; name one, such as sky.exr");
}

}  // namespace
}  // namespace airlight
