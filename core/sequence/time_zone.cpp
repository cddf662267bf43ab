#include "core/sequence/time_zone.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "core/scene/suggestion.h"

namespace airlight::sequence {
namespace {

namespace fs = std::filesystem;

struct Damaged {};

// Big-endian numbers, one after the other.
class Bytes {
 public:
  explicit Bytes(std::string_view data) : data_(data) {}

  std::string_view take(std::size_t count) {
    if (count > data_.size()) throw Damaged();
    const std::string_view taken = data_.substr(0, count);
    data_.remove_prefix(count);
    return taken;
  }
  std::int64_t number(std::size_t width) {
    const std::string_view bytes = take(width);
    std::uint64_t value = (static_cast<unsigned char>(bytes[0]) & 0x80U) != 0 ? ~std::uint64_t{0} : 0;
    for (const char byte : bytes) value = value << 8U | static_cast<unsigned char>(byte);
    return static_cast<std::int64_t>(value);
  }
  std::size_t count() {
    const std::int64_t value = number(4);
    if (value < 0) throw Damaged();
    return static_cast<std::size_t>(value);
  }
  std::string_view rest() const { return data_; }

 private:
  std::string_view data_;
};

struct Header {
  char version = '\0';
  std::size_t utc_marks = 0, standard_marks = 0, leaps = 0, changes = 0, types = 0, letters = 0;

  // Bytes of the block that follows, with times of `width` bytes.
  std::size_t block(std::size_t width) const {
    return changes * (width + 1) + types * 6 + letters + leaps * (width + 4) + standard_marks + utc_marks;
  }
};

Header read_header(Bytes& bytes) {
  if (bytes.take(4) != "TZif") throw Damaged();
  Header header;
  header.version = bytes.take(16)[0];
  header.utc_marks = bytes.count();
  header.standard_marks = bytes.count();
  header.leaps = bytes.count();
  header.changes = bytes.count();
  header.types = bytes.count();
  header.letters = bytes.count();
  if (header.types == 0) throw Damaged();
  return header;
}

TimeZone parse_zone(std::string_view data) {
  Bytes bytes(data);
  Header header = read_header(bytes);
  std::size_t width = 4;
  if (header.version >= '2') {  // the same again with 64-bit times
    bytes.take(header.block(width));
    header = read_header(bytes);
    width = 8;
  }
  TimeZone zone;
  Bytes block(bytes.take(header.block(width)));
  for (std::size_t i = 0; i < header.changes; ++i) zone.changes.push_back(block.number(width));
  const std::string_view types = block.take(header.changes);
  std::vector<int> offsets;
  for (std::size_t i = 0; i < header.types; ++i) {
    offsets.push_back(static_cast<int>(block.number(4)));
    block.take(2);
  }
  for (const char type : types) {
    const auto index = static_cast<std::size_t>(static_cast<unsigned char>(type));
    if (index >= offsets.size()) throw Damaged();
    zone.offsets.push_back(offsets[index]);
  }
  zone.first_offset = offsets.front();
  if (!std::is_sorted(zone.changes.begin(), zone.changes.end())) throw Damaged();
  const std::string_view footer = bytes.rest();
  if (width == 8 && footer.size() > 2) {
    zone.rule = parse_zone_rule(footer.substr(1, footer.find('\n', 1) - 1));
    if (!zone.rule) throw Damaged();
  }
  return zone;
}

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

// A name that leads out of the folder is none.
bool stays_inside(const fs::path& name) {
  return !name.empty() && name.is_relative() &&
         std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".." || part == "."; });
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
  throw InputError(option + ": no time zone '" + name + "'" + (nearest ? "; did you mean '" + *nearest + "'?" : "") +
                   " Write a name such as Europe/Paris, or an offset such as +02:00");
}

}  // namespace

TimeZone find_zone(std::string_view name, const std::string& option, const fs::path& folder) {
  TimeZone zone;
  const std::optional<int> offset = name == "UTC" || name == "Z" ? std::optional(0) : fixed_offset(name);
  if (offset) {
    zone.name = name;
    zone.first_offset = *offset;
    return zone;
  }
  const fs::path file = folder / fs::path(name);
  std::error_code ignored;
  if (!stays_inside(name) || !fs::is_regular_file(file, ignored) || !is_zone_file(file)) {
    refuse(std::string(name), option, folder);
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string data{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  try {
    zone = parse_zone(data);
  } catch (const Damaged&) {
    throw InputError(option + ": " + file.string() + " is damaged; install tzdata again, or write an offset");
  }
  zone.name = name;
  return zone;
}

int offset_at(const TimeZone& zone, Milliseconds utc) {
  const std::int64_t seconds = utc >= 0 ? utc / kSecond : -((-utc + kSecond - 1) / kSecond);  // rounded down
  const auto next = std::upper_bound(zone.changes.begin(), zone.changes.end(), seconds);
  if (next == zone.changes.end() && zone.rule) return offset_at(*zone.rule, seconds);
  if (next == zone.changes.begin()) return zone.first_offset;
  return zone.offsets[static_cast<std::size_t>(next - zone.changes.begin() - 1)];
}

std::optional<Milliseconds> utc_of(const TimeZone& zone, Milliseconds local) {
  std::optional<Milliseconds> earliest;
  for (const Milliseconds near : {local - kDay, local + kDay}) {
    const int offset = offset_at(zone, near);
    const Milliseconds utc = local - offset * kSecond;
    if (offset_at(zone, utc) == offset && (!earliest || utc < *earliest)) earliest = utc;
  }
  return earliest;
}

}  // namespace airlight::sequence
