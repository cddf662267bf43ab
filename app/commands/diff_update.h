#pragma once
// `airlight diff --update`: the new pictures become the references.

#include <filesystem>
#include <string>
#include <vector>

#include "core/measure/frames.h"
#include "core/measure/report.h"

namespace airlight::cli {

class ReferenceUpdate {
 public:
  // Before comparing. Throws InputError where a reference cannot be written.
  explicit ReferenceUpdate(const measure::FilePairs& pairs);

  // Replaces the references of all pairs that differ, and tells which. Nothing is replaced, by an InputError, where a
  // pair could not be compared or a new picture has changed since; or by a RunError where writing fails.
  std::vector<std::string> take(const std::vector<measure::NamedReport>& entries) const;

 private:
  struct Seen {
    std::string file;
    std::uintmax_t size = 0;
    std::filesystem::file_time_type written;
  };
  std::vector<Seen> seen_;
};

}  // namespace airlight::cli
