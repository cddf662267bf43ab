#include "core/gpu/device.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

#include "core/base/error.h"
#include "core/gpu/physical_device.h"

namespace airlight {
namespace {

bool stores_and_filters(VkPhysicalDevice device, VkFormat format) {
  constexpr VkFormatFeatureFlags kNeeds =
      VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  VkFormatProperties properties{};
  vkGetPhysicalDeviceFormatProperties(device, format, &properties);
  return (properties.optimalTilingFeatures & kNeeds) == kNeeds;
}

constexpr VkMemoryPropertyFlags kHost = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags kHostCached = kHost | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
constexpr VkMemoryPropertyFlags kDevice = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;

// Memory flags in order of preference; the last always exist (except for `shared`).
std::initializer_list<VkMemoryPropertyFlags> wanted_flags(MemoryPlace place) {
  static constexpr auto kDeviceOnly = {kDevice, VkMemoryPropertyFlags{0}};
  static constexpr auto kShared = {kDevice | kHostCached};
  static constexpr auto kUpload = {kDevice | kHost, kHost};
  static constexpr auto kReadback = {kHostCached, kHost};
  switch (place) {
    case MemoryPlace::device:
      return kDeviceOnly;
    case MemoryPlace::shared:
      return kShared;
    case MemoryPlace::upload:
      return kUpload;
    case MemoryPlace::readback:
      return kReadback;
  }
  return kDeviceOnly;
}

bool files_are_limited() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

// Whether the last byte can be read: the kernel is asked, because reading it would end the process by SIGBUS.
bool is_there(VkDevice device, VkDeviceMemory memory, std::uint64_t bytes) {
  void* start = nullptr;
  check(vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, &start), "map memory");
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const std::uintptr_t last = (reinterpret_cast<std::uintptr_t>(start) + bytes - 1) / page * page;
  const bool fails = ::madvise(reinterpret_cast<void*>(last), page, MADV_POPULATE_READ) != 0 && errno == EFAULT;
  vkUnmapMemory(device, memory);
  return !fails;
}

}  // namespace

Device::Device(const Instance& instance, std::string_view name_substring) {
  const std::vector<PhysicalDevice> devices = physical_devices(instance);
  const PhysicalDevice& physical = choose(devices, name_substring);
  info_ = physical.info;
  queue_family_ = physical.queue_family;

  constexpr float kPriority = 1.0F;
  const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                      .queueFamilyIndex = queue_family_,
                                      .queueCount = 1,
                                      .pQueuePriorities = &kPriority};
  VkPhysicalDeviceVulkan12Features features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  features.scalarBlockLayout = VK_TRUE;
  VkPhysicalDeviceFeatures plain{};
  plain.shaderStorageImageWriteWithoutFormat = VK_TRUE;  // images of halves, which some devices keep as floats
  const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                .pNext = &features,
                                .queueCreateInfoCount = 1,
                                .pQueueCreateInfos = &queue,
                                .pEnabledFeatures = &plain};
  check(vkCreateDevice(physical.handle, &info, nullptr, &device_), "open the device " + info_.name);
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
  read_limits(physical.handle);
}

Device::~Device() {
  vkDestroyDevice(device_, nullptr);
}

void Device::read_limits(VkPhysicalDevice physical) {
  VkPhysicalDeviceMaintenance3Properties maintenance{};
  maintenance.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  properties.pNext = &maintenance;
  vkGetPhysicalDeviceProperties2(physical, &properties);
  const VkPhysicalDeviceLimits& limits = properties.properties.limits;
  limits_.allocation_bytes = maintenance.maxMemoryAllocationSize;
  limits_.storage_buffer_bytes = limits.maxStorageBufferRange;
  limits_.uniform_block_bytes = limits.maxUniformBufferRange;
  limits_.push_constant_bytes = limits.maxPushConstantsSize;
  limits_.image_side_2d = limits.maxImageDimension2D;
  limits_.image_side_3d = limits.maxImageDimension3D;
  std::copy_n(limits.maxComputeWorkGroupCount, 3, limits_.workgroups);
  limits_.workgroup_invocations = limits.maxComputeWorkGroupInvocations;
  limits_.timestamp_nanoseconds = static_cast<double>(limits.timestampPeriod);
  few_halves_ =
      stores_and_filters(physical, VK_FORMAT_R16_SFLOAT) && stores_and_filters(physical, VK_FORMAT_R16G16_SFLOAT);
  few_floats_ =
      stores_and_filters(physical, VK_FORMAT_R32_SFLOAT) && stores_and_filters(physical, VK_FORMAT_R32G32_SFLOAT);

  std::uint32_t count = queue_family_ + 1;
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  const std::uint32_t bits = families[queue_family_].timestampValidBits;
  limits_.timestamp_mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;

  vkGetPhysicalDeviceMemoryProperties(physical, &memory_);
  constexpr VkMemoryPropertyFlags kShared = kDevice | kHostCached;
  is_unified_ = std::any_of(memory_.memoryTypes, memory_.memoryTypes + memory_.memoryTypeCount,
                            [](const VkMemoryType& type) { return (type.propertyFlags & kShared) == kShared; });
}

std::uint32_t Device::memory_type(std::uint32_t allowed, MemoryPlace place) const {
  for (const VkMemoryPropertyFlags wanted : wanted_flags(place)) {
    for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
      const bool is_allowed = ((allowed >> i) & 1U) != 0;
      if (is_allowed && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    }
  }
  throw RunError("the device " + info_.name + " has no memory that the host can reach");
}

void Device::check_size(std::uint64_t bytes, std::string_view what) const {
  if (bytes <= limits_.allocation_bytes) return;
  throw RunError("cannot allocate " + describe_bytes(bytes) + " for " + std::string(what) + ": the device " +
                 info_.name + " takes at most " + describe_bytes(limits_.allocation_bytes) + " at once");
}

MemoryHandle Device::allocate(const VkMemoryRequirements& needs, MemoryPlace place, std::string_view what) const {
  check_size(needs.size, what);
  const std::string asked = describe_bytes(needs.size) + " for " + std::string(what);
  const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                  .allocationSize = needs.size,
                                  .memoryTypeIndex = memory_type(needs.memoryTypeBits, place)};
  VkDeviceMemory memory = nullptr;
  const VkResult result = vkAllocateMemory(device_, &info, nullptr, &memory);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) {
    throw RunError("the device " + info_.name + " is out of memory: asked for " + asked);
  }
  check(result, "allocate " + asked);
  MemoryHandle handle(device_, memory);
  // Mesa's software device may keep its memory in a file, and gives out what a limit on files denies it.
  if (info_.is_cpu && files_are_limited() && !is_there(device_, memory, needs.size)) {
    throw RunError("the device " + info_.name + " keeps its memory in a file and cannot have " + asked +
                   "; raise the limit on the size of files (ulimit -f)");
  }
  return handle;
}

std::string describe_bytes(std::uint64_t bytes) {
  constexpr std::array kUnits = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  double value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 1024.0 && unit + 1 < kUnits.size(); ++unit) value /= 1024.0;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), unit == 0 ? "%.0f %s" : "%.1f %s", value, kUnits[unit]);
  return text.data();
}

}  // namespace airlight
