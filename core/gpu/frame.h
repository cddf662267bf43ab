#pragma once
// Objects of one run in flight: command buffer, fence, descriptor sets, timestamp queries. The next run uses all of
// them again.

#include <cstdint>
#include <functional>
#include <vector>

#include "core/gpu/device.h"
#include "core/gpu/handle.h"

namespace airlight {

// Number of descriptors of each kind over all passes of a run.
struct DescriptorCounts {
  std::uint32_t sets = 0;
  std::uint32_t uniform_blocks = 0;
  std::uint32_t sampled_images = 0;
  std::uint32_t storage_images = 0;
  std::uint32_t storage_buffers = 0;

  bool fits_in(const DescriptorCounts& other) const;
};

class Frame {
 public:
  explicit Frame(const Device& device);

  // Opens the command buffer and drops what earlier runs recorded and allocated.
  VkCommandBuffer begin(const DescriptorCounts& descriptors, std::uint32_t timestamps);
  // Closes the command buffer, submits it and waits for its end, calling `tick` some times a second. Throws RunError
  // when the device fails.
  void submit_and_wait(const std::function<void()>& tick = {});
  // Opens the command buffer once more, for the rest of the same run.
  VkCommandBuffer begin_rest();

  VkDescriptorSet descriptor_set(VkDescriptorSetLayout layout);
  VkQueryPool timestamps() const { return timestamps_.get(); }
  // Ticks of the first `count` timestamps of the run.
  std::vector<std::uint64_t> read_timestamps(std::uint32_t count) const;

 private:
  void reserve_descriptors(const DescriptorCounts& wanted);
  void reserve_timestamps(std::uint32_t wanted);

  const Device& device_;
  CommandPoolHandle command_pool_;
  VkCommandBuffer commands_ = nullptr;  // the pool's
  FenceHandle fence_;
  DescriptorPoolHandle descriptor_pool_;
  DescriptorCounts descriptor_room_;
  QueryPoolHandle timestamps_;
  std::uint32_t timestamp_room_ = 0;
};

}  // namespace airlight
