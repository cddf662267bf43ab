#pragma once
// A line on the terminal with the progress of a long render and its remaining time.

#include <functional>
#include <memory>
#include <string>

namespace airlight::cli {

// A function to call with the share done, 0 to 1; it never stops the work. Empty unless standard error is a terminal.
std::function<bool(double done)> terminal_progress();

// Removes the line that terminal_progress() has drawn.
void clear_progress();

// A line on the terminal with the current activity and its duration, for work of unknown length. It shows nothing where
// standard error is no terminal.
class TerminalStatus {
 public:
  TerminalStatus();
  ~TerminalStatus();  // removes the line
  TerminalStatus(const TerminalStatus&) = delete;
  TerminalStatus& operator=(const TerminalStatus&) = delete;

  void say(const std::string& what);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace airlight::cli
