#pragma once
// What a PNG says of itself in tEXt and uncompressed iTXt chunks, read from chunk to chunk without its pixels.

#include <cstdint>
#include <istream>
#include <map>
#include <string>

namespace airlight {

struct PngTexts {
  std::map<std::string, std::string> texts;  // by keyword
  bool is_whole = false;                     // the last chunk ends it, where the file does
};

// From the start of the stream; what was read up to the damage where the file is cut short.
PngTexts read_png_texts(std::istream& in, std::uint64_t file_size);

}  // namespace airlight
