#pragma once
// What happens to files when a signal ends the process.

#include <sys/types.h>

#include <deque>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/output/temporary.h"

namespace airlight {

// From now on SIGINT, SIGTERM and SIGHUP kill the program of FilesOfAnother, remove the temporary files, report what is
// whole (core/output/last_words.h) and end the process as they otherwise would. A file beyond the size limit then fails
// to be written, as on a full disk, instead of ending the process by SIGXFSZ.
void end_in_good_order_on_signals();

// Temporary files that another program, started by this process, writes. The destructor removes those that were not
// renamed. A signal that ends this process first kills the program, then removes them. One object at a time.
class FilesOfAnother {
 public:
  explicit FilesOfAnother(const std::vector<std::filesystem::path>& files);
  FilesOfAnother(const FilesOfAnother&) = delete;
  FilesOfAnother& operator=(const FilesOfAnother&) = delete;
  ~FilesOfAnother();

  // Calls `start`, which returns the program's process number, or 0 for none. Signals wait until it is known, in
  // whichever thread they arrive.
  pid_t started_by(const std::function<pid_t()>& start);
  // To be called when the program has ended, but before it is waited for.
  void ended() noexcept;
  // False where the file does not exist or cannot be renamed.
  bool rename(std::size_t index, const std::filesystem::path& target);

 private:
  std::deque<Temporary> files_;
};

}  // namespace airlight
