#include "app/commands/commands.h"

namespace airlight::cli {

std::string library_versions() {
  return AIRLIGHT_LIBRARIES;  // set by app/app.cmake from what CMake found
}

}  // namespace airlight::cli
