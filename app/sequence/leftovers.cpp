#include "app/sequence/leftovers.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/frame_state.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

// Frame numbers rise with the index.
bool has_frame(const sequence::FrameSource& source, long number) {
  const std::size_t count = sequence::frame_count(source);
  std::size_t first = 0;
  for (std::size_t end = count; first < end;) {
    const std::size_t middle = first + (end - first) / 2;
    if (sequence::frame_number(source, middle) < number) {
      first = middle + 1;
    } else {
      end = middle;
    }
  }
  return first < count && sequence::frame_number(source, first) == number;
}

void add_frames_beyond(std::vector<std::string>& files, const sequence::FramePattern& pattern,
                       const sequence::FrameSource& source) {
  std::error_code error;
  for (fs::directory_iterator entry(pattern.folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const std::optional<long> number = measure::frame_number(pattern, name);
    std::error_code ignored;
    if (!number || has_frame(source, *number) || entry->is_symlink(ignored)) {
      continue;
    }
    // Only `airlight sequence` writes the hash.
    const std::optional<FrameMark> mark = read_frame_mark(entry->path());
    if (mark && !mark->hash.empty()) {
      files.push_back(pattern.folder == "." ? name : entry->path().string());
    }
  }
}

}  // namespace

std::vector<std::string> frames_beyond(const SequenceJob& job) {
  std::vector<std::string> files;
  for (const auto& pattern : {job.exr, job.png}) {
    if (pattern) {
      add_frames_beyond(files, *pattern, job.source);
    }
  }
  std::ranges::sort(files);
  return files;
}

void tidy_frames_beyond(const SequenceJob& job) {
  const std::vector<std::string> files = frames_beyond(job);
  if (files.empty()) {
    return;
  }
  const std::string which = files.size() == 1 ? files.front() : files.front() + " to " + files.back();
  const std::string count = std::to_string(files.size()) + (files.size() == 1 ? " older frame" : " older frames");
  if (!job.clean) {
    if (!job.quiet) {
      complain("warning: " + count + " that this sequence does not have stay beside it (" + which +
               "); --clean removes them");
    }
    return;
  }
  for (const std::string& file : files) {
    if (::unlink(file.c_str()) != 0 && errno != ENOENT) {
      throw RunError(file + ": cannot be removed: " + std::strerror(errno) + "; the sequence itself is whole");
    }
  }
  tell(job.quiet ? "" : "removed " + count + ": " + which + "\n");
}

void remove_half_written(const SequenceJob& job) {
  for (const auto& pattern : {job.exr, job.png}) {
    if (pattern) {
      remove_abandoned_files(
          pattern->folder, [&](const std::string& name) { return measure::frame_number(*pattern, name).has_value(); });
    }
  }
  remove_abandoned_files_of(job.manifest);
}

}  // namespace airlight::cli
