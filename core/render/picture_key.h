#pragma once

#include <string>

namespace airlight {

// Unlike those of all other pictures of this process: what several plans of one picture share is kept under it.
std::string picture_key();

}  // namespace airlight
