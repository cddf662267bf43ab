#pragma once
// An input in which one can go back, whatever the user named: a file as it is, a pipe or standard input as a copy.

#include <string>

#include "core/file_descriptor.h"

namespace airlight::cli {

class SeekableFile {
 public:
  // "-" is standard input. Throws InputError when the pipe cannot be read.
  explicit SeekableFile(const std::string& name);

  const std::string& name() const { return name_; }  // as people know it
  const std::string& path() const { return path_; }  // to be opened
  // A text that speaks of the path, by the name.
  std::string told(std::string text) const;

 private:
  std::string name_;
  std::string path_;
  FileDescriptor copy_;
};

}  // namespace airlight::cli
