#pragma once
// The origin of a picture, kept in the EXR's header and in texts of the PNG, so that the file alone is enough to render
// the picture again.

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

// Says that another version of airlight than `ours` wrote a file; empty where the same did, where `theirs` is unknown,
// or where `ours` is.
std::string version_note(const std::string& theirs, const std::string& ours);

// Looks at the first four bytes; false for a file that is missing or cannot be read.
bool is_exr(const std::filesystem::path& file);
bool is_png(const std::filesystem::path& file);
// The same for a seekable stream, which is at its start again afterwards.
bool is_exr(std::istream& in);
bool is_png(std::istream& in);

// The origin of an EXR or PNG. It reads the header alone, so a file that is cut short after its header still yields it.
// Throws InputError: missing, neither of the two, header damaged, not written by airlight.
Provenance read_provenance(const std::filesystem::path& file);
// The same from a seekable stream; `name` is for messages.
Provenance read_provenance(std::istream& in, const std::string& name);

}  // namespace airlight
