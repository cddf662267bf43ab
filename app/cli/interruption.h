#pragma once
// Ctrl-C and similar signals for a long run: the first asks it to stop in good order, the second ends it.

#include <csignal>

namespace airlight::cli {

// While it exists, the first SIGINT, SIGTERM or SIGHUP is only noted, and the next has its previous effect. One object
// at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // The signal's number; 0: none came. May be called from any thread.
  static int signal();
};

}  // namespace airlight::cli
