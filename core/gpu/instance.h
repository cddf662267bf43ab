#pragma once
// The Vulkan instance, with the validation layer where asked for.

#include "core/gpu/vulkan_api.h"

namespace airlight {

// The drivers to open: all that are installed, or Mesa's software device alone, which takes two thirds of the time.
// $VK_LOADER_DRIVERS_SELECT, where the user sets it, decides instead.
enum class Drivers { all, software };

class Instance {
 public:
  // Throws RunError where there is no loader, no driver, or no validation layer though one was asked for.
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
