#pragma once
// Whether a method's claim covers a scene.

#include <string>
#include <vector>

#include "core/methods/method.h"

namespace airlight {

// "a sun below -2 degrees (it is at -4)": each limit that the scene exceeds; empty where the claim holds.
std::vector<std::string> exceeded_limits(const Validity& validity, const Stage& stage);

// One line for the user when the scene's method does not claim to hold for it: why, what the method leaves out, which
// methods do hold. Empty where it does.
std::string validity_warning(const Stage& stage);

// One line where the scene lies in a region in which its method, at its quality, is known to fail: the causes, and
// which methods hold. Otherwise empty.
std::string known_failure_warning(const Stage& stage);

// The scene's wishes that its method does not fulfil because that would not end, a line each.
std::vector<std::string> bound_warnings(const Stage& stage);

// These warnings, as each command that renders prints them. A known failure is not mentioned where the picture's own
// error is measured.
std::vector<std::string> scene_warnings(const Stage& stage, bool error_is_measured = false);

}  // namespace airlight
