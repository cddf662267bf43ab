#pragma once
// Frozen modules that the build made for the shipped presets, so that their first start needs no optimiser.

#include <cstdint>
#include <span>

#include "core/gpu/sha256.h"

namespace airlight {

struct ReadyModule {
  Digest key;  // see module_key()
  std::span<const std::uint32_t> spirv;
};

std::span<const ReadyModule> ready_modules();

}  // namespace airlight
