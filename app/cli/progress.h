#pragma once
// A line on the terminal that tells how far a long render is and how long it will still take.

#include <functional>
#include <memory>
#include <string>

namespace airlight::cli {

// To be called with what is done, 0 to 1; always lets the work go on. Empty unless standard error is a terminal.
std::function<bool(double done)> terminal_progress();

// Removes the line that terminal_progress() has drawn.
void clear_progress();

// A line on the terminal that tells what is being done and for how long, for work whose end nobody knows. Where
// standard error is no terminal it shows nothing.
class TerminalStatus {
 public:
  TerminalStatus();
  ~TerminalStatus();  // takes the line away
  TerminalStatus(const TerminalStatus&) = delete;
  TerminalStatus& operator=(const TerminalStatus&) = delete;

  void say(const std::string& what);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace airlight::cli
