#include "core/output/exr_blocks.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include "core/base/in_parallel.h"
#include "core/output/deflate.h"

namespace airlight {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

static_assert(std::endian::native == std::endian::little, "the file's numbers are written as they lie in memory");

// CPU-ms and kB of 1280x720, earth-noon, valley-fog and earth-twilight (floats): level 1 takes 14, 19, 79 and 241, 987,
// 8925, level 4 16, 30, 117 and 223, 959, 8702, level 6 35, 59, 131 and 218, 938, 8687; zlib's level 4, OpenEXR's
// default, 27, 54, 263 and 222, 978, 8712.
constexpr int kLevel = 4;

constexpr std::size_t kRowsOfZip = 16;
constexpr std::size_t kBlockHead = 8;  // bytes: the first row, and how many bytes follow

class HeadStream : public imf::OStream {
 public:
  explicit HeadStream(std::vector<std::byte>& bytes) : OStream("picture"), bytes_(bytes) {}
  void write(const char data[], int size) override {
    const std::span<const std::byte> piece = std::as_bytes(std::span(data, static_cast<std::size_t>(size)));
    bytes_.resize(std::max(bytes_.size(), position_ + piece.size()));
    std::ranges::copy(piece, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
    position_ += piece.size();
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }

 private:
  std::vector<std::byte>& bytes_;
  std::uint64_t position_ = 0;
};

// All that OpenEXR writes before the blocks, its table of places of blocks, which are missing, at the end.
std::vector<std::byte> head_of(const imf::Header& header) {
  std::vector<std::byte> head;
  HeadStream stream(head);
  { const imf::OutputFile file(stream, header, 0); }
  return head;
}

std::size_t words_of(const imf::Channel& channel) {
  return channel.type == imf::HALF ? 1 : 2;
}

// What ZIP compresses: the low bytes of all words, then the high ones, each less the byte before it, plus 128.
std::vector<std::uint8_t> differences(std::span<const std::uint16_t> words) {
  constexpr std::uint32_t kMiddle = 128;
  const std::size_t count = words.size();
  std::vector<std::uint8_t> result(2 * count);
  std::uint8_t* const low = result.data();
  std::uint8_t* const high = low + count;
  low[0] = static_cast<std::uint8_t>(words.front());
  high[0] = static_cast<std::uint8_t>((words.front() >> 8) - words.back() + kMiddle);
  for (std::size_t i = 1; i < count; ++i) {
    const std::uint32_t word = words[i];
    const std::uint32_t before = words[i - 1];
    low[i] = static_cast<std::uint8_t>(word - before + kMiddle);
    high[i] = static_cast<std::uint8_t>((word >> 8) - (before >> 8) + kMiddle);
  }
  return result;
}

// A block as it stands in the file. One that compression does not make smaller stands there as it is.
std::vector<std::uint8_t> block_of(std::span<const std::uint16_t> words, std::size_t y, Deflate* deflate) {
  const std::size_t size = words.size_bytes();
  std::vector<std::uint8_t> block(kBlockHead + size);
  const std::span<std::uint8_t> content = std::span(block).subspan(kBlockHead);
  std::size_t used = deflate == nullptr ? 0 : deflate->compress(differences(words), content.first(size - 1));
  if (used == 0) {
    used = size;
    std::memcpy(content.data(), words.data(), size);
  }
  const std::array<std::int32_t, 2> start{static_cast<std::int32_t>(y), static_cast<std::int32_t>(used)};
  std::memcpy(block.data(), start.data(), kBlockHead);
  block.resize(kBlockHead + used);
  return block;
}

}  // namespace

ExrBlocks::ExrBlocks(ExrSink sink, const imf::Header& header)
    : sink_(std::move(sink)),
      header_(header),
      head_(head_of(header)),
      end_(head_.size()),
      width_(static_cast<std::size_t>(header.dataWindow().size().x + 1)),
      height_(static_cast<std::size_t>(header.dataWindow().size().y + 1)),
      rows_a_block_(header.compression() == imf::NO_COMPRESSION ? 1 : kRowsOfZip) {
  assert(header.compression() == imf::NO_COMPRESSION || header.compression() == imf::ZIP_COMPRESSION);
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    row_words_ += width_ * words_of(channel.channel());
  }
  sink_(0, head_);
}

std::size_t ExrBlocks::first_word(const std::string& name) const {
  std::size_t word = 0;
  auto channel = header_.channels().begin();
  for (; channel != header_.channels().end() && channel.name() != name; ++channel) {
    word += width_ * words_of(channel.channel());
  }
  assert(channel != header_.channels().end());
  return word;
}

std::span<std::uint16_t> ExrBlocks::room(int rows) {
  const std::size_t filled = rows_ * row_words_;
  const std::size_t wanted = static_cast<std::size_t>(rows) * row_words_;
  words_.resize(std::max(words_.size(), filled + wanted));
  return std::span(words_).subspan(filled, wanted);
}

void ExrBlocks::add(int rows) {
  rows_ += static_cast<std::size_t>(rows);
  const bool is_last = y_ + rows_ == height_;
  write_blocks(is_last ? (rows_ + rows_a_block_ - 1) / rows_a_block_ : rows_ / rows_a_block_);
}

void ExrBlocks::write_blocks(std::size_t count) {
  std::vector<std::vector<std::uint8_t>> blocks(count);
  const std::size_t threads = std::min<std::size_t>(count, std::max(1U, std::thread::hardware_concurrency()));
  in_parallel(threads, [&](std::size_t thread) {
    std::optional<Deflate> deflate;
    if (header_.compression() == imf::ZIP_COMPRESSION) {
      deflate.emplace(kLevel);
    }
    for (std::size_t b = thread; b < count; b += threads) {
      const std::size_t first = b * rows_a_block_;
      const std::size_t rows = std::min(rows_a_block_, rows_ - first);
      blocks[b] = block_of(std::span(words_).subspan(first * row_words_, rows * row_words_), y_ + first,
                           deflate ? &*deflate : nullptr);
    }
  });
  for (const std::vector<std::uint8_t>& block : blocks) {
    places_.push_back(end_);
    sink_(end_, std::as_bytes(std::span(block)));
    end_ += block.size();
  }
  const std::size_t done = std::min(count * rows_a_block_, rows_);
  std::copy(words_.begin() + static_cast<std::ptrdiff_t>(done * row_words_),
            words_.begin() + static_cast<std::ptrdiff_t>(rows_ * row_words_), words_.begin());
  rows_ -= done;
  y_ += done;
}

void ExrBlocks::finish() {
  const std::span<const std::byte> table = std::as_bytes(std::span(places_));
  sink_(head_.size() - table.size(), table);
}

}  // namespace airlight
