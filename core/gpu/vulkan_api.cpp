#define VOLK_IMPLEMENTATION
#include "core/gpu/vulkan_api.h"

#include <mutex>

#include "core/base/error.h"

namespace airlight {
namespace {

std::mutex loader_mutex;

}  // namespace

void open_loader() {
  const std::scoped_lock lock(loader_mutex);
  if (volkInitialize() != VK_SUCCESS) {
    throw RunError("no Vulkan loader (libvulkan.so.1) on this machine; install the package libvulkan1");
  }
  const std::uint32_t version = volkGetInstanceVersion();
  if (version < VK_API_VERSION_1_2) {
    throw RunError("the Vulkan loader is of version " + describe_version(version) +
                   ", 1.2 or newer is needed; update the package libvulkan1");
  }
}

void load_functions(VkInstance instance) {
  const std::scoped_lock lock(loader_mutex);
  volkLoadInstance(instance);
}

std::string describe(VkResult result) {
#define AIRLIGHT_NAME(name) \
  case name:                \
    return #name
  switch (result) {
    AIRLIGHT_NAME(VK_SUCCESS);
    AIRLIGHT_NAME(VK_NOT_READY);
    AIRLIGHT_NAME(VK_TIMEOUT);
    AIRLIGHT_NAME(VK_INCOMPLETE);
    AIRLIGHT_NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
    AIRLIGHT_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
    AIRLIGHT_NAME(VK_ERROR_INITIALIZATION_FAILED);
    AIRLIGHT_NAME(VK_ERROR_DEVICE_LOST);
    AIRLIGHT_NAME(VK_ERROR_MEMORY_MAP_FAILED);
    AIRLIGHT_NAME(VK_ERROR_LAYER_NOT_PRESENT);
    AIRLIGHT_NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
    AIRLIGHT_NAME(VK_ERROR_FEATURE_NOT_PRESENT);
    AIRLIGHT_NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
    AIRLIGHT_NAME(VK_ERROR_TOO_MANY_OBJECTS);
    AIRLIGHT_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
    AIRLIGHT_NAME(VK_ERROR_FRAGMENTED_POOL);
    AIRLIGHT_NAME(VK_ERROR_OUT_OF_POOL_MEMORY);
    AIRLIGHT_NAME(VK_ERROR_UNKNOWN);
    default:
      return "VkResult " + std::to_string(static_cast<int>(result));
  }
#undef AIRLIGHT_NAME
}

std::string describe_version(std::uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
         std::to_string(VK_API_VERSION_PATCH(version));
}

void check(VkResult result, std::string_view doing) {
  if (result != VK_SUCCESS) throw RunError("cannot " + std::string(doing) + ": " + describe(result));
}

}  // namespace airlight
