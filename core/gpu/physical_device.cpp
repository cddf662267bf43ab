#include "core/gpu/physical_device.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"

namespace airlight {
namespace {

// The first family that computes and writes timestamps, else the first that computes, else none.
struct QueueChoice {
  bool computes = false;
  bool writes_timestamps = false;
  std::uint32_t family = 0;
};

QueueChoice choose_queue(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  QueueChoice choice;
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0) continue;
    const bool timestamps = families[i].timestampValidBits > 0;
    if (!choice.computes || (timestamps && !choice.writes_timestamps)) choice = {true, timestamps, i};
  }
  return choice;
}

void require_format(VkPhysicalDevice device, VkFormat format, const char* name, std::vector<std::string>& missing) {
  VkFormatProperties properties{};
  vkGetPhysicalDeviceFormatProperties(device, format, &properties);
  const VkFormatFeatureFlags has = properties.optimalTilingFeatures;
  const auto need = [&](VkFormatFeatureFlags flag, const char* what) {
    if ((has & flag) == 0) missing.push_back(std::string(name) + " " + what);
  };
  need(VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT, "storage images");
  need(VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT, "images sampled with linear filtering");
}

// "llvmpipe (LLVM 15), lacks scalarBlockLayout and timestamps on a compute queue".
std::string describe(const DeviceInfo& device) {
  std::string text = device.name;
  for (std::size_t i = 0; i < device.missing.size(); ++i) {
    text += (i == 0 ? ", lacks " : i + 1 == device.missing.size() ? " and " : ", ") + device.missing[i];
  }
  return text;
}

std::string list(const std::vector<PhysicalDevice>& devices) {
  const auto described = [](const PhysicalDevice& device) { return describe(device.info); };
  return joined_of(devices, described, "; ");
}

PhysicalDevice inspect(VkPhysicalDevice handle) {
  PhysicalDevice device{.handle = handle, .info = {}, .queue_family = 0};
  VkPhysicalDeviceDriverProperties driver{};
  driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
  VkPhysicalDeviceProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  vkGetPhysicalDeviceProperties(handle, &properties.properties);
  const std::uint32_t version = properties.properties.apiVersion;
  device.info.name = properties.properties.deviceName;
  device.info.api_version = describe_version(version);
  device.info.is_cpu = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;

  std::vector<std::string>& missing = device.info.missing;
  if (version < VK_API_VERSION_1_2) {
    // Features of later versions must not be queried.
    missing.push_back("Vulkan 1.2 (it has " + device.info.api_version + ")");
    return device;
  }
  properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(handle, &properties);
  device.info.driver = std::string(driver.driverName) + " " + driver.driverInfo;

  VkPhysicalDeviceVulkan12Features features12{};
  features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  VkPhysicalDeviceFeatures2 features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  features.pNext = &features12;
  vkGetPhysicalDeviceFeatures2(handle, &features);
  if (features12.scalarBlockLayout != VK_TRUE) missing.emplace_back("scalarBlockLayout");
  if (features.features.shaderStorageImageWriteWithoutFormat != VK_TRUE) {
    missing.emplace_back("shaderStorageImageWriteWithoutFormat");
  }

  const QueueChoice queue = choose_queue(handle);
  device.queue_family = queue.family;
  if (!queue.computes) {
    missing.emplace_back("a compute queue");
  } else if (!queue.writes_timestamps) {
    missing.emplace_back("timestamps on a compute queue");
  }
  require_format(handle, VK_FORMAT_R32G32B32A32_SFLOAT, "rgba32f", missing);
  require_format(handle, VK_FORMAT_R16G16B16A16_SFLOAT, "rgba16f", missing);
  return device;
}

}  // namespace

std::vector<PhysicalDevice> physical_devices(const Instance& instance) {
  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance.get(), &count, nullptr), "list the Vulkan devices");
  std::vector<VkPhysicalDevice> handles(count);
  check(vkEnumeratePhysicalDevices(instance.get(), &count, handles.data()), "list the Vulkan devices");
  if (handles.empty()) throw RunError(kNoVulkanDevice);
  std::vector<PhysicalDevice> devices;
  devices.reserve(handles.size());
  for (VkPhysicalDevice handle : handles) devices.push_back(inspect(handle));
  return devices;
}

const PhysicalDevice& choose(const std::vector<PhysicalDevice>& devices, std::string_view name_substring) {
  if (name_substring.empty()) {
    const auto usable = [](const PhysicalDevice& device) { return device.info.missing.empty(); };
    const auto software = [&](const PhysicalDevice& device) { return usable(device) && device.info.is_cpu; };
    auto found = std::ranges::find_if(devices, software);
    if (found == devices.end()) found = std::ranges::find_if(devices, usable);
    if (found == devices.end()) throw RunError("no Vulkan device can be used: " + list(devices));
    return *found;
  }
  const std::string wanted = lower(name_substring);
  const PhysicalDevice* unusable = nullptr;
  for (const PhysicalDevice& device : devices) {
    if (lower(device.info.name).find(wanted) == std::string::npos) continue;
    if (device.info.missing.empty()) return device;
    if (unusable == nullptr) unusable = &device;
  }
  if (unusable != nullptr) throw RunError("the Vulkan device cannot be used: " + describe(unusable->info));
  throw InputError("no Vulkan device is named \"" + std::string(name_substring) + "\"; there are: " + list(devices));
}

}  // namespace airlight
