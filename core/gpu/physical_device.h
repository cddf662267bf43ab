#pragma once
// The machine's devices, and the features that airlight needs and they lack.

#include <cstdint>
#include <vector>

#include "core/gpu/executor.h"
#include "core/gpu/instance.h"
#include "core/gpu/vulkan_api.h"

namespace airlight {

inline constexpr const char* kNoVulkanDevice =
    "no Vulkan device on this machine; install a driver, for the software device the package mesa-vulkan-drivers";

struct PhysicalDevice {
  VkPhysicalDevice handle = nullptr;
  DeviceInfo info;
  std::uint32_t queue_family = 0;  // the first that computes; if any also writes timestamps, the first of these
};

// In the loader's order. Throws RunError naming the package of a driver when there is none.
std::vector<PhysicalDevice> physical_devices(const Instance& instance);

// The device that DeviceOptions::name_substring asks for. Throws RunError: none of that name, or it lacks features.
const PhysicalDevice& choose(const std::vector<PhysicalDevice>& devices, std::string_view name_substring);

}  // namespace airlight
