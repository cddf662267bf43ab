#pragma once
// Images and buffers between runs: kept ones by their key, the others for the next run that wants the same shape.

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/gpu/device.h"
#include "core/gpu/executor.h"
#include "core/gpu/image.h"
#include "core/plan/plan.h"

namespace airlight {

// A buffer with its memory, mapped for its whole life where the host can reach it.
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

struct Resource {
  std::string shape;  // what another resource must have in common to take its place
  std::string key;    // empty: not kept
  std::optional<Image> image;
  std::optional<Buffer> buffer;
  std::uint64_t last_run = 0;
  bool has_layout = false;    // images: the general one, since its first run
  bool has_contents = false;  // kept: what the key promises is there

  std::size_t bytes() const { return image ? image->bytes() : buffer->bytes(); }
};

class ResourceCache {
 public:
  // Kept resources beyond kept_limit bytes go, the least recently used first, but never one of the current run.
  ResourceCache(const Device& device, std::size_t kept_limit) : device_(device), kept_limit_(kept_limit) {}

  // Opens a run: what it asks for from now on stays for its whole length.
  void begin_run() { ++run_; }
  // Closes it: what the last few runs had no use for is given back.
  void end_run();

  Resource& image(const ImageDesc& desc);
  Resource& buffer(const BufferDesc& desc, MemoryPlace place);

  // Whether a kept resource is there with its contents; if so it stays for the run.
  bool holds(const ImageDesc& desc);
  bool holds(const BufferDesc& desc, MemoryPlace place);

  MemoryUse memory_use() const;

 private:
  Resource* find(const std::string& shape, const std::string& key);
  Resource& add(Resource resource);
  void make_room(std::size_t bytes);
  std::size_t kept_bytes() const;

  const Device& device_;
  std::size_t kept_limit_;
  std::uint64_t run_ = 0;
  std::list<Resource> resources_;
};

}  // namespace airlight
