#pragma once
// A seekable input for whatever the user named: a file itself; a copy of a pipe or of standard input.

#include <string>

#include "core/base/file_descriptor.h"

namespace airlight::cli {

class SeekableFile {
 public:
  // "-" is standard input. Throws InputError when the pipe cannot be read.
  explicit SeekableFile(const std::string& name);

  const std::string& name() const { return name_; }  // for people
  const std::string& path() const { return path_; }  // to be opened
  // The text with the name in place of the path.
  std::string told(std::string text) const;

 private:
  std::string name_;
  std::string path_;
  FileDescriptor copy_;
};

}  // namespace airlight::cli
