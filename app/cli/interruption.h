#pragma once
// Ctrl-C and its like for a long run that wants to stop in good order: the first asks it to, the second ends it.

#include <csignal>

namespace airlight::cli {

// From its making on, the first SIGINT, SIGTERM or SIGHUP is noted, and the next does what it did before. One at a
// time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // The signal's number; 0: none came. Any thread may ask.
  static int signal();
};

}  // namespace airlight::cli
