#include "core/gpu/instance.h"

#include <dlfcn.h>
#include <link.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/memory_limit.h"
#include "core/gpu/physical_device.h"

namespace airlight {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

// The loader reads this variable when it makes an instance: patterns of the names of drivers' manifests.
constexpr const char* kSelect = "VK_LOADER_DRIVERS_SELECT";
constexpr const char* kSoftware = "lvp*";

std::atomic<int> message_count = 0;

VKAPI_ATTR VkBool32 VKAPI_CALL count_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                             const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
  ++message_count;
  std::fprintf(stderr, "validation: %s\n", data->pMessage);
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info() {
  return {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
          .messageSeverity =
              VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
          // Performance messages are left out: they advise against the general layout, which every image has by choice.
          .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT,
          .pfnUserCallback = count_message,
          .pUserData = nullptr};
}

// Vulkan unloads drivers with its last instance. Kept, the next instance of the process opens in 2 ms instead of 25
// (the software device brings LLVM), the process ends 1 ms sooner, and a sanitizer can name the library that leaks.
void keep_libraries_loaded() {
  std::vector<std::string> names;
  const auto collect = [](dl_phdr_info* library, std::size_t, void* list) {
    static_cast<std::vector<std::string>*>(list)->emplace_back(library->dlpi_name);
    return 0;
  };
  dl_iterate_phdr(collect, &names);
  for (const std::string& name : names) {
    if (!name.empty()) dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
  }
}

// Only the environment can tell the loader, but it must not tell programs that are started meanwhile.
VkResult create_instance(const VkInstanceCreateInfo& info, Drivers drivers, VkInstance& instance) {
  static std::mutex mutex;
  const std::scoped_lock lock(mutex);
  const bool selects = drivers == Drivers::software && std::getenv(kSelect) == nullptr;
  if (selects) setenv(kSelect, kSoftware, 0);
  const VkResult result = vkCreateInstance(&info, nullptr, &instance);
  if (selects) unsetenv(kSelect);
  return result;
}

void require_validation_layer() {
  std::uint32_t count = 0;
  check(vkEnumerateInstanceLayerProperties(&count, nullptr), "list the Vulkan layers");
  std::vector<VkLayerProperties> layers(count);
  check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "list the Vulkan layers");
  for (const VkLayerProperties& layer : layers) {
    if (std::strcmp(layer.layerName, kValidationLayer) == 0) return;
  }
  throw RunError("validation was asked for, but " + std::string(kValidationLayer) +
                 " is not installed; install the package vulkan-validationlayers");
}

// Mesa's software device takes 800 to 970 MiB of addresses for small pictures. Where far less is permitted, its
// libraries use memory that they did not get, and the process dies.
void require_memory() {
  constexpr unsigned long long kLeast = 768;  // MiB
  if (const auto limit = memory_limit(); limit && *limit < kLeast) {
    throw RunError("out of memory: a Vulkan device needs about 1 GiB of addresses" + memory_limit_words());
  }
}

}  // namespace

Instance::Instance(bool validation, Drivers drivers) {
  require_memory();
  open_loader();
  if (validation) require_validation_layer();

  constexpr std::array kEnabled = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  const VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info();
  const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                         .pNext = &messenger,
                                         .enabledValidationFeatureCount = kEnabled.size(),
                                         .pEnabledValidationFeatures = kEnabled.data()};
  constexpr std::array kExtensions = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
  const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                      .pApplicationName = "airlight",
                                      .pEngineName = "airlight",
                                      .apiVersion = VK_API_VERSION_1_2};
  const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                  .pNext = validation ? &features : nullptr,
                                  .pApplicationInfo = &application,
                                  .enabledLayerCount = validation ? 1U : 0U,
                                  .ppEnabledLayerNames = &kValidationLayer,
                                  .enabledExtensionCount = validation ? 1U : 0U,
                                  .ppEnabledExtensionNames = kExtensions.data()};
  const VkResult result = create_instance(info, drivers, instance_);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) throw RunError(kNoVulkanDevice);
  check(result, "open Vulkan");
  keep_libraries_loaded();
  load_functions(instance_);
  if (validation) add_messenger();
}

void Instance::add_messenger() {
  // Looked up through the instance: another instance without validation would clear the process-wide function pointer.
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
  const VkDebugUtilsMessengerCreateInfoEXT info = messenger_info();
  check(create(instance_, &info, nullptr, &messenger_), "install the validation messenger");
}

Instance::~Instance() {
  if (messenger_ != nullptr) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance_, messenger_, nullptr);
  }
  if (instance_ != nullptr) vkDestroyInstance(instance_, nullptr);
}

int validation_messages() {
  return message_count;
}

}  // namespace airlight
