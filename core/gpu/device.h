#pragma once
// One logical device with its compute queue, limits and memory.

#include <cstdint>
#include <string_view>

#include "core/gpu/executor.h"
#include "core/gpu/handle.h"
#include "core/gpu/instance.h"

namespace airlight {

// A kind of memory. `shared` is fast for both device and host and exists on devices for which Device::is_unified.
enum class MemoryPlace { device, shared, upload, readback };

struct DeviceLimits {
  std::uint64_t allocation_bytes = 0;
  std::uint64_t storage_buffer_bytes = 0;
  std::uint64_t uniform_block_bytes = 0;
  std::uint32_t push_constant_bytes = 0;
  std::uint32_t image_side_2d = 0;
  std::uint32_t image_side_3d = 0;
  std::uint32_t workgroups[3] = {};
  std::uint32_t workgroup_invocations = 0;
  double timestamp_nanoseconds = 1.0;  // one tick
  std::uint64_t timestamp_mask = 0;    // valid bits
};

class Device {
 public:
  explicit Device(const Instance& instance, std::string_view name_substring);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkDevice get() const { return device_; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return queue_family_; }
  // Whether images of 16 bits a channel are stored in 16 bits.
  bool keeps_halves() const { return halves_; }
  void keep_halves(bool keeps) { halves_ = keeps; }
  // Whether shaders write and samplers filter images of one and of two components, in 16 bits or in 32.
  bool keeps_few_components(bool half) const { return half ? few_halves_ : few_floats_; }
  const DeviceInfo& info() const { return info_; }
  const DeviceLimits& limits() const { return limits_; }
  bool is_unified() const { return is_unified_; }

  // Throws RunError when no single allocation can be that large.
  void check_size(std::uint64_t bytes, std::string_view what) const;
  // Memory for `what` ("image radiance, 1920x1080 rgba32f"). Throws RunError with what was asked for.
  MemoryHandle allocate(const VkMemoryRequirements& needs, MemoryPlace place, std::string_view what) const;

 private:
  void read_limits(VkPhysicalDevice physical);
  std::uint32_t memory_type(std::uint32_t allowed, MemoryPlace place) const;

  VkDevice device_ = nullptr;
  VkQueue queue_ = nullptr;
  std::uint32_t queue_family_ = 0;
  bool halves_ = true;
  bool few_halves_ = false;
  bool few_floats_ = false;
  DeviceInfo info_;
  DeviceLimits limits_;
  VkPhysicalDeviceMemoryProperties memory_{};
  bool is_unified_ = false;
};

// "530.8 MiB".
std::string describe_bytes(std::uint64_t bytes);

}  // namespace airlight
