#pragma once
// A place's clocks: the system's time zone files (RFC 8536), read by cctz, or a fixed offset.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/sequence/civil_time.h"

namespace airlight::sequence {

struct TimeZone {
  std::string name;  // "Europe/Paris", "+02:00", "UTC"
  struct Clocks;
  std::shared_ptr<const Clocks> clocks = {};  // null: UTC
};

inline constexpr const char* kZoneFolder = "/usr/share/zoneinfo";

// "Europe/Paris", "UTC", "+02:00", "-0330", "+2". Throws InputError: no such zone in the folder (with the nearest), no
// folder at all (names the package), a damaged file. `option` names the option in messages.
TimeZone find_zone(std::string_view name, const std::string& option, const std::filesystem::path& folder = kZoneFolder);

// Seconds east of UTC.
int offset_at(const TimeZone& zone, Milliseconds utc);

// The moment at which the clocks show `local`: the earlier one where they show it twice, none where they skip it.
std::optional<Milliseconds> utc_of(const TimeZone& zone, Milliseconds local);

}  // namespace airlight::sequence
