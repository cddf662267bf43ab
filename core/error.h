#pragma once
// The two ways the outside world goes wrong. Thrown with the place and the remedy, caught in app/main.cpp alone.

#include <stdexcept>
#include <string>

namespace airlight {

// A preset, an option or a file given by the user is wrong: exit code 2.
struct InputError : std::runtime_error {
  // One problem: a line break in it stands in a name, and is shown as \n.
  using std::runtime_error::runtime_error;
  // Several, a line each.
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
