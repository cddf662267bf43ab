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
  // Empty for a buffer in device memory.
  std::span<std::byte> mapped() const { return mapped_; }

 private:
  std::size_t bytes_ = 0;
  std::span<std::byte> mapped_;
  // The buffer dies before its memory.
  MemoryHandle memory_;
  BufferHandle buffer_;
};

struct Resource {
  std::string shape;  // must be equal for another resource to take its place
  std::string key;    // empty: not kept
  std::optional<Image> image;
  std::optional<Buffer> buffer;
  std::uint64_t last_run = 0;
  bool has_layout = false;    // images: the general one, since its first run
  bool has_contents = false;  // kept ones: the contents that the key promises
  bool carried = false;       // BufferDesc::carried
  bool host_readable = false;

  std::size_t bytes() const { return image ? image->bytes() : buffer->bytes(); }
};

class ResourceCache {
 public:
  // When kept resources exceed kept_limit bytes, the least recently used go first, but never one of the current run.
  ResourceCache(const Device& device, std::size_t kept_limit) : device_(device), kept_limit_(kept_limit) {}

  // Opens a run: resources requested from now on stay until its end.
  void begin_run() { ++run_; }
  // Closes the run and frees resources that the last few runs did not use.
  void end_run();

  Resource& image(const ImageDesc& desc);
  Resource& buffer(const BufferDesc& desc, MemoryPlace place);

  // Frees all but kept tables and, with `but_results`, what the host reads and what is carried to a later run.
  void free_pictures(bool but_results);

  // Whether a kept resource exists with its contents; if so, it stays for the run.
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
