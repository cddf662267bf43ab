#pragma once
// The attributes of an EXR's first header, read without OpenEXR. With a damaged size OpenEXR takes gigabytes before it
// meets the end of the file.

#include <cstdint>
#include <istream>
#include <map>
#include <optional>
#include <string>

namespace airlight {

struct ExrAttribute {
  std::string type;
  std::string value;  // of strings and of anything up to 64 bytes; else empty
};

struct ExrHeader {
  std::uint32_t flags = 0;  // those above the version's byte
  std::map<std::string, ExrAttribute> attributes;
  std::uint64_t end = 0;  // where the header ends in the file
};

// The text of a string attribute, joined where it is stored in pieces (core/output/long_text.h).
std::optional<std::string> text_of(const ExrHeader& header, const std::string& name);

// Reads from the start of the stream. Throws std::runtime_error with a reason that continues "the EXR is damaged: ...".
ExrHeader read_exr_header(std::istream& in, std::uint64_t file_size);

// Reads a number of `bytes` bytes, low byte first. Throws as above at the end of the stream.
std::uint64_t read_little_endian(std::istream& in, int bytes);

}  // namespace airlight
