#include "core/gpu/kept_values.h"

#include <cstring>
#include <mutex>

#include "core/gpu/driver_code.h"
#include "core/gpu/kept_files.h"
#include "core/gpu/sha256.h"
#include "core/gpu/stored_tables.h"

namespace airlight {
namespace {

// A word with this bit says how often the next one stands; one without it, how many words follow as they are.
constexpr std::uint32_t kRun = 0x80000000U;
constexpr std::size_t kShortestRun = 3;
constexpr std::size_t kMostWords = std::size_t{1} << 28U;  // that are made of a file's

constexpr const char* kFolder = "values";
constexpr const char* kEnding = ".values";

struct Chosen {
  std::mutex mutex;
  std::filesystem::path folder;
};

Chosen& chosen() {
  static Chosen all;
  return all;
}

std::filesystem::path chosen_folder() {
  const std::scoped_lock lock(chosen().mutex);
  return chosen().folder;
}

// What the build left, which is only read.
std::vector<std::uint32_t> built_words(const Digest& key) {
  const std::filesystem::path tables = built_tables();
  return tables.empty() ? std::vector<std::uint32_t>()
                        : unpacked(KeptFiles(tables.parent_path() / kFolder, kEnding).find(key));
}

std::size_t run_from(std::span<const std::uint32_t> words, std::size_t first) {
  std::size_t end = first + 1;
  while (end < words.size() && words[end] == words[first]) ++end;
  return end - first;
}

}  // namespace

void keep_values_in(const std::filesystem::path& folder) {
  const std::scoped_lock lock(chosen().mutex);
  chosen().folder = folder;
}

std::vector<std::uint32_t> packed(std::span<const std::uint32_t> words) {
  std::vector<std::uint32_t> out;
  out.reserve(words.size());  // memory that is not touched is not taken; grown step by step it would be twice as much
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t run = run_from(words, at);
    if (run >= kShortestRun) {
      out.insert(out.end(), {kRun | static_cast<std::uint32_t>(run), words[at]});
      at += run;
      continue;
    }
    std::size_t end = at;
    for (std::size_t next = run; end < words.size() && next < kShortestRun; end += next) {
      next = run_from(words, end);
      if (next >= kShortestRun) break;
    }
    out.push_back(static_cast<std::uint32_t>(end - at));
    out.insert(out.end(), words.begin() + static_cast<std::ptrdiff_t>(at),
               words.begin() + static_cast<std::ptrdiff_t>(end));
    at = end;
  }
  return out;
}

std::vector<std::uint32_t> unpacked(std::span<const std::uint32_t> words) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < words.size();) {
    const bool run = (words[at] & kRun) != 0;
    const std::size_t length = words[at] & ~kRun;
    at += 1 + (run ? 1 : length);
    count += length;
    if (length == 0 || at > words.size() || count > kMostWords) return {};
  }
  std::vector<std::uint32_t> out;
  out.reserve(count);
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t length = words[at] & ~kRun;
    if ((words[at] & kRun) != 0) {
      out.insert(out.end(), length, words[at + 1]);
      at += 2;
    } else {
      const auto first = words.begin() + static_cast<std::ptrdiff_t>(at) + 1;
      out.insert(out.end(), first, first + static_cast<std::ptrdiff_t>(length));
      at += 1 + length;
    }
  }
  return out;
}

std::vector<std::uint32_t> kept_words(const std::string& key, const std::function<std::vector<std::uint32_t>()>& make) {
  const std::filesystem::path folder = chosen_folder();
  const std::string program = folder.empty() ? std::string() : program_build();
  if (program.empty()) return make();
  const KeptFiles files(folder / kFolder, kEnding);
  const std::string text = program + '\n' + key;
  const Digest digest = sha256(std::as_bytes(std::span(text)));
  std::vector<std::uint32_t> words = unpacked(files.find(digest));
  if (words.empty()) words = built_words(digest);
  if (words.empty()) {
    words = make();
    files.keep(digest, packed(words));
    files.trim();
  }
  return words;
}

std::vector<float> kept_floats(const std::string& key, const std::function<std::vector<float>()>& make) {
  const std::vector<std::uint32_t> words = kept_words(key, [&make] {
    const std::vector<float> values = make();
    std::vector<std::uint32_t> bits(values.size());
    std::memcpy(bits.data(), values.data(), values.size() * sizeof(float));
    return bits;
  });
  std::vector<float> values(words.size());
  std::memcpy(values.data(), words.data(), words.size() * sizeof(float));
  return values;
}

}  // namespace airlight
