#pragma once
// A buffer with its memory, mapped for its whole life where the host can reach it.

#include <cstddef>
#include <span>
#include <string_view>

#include "core/gpu/device.h"

namespace airlight {

class Buffer {
 public:
  // Throws RunError when the device is out of memory, naming `what`.
  Buffer(const Device& device, std::size_t bytes, VkBufferUsageFlags usage, MemoryPlace place, std::string_view what);

  VkBuffer get() const { return buffer_.get(); }
  std::size_t bytes() const { return bytes_; }
  // Empty in device memory.
  std::span<std::byte> mapped() const { return mapped_; }

 private:
  std::size_t bytes_ = 0;
  std::span<std::byte> mapped_;
  // The buffer dies before its memory.
  MemoryHandle memory_;
  BufferHandle buffer_;
};

}  // namespace airlight
