#pragma once
// Move-only owner of one Vulkan handle.

#include <utility>

#include "core/gpu/vulkan_api.h"

namespace airlight {

// kDestroy points to the function pointer, not to the function, since the loader is opened at run time.
template <class T, auto* kDestroy>
class Handle {
 public:
  Handle() = default;
  Handle(VkDevice device, T handle) : device_(device), handle_(handle) {}
  // Makes the handle by Vulkan's function `create`. Throws RunError "cannot DOING: ...".
  template <class Info>
  static Handle make(VkDevice device, VkResult (*create)(VkDevice, const Info*, const VkAllocationCallbacks*, T*),
                     const Info& info, std::string_view doing) {
    T handle = nullptr;
    check(create(device, &info, nullptr, &handle), doing);
    return {device, handle};
  }
  Handle(Handle&& other) noexcept
      : device_(std::exchange(other.device_, nullptr)), handle_(std::exchange(other.handle_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Handle() {
    if (handle_ != nullptr) (*kDestroy)(device_, handle_, nullptr);
  }

  T get() const { return handle_; }
  explicit operator bool() const { return handle_ != nullptr; }

 private:
  VkDevice device_ = nullptr;
  T handle_ = nullptr;
};

using BufferHandle = Handle<VkBuffer, &vkDestroyBuffer>;
using CommandPoolHandle = Handle<VkCommandPool, &vkDestroyCommandPool>;
using DescriptorPoolHandle = Handle<VkDescriptorPool, &vkDestroyDescriptorPool>;
using DescriptorSetLayoutHandle = Handle<VkDescriptorSetLayout, &vkDestroyDescriptorSetLayout>;
using FenceHandle = Handle<VkFence, &vkDestroyFence>;
using ImageHandle = Handle<VkImage, &vkDestroyImage>;
using ImageViewHandle = Handle<VkImageView, &vkDestroyImageView>;
using MemoryHandle = Handle<VkDeviceMemory, &vkFreeMemory>;
using PipelineHandle = Handle<VkPipeline, &vkDestroyPipeline>;
using PipelineLayoutHandle = Handle<VkPipelineLayout, &vkDestroyPipelineLayout>;
using QueryPoolHandle = Handle<VkQueryPool, &vkDestroyQueryPool>;
using SamplerHandle = Handle<VkSampler, &vkDestroySampler>;
using ShaderModuleHandle = Handle<VkShaderModule, &vkDestroyShaderModule>;

}  // namespace airlight
