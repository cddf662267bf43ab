#pragma once
// `airlight diff --update`: replaces the references by the new pictures.

#include <filesystem>
#include <string>
#include <vector>

#include "core/measure/frames.h"
#include "core/measure/report.h"

namespace airlight::cli {

class ReferenceUpdate {
 public:
  // To be made before comparing. `references`: the folder or the pattern that holds them. Throws InputError where a
  // reference cannot be written, or is a link that leads out of the folder.
  ReferenceUpdate(const measure::FilePairs& pairs, const std::string& references);

  // Replaces the references of all pairs that differ, and prints which. Replaces nothing and throws InputError if a
  // pair could not be compared or a new picture has changed since, RunError if writing fails.
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
