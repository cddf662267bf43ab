#include "app/commands/diff_update.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/replace_files.h"

namespace airlight::cli {

namespace fs = std::filesystem;
using measure::NamedReport;
using measure::Verdict;

namespace {

// A link in a folder of references may lead anywhere; the user named the folder, not what lies behind the link.
void require_inside(const std::string& reference, const std::string& references) {
  std::error_code problem;
  const fs::path given(references);
  const fs::path folder = fs::canonical(fs::is_directory(given) ? given : given.parent_path() / ".", problem);
  const fs::path real = fs::canonical(reference, problem);
  if (!problem && std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first != folder.end()) {
    throw InputError("diff: --update: " + reference + " is a link to " + real.string() + ", outside of " +
                     folder.string() +
                     "; nothing was replaced: put a copy in the link's place, or update that file by "
                     "its own name");
  }
}

}  // namespace

ReferenceUpdate::ReferenceUpdate(const measure::FilePairs& pairs, const std::string& references) {
  for (const measure::FilePair& pair : pairs.pairs) {
    if (!pair.problem.empty()) continue;
    std::error_code problem;
    if (!fs::is_regular_file(pair.b, problem)) continue;  // the comparison reports it
    if (pairs.several) require_inside(pair.b, references);
    require_writable(pair.b);
    seen_.push_back({pair.a, fs::file_size(pair.a, problem), fs::last_write_time(pair.a, problem)});
  }
}

std::vector<std::string> ReferenceUpdate::take(const std::vector<NamedReport>& entries) const {
  const auto unknown = std::ranges::count_if(
      entries, [](const NamedReport& entry) { return entry.report.verdict == Verdict::cannot_compare; });
  if (unknown > 0) {
    throw InputError("diff: --update: " + std::to_string(unknown) + " of " + std::to_string(entries.size()) +
                     (entries.size() == 1 ? " pair" : " pairs") +
                     " cannot be compared, so no reference was replaced; copy or remove what has no counterpart, then "
                     "update again");
  }
  std::vector<Replacement> replacements;
  std::vector<std::string> files;
  for (const NamedReport& entry : entries) {
    if (entry.report.verdict != Verdict::differ) continue;
    replacements.push_back({entry.a, entry.b});
    files.push_back(entry.b);
  }
  for (const Seen& seen : seen_) {
    std::error_code problem;
    if (fs::file_size(seen.file, problem) != seen.size || fs::last_write_time(seen.file, problem) != seen.written) {
      throw InputError(seen.file + ": changed while it was compared, so no reference was replaced; run again");
    }
  }
  replace_files(replacements);
  return files;
}

}  // namespace airlight::cli
