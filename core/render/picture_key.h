#pragma once

#include <string>

namespace airlight {

// A key that no other picture of this process has. Several plans of one picture share resources under it.
std::string picture_key();

}  // namespace airlight
