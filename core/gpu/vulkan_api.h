#pragma once
// Vulkan's C API. volk opens the loader at run time, so that a machine without one gets our error message instead of a
// failure of the dynamic linker.

#include <volk.h>

#include <cstdint>
#include <string>
#include <string_view>

// Members left out of a Vulkan structure are zero, which means none.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace airlight {

// Opens the loader. Throws RunError naming the package when there is none, or one older than Vulkan 1.2.
void open_loader();

// Loads the functions of an instance; every later call to Vulkan goes through them.
void load_functions(VkInstance instance);

// "VK_ERROR_DEVICE_LOST".
std::string describe(VkResult result);

// "1.3.230".
std::string describe_version(std::uint32_t version);

// Throws RunError "cannot DOING: VK_ERROR_..." unless the result is VK_SUCCESS.
void check(VkResult result, std::string_view doing);

}  // namespace airlight
