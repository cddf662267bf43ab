#include "core/gpu/buffer.h"

namespace airlight {

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

}  // namespace airlight
