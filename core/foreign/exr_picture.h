#pragma once
// EXRs of other programs by OpenEXR, which the program links anyway.

#include <string>

#include "core/foreign/foreign_picture.h"

namespace airlight::foreign {

// As read_picture() of a file that starts as an EXR does. Throws InputError: damaged, channels of fewer samples than
// pixels, too large for the memory.
Picture read_exr_picture(const std::string& file, const Accept& accept);

}  // namespace airlight::foreign
