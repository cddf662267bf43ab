#pragma once
// The bytes of an EXR of scan lines in one part, by OpenEXR's file layout: head, a table of the blocks' places, blocks
// of rows. OpenEXR writes the head and reads the files; blocks are compressed here, since before 3.2 it does so by
// zlib, where libdeflate takes half the time.

#include <OpenEXR/ImfHeader.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/output/exr.h"

namespace airlight {

class ExrBlocks {
 public:
  // Writes the head and a table of zeros. `header`: compressed as ZIP or not at all, its channels HALF or FLOAT at
  // every pixel. Throws what OpenEXR throws of a header that it cannot write.
  ExrBlocks(ExrSink sink, const OPENEXR_IMF_NAMESPACE::Header& header);

  std::span<const std::byte> head() const { return head_; }
  // The file's words of 16 bits in a row: channels in order of their names, a half one word a pixel, a float two.
  std::size_t row_words() const { return row_words_; }
  // The first of a channel's words in a row.
  std::size_t first_word(const std::string& channel) const;

  // Room for the next rows; a call of add(rows) follows when they are there.
  std::span<std::uint16_t> room(int rows);
  void add(int rows);

  // To be called after the last row: writes the table.
  void finish();

 private:
  void write_blocks(std::size_t blocks);

  ExrSink sink_;
  OPENEXR_IMF_NAMESPACE::Header header_;
  std::vector<std::byte> head_;
  std::uint64_t end_ = 0;  // of the file so far
  std::size_t width_, height_;
  std::size_t rows_a_block_;
  std::size_t row_words_ = 0;
  std::vector<std::uint64_t> places_;  // of the blocks written
  std::vector<std::uint16_t> words_;   // of rows that no block has yet
  std::size_t rows_ = 0;               // of these
  std::size_t y_ = 0;                  // of the first of these
};

}  // namespace airlight
