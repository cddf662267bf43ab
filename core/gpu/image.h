#pragma once
// An image with its memory and view; format and size known for its whole life, general layout once it has one.

#include <string>

#include "core/gpu/device.h"
#include "core/plan/plan.h"

namespace airlight {

class Image {
 public:
  // Throws RunError: too large for the device, or out of memory; both name the image.
  Image(const Device& device, const ImageDesc& desc);

  VkImage get() const { return image_.get(); }
  VkImageView view() const { return view_.get(); }
  const Extent& extent() const { return extent_; }
  std::size_t bytes() const { return bytes_; }

 private:
  Extent extent_;
  std::size_t bytes_ = 0;
  // The image dies before its memory.
  MemoryHandle memory_;
  ImageHandle image_;
  ImageViewHandle view_;
};

// "256x64 rgba32f".
std::string describe_shape(const ImageDesc& desc);

}  // namespace airlight
