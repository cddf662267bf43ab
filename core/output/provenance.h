#pragma once
// What made a picture: kept in the EXR's header and in texts of the PNG, so that the file alone is enough to render it
// again.

#include <filesystem>
#include <istream>
#include <string>

namespace airlight {

struct Provenance {
  std::string preset_json;  // the whole resolved scene
  std::string method;
  std::string version;  // of airlight
  std::string device;

  bool operator==(const Provenance&) const = default;
};

// Looks at the first four bytes; false for a file that is missing or cannot be read.
bool is_exr(const std::filesystem::path& file);
bool is_png(const std::filesystem::path& file);
// The same of a stream in which one can go back, and which is at its start again then.
bool is_exr(std::istream& in);
bool is_png(std::istream& in);

// How an EXR or PNG was made. Reads the header alone: a file cut short after it still tells how it was made.
// Throws InputError: missing, neither of the two, header damaged, not written by airlight.
Provenance read_provenance(const std::filesystem::path& file);
// The same from a stream in which one can go back; `name` is for messages.
Provenance read_provenance(std::istream& in, const std::string& name);

}  // namespace airlight
