#include "core/gpu/sha256.h"

#include <nettle/sha2.h>

namespace airlight {

Digest sha256(std::span<const std::byte> bytes) {
  sha256_ctx state;
  sha256_init(&state);
  sha256_update(&state, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  Digest digest{};
  static_assert(digest.size() == SHA256_DIGEST_SIZE);
  sha256_digest(&state, digest.size(), digest.data());
  return digest;
}

std::string hexadecimal(const Digest& digest) {
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += "0123456789abcdef"[byte >> 4U];
    text += "0123456789abcdef"[byte & 0xFU];
  }
  return text;
}

}  // namespace airlight
