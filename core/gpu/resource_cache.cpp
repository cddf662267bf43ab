#include "core/gpu/resource_cache.h"

#include <utility>

#include "core/base/huge_pages.h"

namespace airlight {
namespace {

// The tool alternates a few plans (picture, bloom, tone curve) frame by frame: resources outlive one round of them.
constexpr std::uint64_t kIdleRuns = 4;

constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                      VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                      VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;

// Rounds up to whole words, since vkCmdFillBuffer leaves an incomplete word at the end untouched.
std::size_t whole_words(std::size_t bytes) {
  return (bytes + 3) / 4 * 4;
}

std::string shape_of(const BufferDesc& desc, MemoryPlace place) {
  return std::to_string(desc.bytes) + " bytes at " + std::to_string(static_cast<int>(place));
}

}  // namespace

Buffer::Buffer(const Device& device, std::size_t bytes, VkBufferUsageFlags usage, MemoryPlace place,
               std::string_view what)
    : bytes_(bytes) {
  device.check_size(bytes, what);
  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                .size = bytes,
                                .usage = usage,
                                .sharingMode = VK_SHARING_MODE_EXCLUSIVE};
  buffer_ = BufferHandle::make(device.get(), vkCreateBuffer, info, "make " + std::string(what));

  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device.get(), buffer_.get(), &needs);
  memory_ = device.allocate(needs, place, what);
  check(vkBindBufferMemory(device.get(), buffer_.get(), memory_.get(), 0), "place " + std::string(what));
  if (place == MemoryPlace::device) return;

  void* address = nullptr;
  check(vkMapMemory(device.get(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &address), "map " + std::string(what));
  mapped_ = {static_cast<std::byte*>(address), bytes};
}

void ResourceCache::end_run() {
  std::erase_if(resources_, [&](const Resource& r) { return r.key.empty() && r.last_run + kIdleRuns <= run_; });
}

void ResourceCache::free_pictures(bool but_results) {
  std::erase_if(resources_, [but_results](const Resource& r) {
    const bool is_result = r.carried || r.host_readable;
    return (r.key.empty() || r.carried) && !(but_results && is_result);
  });
}

Resource* ResourceCache::find(const std::string& shape, const std::string& key) {
  for (Resource& resource : resources_) {
    const bool is_free = !key.empty() || resource.last_run != run_;
    if (is_free && resource.shape == shape && resource.key == key) {
      resource.last_run = run_;
      return &resource;
    }
  }
  return nullptr;
}

Resource& ResourceCache::add(Resource resource) {
  resource.last_run = run_;
  resources_.push_back(std::move(resource));
  return resources_.back();
}

Resource& ResourceCache::image(const ImageDesc& desc) {
  if (Resource* found = find(describe_shape(desc), desc.key)) return *found;
  if (!desc.key.empty()) make_room(desc.bytes());
  Resource resource;
  resource.shape = describe_shape(desc);
  resource.key = desc.key;
  resource.image.emplace(device_, desc);
  return add(std::move(resource));
}

Resource& ResourceCache::buffer(const BufferDesc& desc, MemoryPlace place) {
  Resource* found = find(shape_of(desc, place), desc.key);
  if (found == nullptr) {
    if (!desc.key.empty()) make_room(desc.bytes);
    Resource resource;
    resource.shape = shape_of(desc, place);
    resource.key = desc.key;
    const Buffer& buffer =
        resource.buffer.emplace(device_, whole_words(desc.bytes), kUsage, place, "buffer " + desc.name);
    // The software device's memory is the process's own.
    prefer_huge_pages(buffer.mapped().data(), buffer.mapped().size());
    found = &add(std::move(resource));
  }
  found->carried = desc.carried;
  found->host_readable = desc.host_readable || place == MemoryPlace::readback;
  return *found;
}

bool ResourceCache::holds(const ImageDesc& desc) {
  const Resource* found = find(describe_shape(desc), desc.key);
  return found != nullptr && found->has_contents;
}

bool ResourceCache::holds(const BufferDesc& desc, MemoryPlace place) {
  const Resource* found = find(shape_of(desc, place), desc.key);
  return found != nullptr && found->has_contents;
}

void ResourceCache::make_room(std::size_t bytes) {
  while (kept_bytes() + bytes > kept_limit_) {
    auto oldest = resources_.end();
    for (auto it = resources_.begin(); it != resources_.end(); ++it) {
      const bool may_go = !it->key.empty() && it->last_run != run_;
      if (may_go && (oldest == resources_.end() || it->last_run < oldest->last_run)) oldest = it;
    }
    if (oldest == resources_.end()) return;
    resources_.erase(oldest);
  }
}

std::size_t ResourceCache::kept_bytes() const {
  return memory_use().kept_bytes;
}

MemoryUse ResourceCache::memory_use() const {
  MemoryUse use;
  for (const Resource& resource : resources_) {
    ++use.resources;
    use.bytes += resource.bytes();
    if (!resource.key.empty()) use.kept_bytes += resource.bytes();
  }
  return use;
}

}  // namespace airlight
