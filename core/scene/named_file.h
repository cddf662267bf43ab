#pragma once
// Files that a preset or an option names: regular files alone, read with a bound, so that no name makes the program
// wait for ever or fills the memory.

#include <filesystem>
#include <string>

namespace airlight {

// Why a name cannot be read as a file: "is a directory", "is a pipe", ..., or the system's reason. Empty: it is a
// regular file.
std::string named_file_problem(const std::filesystem::path& file);

struct NamedText {
  std::string text;     // without a byte-order mark
  std::string problem;  // why there is none; continues "FILE cannot be read: "
};

// The text of such a file of at most 16 MiB, more than any preset or curve has.
NamedText read_named_text(const std::filesystem::path& file);

}  // namespace airlight
