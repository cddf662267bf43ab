#pragma once
// The Vulkan instance, with the validation layer where asked for.

#include "core/gpu/vulkan_api.h"

namespace airlight {

// The drivers that are opened: all that are installed, or Mesa's of the software device alone, which takes two thirds
// of the time. Where the user selects drivers by $VK_LOADER_DRIVERS_SELECT, those.
enum class Drivers { all, software };

class Instance {
 public:
  // Throws RunError: no loader, no driver, or a validation layer asked for and not installed.
  explicit Instance(bool validation, Drivers drivers = Drivers::all);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance get() const { return instance_; }

 private:
  void add_messenger();

  VkInstance instance_ = nullptr;
  VkDebugUtilsMessengerEXT messenger_ = nullptr;
};

// Messages that the validation layer has sent so far in this process.
int validation_messages();

}  // namespace airlight
