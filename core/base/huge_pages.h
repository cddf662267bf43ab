#pragma once
// Large pages for large memory.

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

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

// `count` values of zero, in large pages where they span them.
template <class T>
std::vector<T> large_vector(std::size_t count) {
  std::vector<T> values;
  values.reserve(count);
  prefer_huge_pages(values.data(), count * sizeof(T));
  values.resize(count);
  return values;
}

// The main thread's heap in pages of 2 MiB from now on, grown by 64 MiB at a time and kept to the end, since compilers
// of shaders take and return memory by the million. Call it once, early. Does nothing where malloc() is not glibc's.
inline void prefer_huge_heap() noexcept {
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
  constexpr int kGrowth = 64 << 20;
  constexpr std::size_t kBlock = std::size_t{1} << 20;  // from here on blocks have pages of their own
  ::mallopt(M_TOP_PAD, kGrowth);
  ::mallopt(M_TRIM_THRESHOLD, 2 * kGrowth);
  ::mallopt(M_MMAP_THRESHOLD, static_cast<int>(kBlock));
  const void* const before = ::sbrk(0);
  void* volatile block = std::malloc(kBlock - 4096);  // more than a young heap has; not to be optimised away
  std::free(block);
  const auto grown = reinterpret_cast<std::uintptr_t>(::sbrk(0)) - reinterpret_cast<std::uintptr_t>(before);
  if (grown <= 2 * std::size_t{kGrowth}) {
    prefer_huge_pages(before, grown);
  }
#endif
}

// Gives free memory of the heaps back to the system, which malloc() would keep: after large blocks have been freed.
inline void return_free_memory() noexcept {
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
  (void)::malloc_trim(0);
#endif
}

}  // namespace airlight
