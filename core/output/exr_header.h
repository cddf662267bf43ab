#pragma once
// The attributes of an EXR's headers, read without OpenEXR. With a damaged size OpenEXR takes gigabytes before it meets
// the end of the file.

#include <cstdint>
#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <string>

namespace airlight {

struct ExrAttribute {
  std::string type;
  std::string value;  // of strings, lists of channels and anything up to 64 bytes; else empty
};

struct ExrHeader {
  std::uint32_t flags = 0;  // those above the version's byte
  std::map<std::string, ExrAttribute> attributes;
  std::uint64_t end = 0;  // where the header ends in the file
};

// The text of a string attribute, joined where it is stored in pieces (core/output/long_text.h).
std::optional<std::string> text_of(const ExrHeader& header, const std::string& name);

// The first header; reads from the start of the stream. Throws std::runtime_error with a reason that continues "the EXR
// is damaged: ...".
ExrHeader read_exr_header(std::istream& in, std::uint64_t file_size);

// Number of chunks that the data window and the compression ask for, in a file of scan lines or in a tiled one, whose
// smaller levels are left out; 0 when the header does not tell.
std::int64_t chunk_count(const ExrHeader& header);

// True in a file of tiles.
bool is_tiled(const ExrHeader& header);

// To be called before a library opens the file. Throws as above where a header does not tell what it asks for, or where
// it or what it asks for (the table of chunks, and pixels however well compressed) is longer than the file. A file that
// cannot be opened or is no EXR passes.
void require_room_for_exr(const std::filesystem::path& file);

// Reads a number of `bytes` bytes, low byte first. Throws as above at the end of the stream.
std::uint64_t read_little_endian(std::istream& in, int bytes);

}  // namespace airlight
