#pragma once
// Large pages for large memory.

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>

namespace airlight {

// Asks for pages of 2 MiB where the range, not touched before, spans them: the first touch of a picture then takes one
// fault in place of 512. A hint: where the system has no such pages, nothing changes.
inline void prefer_huge_pages(const void* memory, std::size_t bytes) noexcept {
  constexpr std::uintptr_t kHuge = std::uintptr_t{2} << 20;
  const auto start = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (start + kHuge - 1) / kHuge * kHuge;
  const std::uintptr_t last = (start + bytes) / kHuge * kHuge;
  if (last > first) {
    (void)::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  }
}

}  // namespace airlight
