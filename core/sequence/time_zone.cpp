#include "core/sequence/time_zone.h"

#include <cctz/civil_time.h>
#include <cctz/time_zone.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "core/base/error.h"
#include "core/scene/suggestion.h"

namespace airlight::sequence {

struct TimeZone::Clocks {
  cctz::time_zone zone;
};

namespace {

namespace fs = std::filesystem;
namespace chrono = std::chrono;

// "+02:00", "-0330", "+2".
std::optional<int> fixed_offset(std::string_view text) {
  if (text.empty() || (text.front() != '+' && text.front() != '-')) return std::nullopt;
  std::string digits;
  for (const char c : text.substr(1)) {
    if (c == ':' && (digits.size() == 2 || digits.size() == 1) && digits.size() + 4 == text.size()) continue;
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) return std::nullopt;
    digits += c;
  }
  if (digits.empty() || digits.size() > 4) return std::nullopt;
  const int number = std::atoi(digits.c_str());
  const int hours = digits.size() > 2 ? number / 100 : number;
  const int minutes = digits.size() > 2 ? number % 100 : 0;
  if (hours > 15 || minutes > 59) return std::nullopt;
  const int seconds = 3600 * hours + 60 * minutes;
  return text.front() == '-' ? -seconds : seconds;
}

bool is_zone_file(const fs::path& file) {
  std::array<char, 4> magic{};
  std::ifstream stream(file, std::ios::binary);
  return stream.read(magic.data(), magic.size()) && std::string_view(magic.data(), magic.size()) == "TZif";
}

// Whether the name stays inside the folder; a name that leads out of it is no zone.
bool stays_inside(const fs::path& name) {
  return !name.empty() && name.is_relative() &&
         std::ranges::none_of(name, [](const fs::path& part) { return part == ".." || part == "."; });
}

std::vector<std::string> zone_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (auto entry = fs::recursive_directory_iterator(folder, ignored); entry != fs::recursive_directory_iterator();
       entry.increment(ignored)) {
    const std::string name = entry->path().lexically_relative(folder).string();
    const bool copy = name.starts_with("posix") || name.starts_with("right");
    if (!copy && std::isupper(static_cast<unsigned char>(name.front())) != 0 && !entry->is_directory(ignored)) {
      names.push_back(name);
    }
  }
  return names;
}

[[noreturn]] void refuse(const std::string& name, const std::string& option, const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw InputError(option + ": no time zones at " + folder.string() +
                     " (Debian: the package tzdata); install them, or write an offset such as +02:00");
  }
  const std::optional<std::string> nearest = nearest_name(name, zone_names(folder));
  throw InputError(option + ": no time zone '" + name + "'" + (nearest ? "; did you mean '" + *nearest + "'?" : ".") +
                   " Write a name such as Europe/Paris, or an offset such as +02:00");
}

}  // namespace

TimeZone find_zone(std::string_view name, const std::string& option, const fs::path& folder) {
  const auto zone = [&](const cctz::time_zone& clocks) {
    return TimeZone{std::string(name), std::make_shared<const TimeZone::Clocks>(TimeZone::Clocks{clocks})};
  };
  const std::optional<int> offset = name == "UTC" || name == "Z" ? std::optional(0) : fixed_offset(name);
  if (offset) {
    return zone(cctz::fixed_time_zone(chrono::seconds(*offset)));
  }
  const fs::path file = folder / fs::path(name);
  std::error_code ignored;
  if (!stays_inside(name) || !fs::is_regular_file(file, ignored) || !is_zone_file(file)) {
    refuse(std::string(name), option, folder);
  }
  cctz::time_zone clocks;
  if (!cctz::load_time_zone(fs::absolute(file).string(), &clocks)) {
    throw InputError(option + ": " + file.string() + " is damaged; install tzdata again, or write an offset");
  }
  return zone(clocks);
}

int offset_at(const TimeZone& zone, Milliseconds utc) {
  const chrono::sys_time<chrono::milliseconds> when{chrono::milliseconds(utc)};
  return zone.clocks ? zone.clocks->zone.lookup(chrono::floor<chrono::seconds>(when)).offset : 0;
}

std::optional<Milliseconds> utc_of(const TimeZone& zone, Milliseconds local) {
  if (!zone.clocks) {
    return local;
  }
  const chrono::sys_time<chrono::milliseconds> shown{chrono::milliseconds(local)};
  const chrono::sys_seconds second = chrono::floor<chrono::seconds>(shown);
  const cctz::time_zone::civil_lookup found = zone.clocks->zone.lookup(cctz::convert(second, cctz::utc_time_zone()));
  if (found.kind == cctz::time_zone::civil_lookup::SKIPPED) {
    return std::nullopt;
  }
  return found.pre.time_since_epoch().count() * kSecond + (shown - second).count();
}

}  // namespace airlight::sequence
