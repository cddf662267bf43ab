#pragma once
// SHA-256 (FIPS 180-4) by nettle, for the names and checks of kept files.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace airlight {

using Digest = std::array<std::uint8_t, 32>;

Digest sha256(std::span<const std::byte> bytes);

std::string hexadecimal(const Digest& digest);  // 64 lower-case digits

}  // namespace airlight
