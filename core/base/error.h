#pragma once
// The two kinds of failure that come from outside. The message names place and remedy; app/main.cpp alone catches them.

#include <stdexcept>
#include <string>

namespace airlight {

// A preset, an option or a file given by the user is wrong: exit code 2.
struct InputError : std::runtime_error {
  // One problem. A line break in the message is part of a name and is shown as \n.
  using std::runtime_error::runtime_error;
  // Several problems, a line each.
  static InputError of_lines(const std::string& lines) {
    InputError error(lines);
    error.has_lines = true;
    return error;
  }
  bool has_lines = false;
};

// Something that worked on paper failed while running (device, memory, disk): exit code 1.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace airlight
