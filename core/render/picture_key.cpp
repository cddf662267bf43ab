#include "core/render/picture_key.h"

#include <atomic>
#include <cstdint>

namespace airlight {

std::string picture_key() {
  static std::atomic<std::uint64_t> pictures = 0;
  return "picture " + std::to_string(++pictures);
}

}  // namespace airlight
