#include "core/gpu/ready_modules.h"

namespace airlight {

std::span<const ReadyModule> ready_modules() {
  return {};
}

}  // namespace airlight
