#pragma once
// A PNG's tEXt and uncompressed iTXt chunks, read from chunk to chunk without the pixels.

#include <cstdint>
#include <istream>
#include <map>
#include <string>

namespace airlight {

struct PngTexts {
  std::map<std::string, std::string> texts;  // by keyword
  bool is_whole = false;                     // the last chunk is there and ends where the file ends
};

// Reads from the start of the stream; of a damaged or cut file, all up to the damage.
PngTexts read_png_texts(std::istream& in, std::uint64_t file_size);

}  // namespace airlight
