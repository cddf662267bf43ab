#pragma once
// A line on the terminal that tells how far a long render is and how long it will still take.

#include <functional>

namespace airlight::cli {

// To be called with what is done, 0 to 1; always lets the work go on. Empty unless standard error is a terminal.
std::function<bool(double done)> terminal_progress();

// Removes the line that terminal_progress() has drawn.
void clear_progress();

}  // namespace airlight::cli
