#include "core/measure/frames.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/base/error.h"
#include "core/base/text.h"

namespace airlight::measure {
namespace {

namespace fs = std::filesystem;

// The files of one side, by keys that both sides share.
struct Collection {
  enum class Kind { file, folder, pattern };
  Kind kind = Kind::file;
  std::string given;
  std::map<std::string, std::string> files;  // key -> path
};

const char* kind_words(Collection::Kind kind) {
  switch (kind) {
    case Collection::Kind::folder:
      return "a folder";
    case Collection::Kind::pattern:
      return "a frame pattern";
    case Collection::Kind::file:
      break;
  }
  return "one file";
}

bool is_exr_name(const fs::path& path) {
  return lower(path.extension().string()) == ".exr";
}

InputError unreadable(const std::string& folder, const std::error_code& reason) {
  return InputError(folder + ": cannot be read: " + reason.message());
}

std::map<std::string, std::string> files_in_folder(const std::string& folder) {
  std::map<std::string, std::string> files;
  std::error_code problem;
  for (auto entry = fs::recursive_directory_iterator(folder, problem); entry != fs::recursive_directory_iterator();
       entry.increment(problem)) {
    if (problem) break;
    if (!entry->is_directory() && is_exr_name(entry->path())) {
      files[entry->path().lexically_relative(folder).string()] = entry->path().string();
    }
  }
  if (problem) throw unreadable(folder, problem);
  if (files.empty()) throw InputError(folder + ": holds no .exr file");
  return files;
}

// The frame's number, padded so that keys sort like numbers.
std::string frame_key(long frame) {
  std::string digits = std::to_string(frame);
  return std::string(20 - std::min<std::size_t>(20, digits.size()), '0') + digits;
}

std::map<std::string, std::string> files_of_pattern(const FramePattern& pattern, const std::string& given) {
  std::map<std::string, std::string> files;
  std::error_code problem;
  for (auto entry = fs::directory_iterator(pattern.folder, problem); entry != fs::directory_iterator();
       entry.increment(problem)) {
    if (problem) break;
    const auto frame = frame_number(pattern, entry->path().filename().string());
    if (frame && !entry->is_directory()) files[frame_key(*frame)] = entry->path().lexically_normal().string();
  }
  if (problem) throw unreadable(pattern.folder, problem);
  if (files.empty()) throw InputError(given + ": no frame matches this pattern");
  return files;
}

Collection collect(const std::string& given) {
  Collection collection;
  collection.given = given;
  std::error_code ignored;
  if (fs::is_directory(given, ignored)) {
    collection.kind = Collection::Kind::folder;
    collection.files = files_in_folder(given);
    return collection;
  }
  const auto pattern = fs::exists(given, ignored) ? std::nullopt : frame_pattern(given);
  if (pattern) {
    collection.kind = Collection::Kind::pattern;
    collection.files = files_of_pattern(*pattern, given);
  }
  return collection;
}

void add_standard_errors(const std::vector<Collection>& collections, const std::string& key, FilePair& pair) {
  for (const Collection& collection : collections) {
    if (collection.kind == Collection::Kind::file) {
      pair.standard_errors.push_back(collection.given);
    } else if (const auto found = collection.files.find(key); found != collection.files.end()) {
      pair.standard_errors.push_back(found->second);
    } else if (pair.problem.empty()) {
      pair.problem = pair.name + ": has no standard error in " + collection.given;
    }
  }
}

FilePair pair_of(const Collection& a, const Collection& b, const std::string& key) {
  FilePair pair;
  const auto in_a = a.files.find(key);
  const auto in_b = b.files.find(key);
  if (in_a != a.files.end()) pair.a = in_a->second;
  if (in_b != b.files.end()) pair.b = in_b->second;
  const std::string& known = pair.a.empty() ? pair.b : pair.a;
  pair.name = a.kind == Collection::Kind::folder ? key : fs::path(known).filename().string();
  if (pair.a.empty()) pair.problem = pair.name + ": is in " + b.given + " but not in " + a.given;
  if (pair.b.empty()) pair.problem = pair.name + ": is in " + a.given + " but not in " + b.given;
  return pair;
}

}  // namespace

std::optional<FramePattern> frame_pattern(const std::string& path) {
  const fs::path whole(path);
  const std::string name = whole.filename().string();
  if (whole.parent_path().string().find('#') != std::string::npos) {
    throw InputError(path + ": # stands in a folder's name; a frame pattern has it in the file's name alone");
  }
  const std::size_t first = name.find('#');
  if (first == std::string::npos) return std::nullopt;
  const std::size_t end = std::min(name.find_first_not_of('#', first), name.size());
  if (name.find('#', end) != std::string::npos) {
    throw InputError(path + ": holds # in two places; a frame pattern has one run, as in sky.####.exr");
  }
  return FramePattern{.folder = whole.has_parent_path() ? whole.parent_path().string() : ".",
                      .before = name.substr(0, first),
                      .after = name.substr(end),
                      .digits = static_cast<int>(end - first)};
}

std::optional<long> frame_number(const FramePattern& pattern, std::string_view file_name) {
  const std::size_t around = pattern.before.size() + pattern.after.size();
  if (file_name.size() <= around || !file_name.starts_with(pattern.before) || !file_name.ends_with(pattern.after)) {
    return std::nullopt;
  }
  const std::string_view digits = file_name.substr(pattern.before.size(), file_name.size() - around);
  const bool all_digits = std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
  const std::size_t least = static_cast<std::size_t>(pattern.digits);
  // More digits than the pattern only where the number needs them: each frame has one spelling.
  if (!all_digits || digits.size() < least || (digits.size() > least && digits.front() == '0')) return std::nullopt;
  return number_from<long>(digits);
}

FilePairs pair_files(const std::string& a, const std::string& b, const std::vector<std::string>& standard_errors) {
  const Collection left = collect(a);
  const Collection right = collect(b);
  if (left.kind != right.kind) {
    for (const Collection* side : {&left, &right}) {
      std::error_code ignored;
      if (side->kind == Collection::Kind::file && !fs::exists(side->given, ignored)) {
        throw InputError(side->given + ": does not exist; expected " + kind_words((side == &left ? right : left).kind) +
                         " to compare with");
      }
    }
    throw InputError(a + " is " + kind_words(left.kind) + ", " + b + " is " + kind_words(right.kind) +
                     "; compare two files, two folders or two frame patterns");
  }
  if (left.kind == Collection::Kind::file) {
    for (const std::string& file : standard_errors) {
      if (collect(file).kind != Collection::Kind::file) {
        throw InputError(file + " is " + kind_words(collect(file).kind) + ", but one pair is compared; name one file");
      }
    }
    return {.several = false,
            .pairs = {{.name = b, .a = a, .b = b, .standard_errors = standard_errors, .problem = {}}}};
  }
  std::vector<Collection> sigmas;
  for (const std::string& file : standard_errors) sigmas.push_back(collect(file));
  std::map<std::string, std::string> keys = left.files;
  keys.insert(right.files.begin(), right.files.end());
  FilePairs result{.several = true, .pairs = {}};
  std::size_t matching = 0;
  for (const auto& entry : keys) {
    FilePair pair = pair_of(left, right, entry.first);
    if (pair.problem.empty()) ++matching;
    add_standard_errors(sigmas, entry.first, pair);
    result.pairs.push_back(std::move(pair));
  }
  if (matching == 0) {
    throw InputError("no file of " + a + " (" + std::to_string(left.files.size()) + ") has a counterpart in " + b +
                     " (" + std::to_string(right.files.size()) + ")");
  }
  return result;
}

}  // namespace airlight::measure
