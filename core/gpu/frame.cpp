#include "core/gpu/frame.h"

#include <algorithm>
#include <exception>
#include <limits>

namespace airlight {

bool DescriptorCounts::fits_in(const DescriptorCounts& other) const {
  return sets <= other.sets && uniform_blocks <= other.uniform_blocks && sampled_images <= other.sampled_images &&
         storage_images <= other.storage_images && storage_buffers <= other.storage_buffers;
}

Frame::Frame(const Device& device) : device_(device) {
  const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                          .queueFamilyIndex = device.queue_family()};
  command_pool_ = CommandPoolHandle::make(device.get(), vkCreateCommandPool, pool_info, "make a command pool");

  const VkCommandBufferAllocateInfo commands_info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                  .commandPool = command_pool_.get(),
                                                  .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                  .commandBufferCount = 1};
  check(vkAllocateCommandBuffers(device.get(), &commands_info, &commands_), "make a command buffer");

  const VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  fence_ = FenceHandle::make(device.get(), vkCreateFence, fence_info, "make a fence");
}

VkCommandBuffer Frame::begin(const DescriptorCounts& descriptors, std::uint32_t timestamps) {
  reserve_descriptors(descriptors);
  reserve_timestamps(timestamps);
  return begin_rest();
}

VkCommandBuffer Frame::begin_rest() {
  check(vkResetCommandPool(device_.get(), command_pool_.get(), 0), "reset the command pool");
  const VkCommandBufferBeginInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                      .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  check(vkBeginCommandBuffer(commands_, &info), "begin recording");
  return commands_;
}

void Frame::reserve_descriptors(const DescriptorCounts& wanted) {
  if (wanted.fits_in(descriptor_room_)) {
    if (descriptor_pool_) check(vkResetDescriptorPool(device_.get(), descriptor_pool_.get(), 0), "reset descriptors");
    return;
  }
  DescriptorCounts& room = descriptor_room_;
  room.sets = std::max(room.sets, wanted.sets);
  room.uniform_blocks = std::max(room.uniform_blocks, wanted.uniform_blocks);
  room.sampled_images = std::max(room.sampled_images, wanted.sampled_images);
  room.storage_images = std::max(room.storage_images, wanted.storage_images);
  room.storage_buffers = std::max(room.storage_buffers, wanted.storage_buffers);

  std::vector<VkDescriptorPoolSize> sizes;
  const auto add = [&](VkDescriptorType type, std::uint32_t count) {
    if (count > 0) sizes.push_back({type, count});
  };
  add(VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, room.uniform_blocks);
  add(VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, room.sampled_images);
  add(VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, room.storage_images);
  add(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, room.storage_buffers);
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = room.sets,
                                        .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
                                        .pPoolSizes = sizes.data()};
  descriptor_pool_ = DescriptorPoolHandle::make(device_.get(), vkCreateDescriptorPool, info, "make a descriptor pool");
}

void Frame::reserve_timestamps(std::uint32_t wanted) {
  if (wanted <= timestamp_room_) return;
  const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                   .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                   .queryCount = wanted,
                                   .pipelineStatistics = 0};
  timestamps_ = QueryPoolHandle::make(device_.get(), vkCreateQueryPool, info, "make timestamp queries");
  timestamp_room_ = wanted;
}

void Frame::submit_and_wait(const std::function<void()>& tick) {
  constexpr std::uint64_t kTick = 100'000'000;  // ns
  check(vkEndCommandBuffer(commands_), "end recording");
  const VkSubmitInfo info{
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands_};
  const VkFence fence = fence_.get();
  const std::string doing = "run the passes on " + device_.info().name;
  check(vkResetFences(device_.get(), 1, &fence), doing);
  check(vkQueueSubmit(device_.queue(), 1, &info, fence), doing);
  VkResult waited = VK_TIMEOUT;
  std::exception_ptr thrown;  // by tick(); passed on once the device no longer uses what the caller holds
  while (waited == VK_TIMEOUT) {
    const bool ticks = tick && !thrown;
    waited =
        vkWaitForFences(device_.get(), 1, &fence, VK_TRUE, ticks ? kTick : std::numeric_limits<std::uint64_t>::max());
    try {
      if (ticks) tick();
    } catch (...) {
      thrown = std::current_exception();
    }
  }
  check(waited, doing);
  if (thrown) std::rethrow_exception(thrown);
}

VkDescriptorSet Frame::descriptor_set(VkDescriptorSetLayout layout) {
  const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                         .descriptorPool = descriptor_pool_.get(),
                                         .descriptorSetCount = 1,
                                         .pSetLayouts = &layout};
  VkDescriptorSet set = nullptr;
  check(vkAllocateDescriptorSets(device_.get(), &info, &set), "allocate descriptors");
  return set;
}

std::vector<std::uint64_t> Frame::read_timestamps(std::uint32_t count) const {
  std::vector<std::uint64_t> ticks(count);
  if (count == 0) return ticks;
  check(vkGetQueryPoolResults(device_.get(), timestamps_.get(), 0, count, count * sizeof(std::uint64_t), ticks.data(),
                              sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "read the timestamps");
  for (std::uint64_t& tick : ticks) tick &= device_.limits().timestamp_mask;
  return ticks;
}

}  // namespace airlight
