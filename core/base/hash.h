#pragma once
// FNV-1a: for telling texts apart, not for keeping secrets.

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace airlight {

// 64 bits as 16 hexadecimal digits.
inline std::string hash_text(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  }
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

}  // namespace airlight
