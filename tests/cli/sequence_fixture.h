#pragma once
// Shared by the tests of sequence: a small preset in a folder of its own, six frames of a morning.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/small_sky.h"

namespace airlight::test {

// Six frames of a morning over Paris.
inline Names morning(Names more = {}) {
  Names words = {"sequence", "sky.json", "--date", "2026-06-21", "--from", "06:00", "--to", "08:30",
                 "--step",   "30m",      "--lat",  "48.85",      "--lon",  "2.35",  "--tz", "Europe/Paris"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class Sequence : public SmallSky {
 protected:
  // Files of a folder by name, without its manifests, which contain times.
  std::map<std::string, std::string> pictures(const std::string& folder) const {
    std::map<std::string, std::string> found;
    for (const std::string& name : scratch_.files()) {
      if (name.starts_with(folder + "/") && !contains(name, "manifest")) {
        found[name.substr(folder.size() + 1)] = scratch_.read(name);
      }
    }
    return found;
  }
  void make_folder(const std::string& name) const { std::filesystem::create_directory(scratch_.path() / name); }
};

// "rendered" or "kept" for each frame of --json, by its number.
inline Names statuses(const std::string& json_lines) {
  std::map<int, std::string> found;
  for (const std::string& line : lines_of(json_lines)) {
    const nlohmann::json json = nlohmann::json::parse(line);
    if (json.contains("status")) {
      found[json["frame"]] = json["status"];
    }
  }
  Names in_order;
  for (const auto& [frame, status] : found) {
    in_order.push_back(status);
  }
  return in_order;
}

}  // namespace airlight::test
