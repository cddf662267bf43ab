#include "core/gpu/image.h"

#include <algorithm>

#include "core/base/error.h"

namespace airlight {
namespace {

void check_sides(const Device& device, const ImageDesc& desc, const std::string& what) {
  const std::uint32_t limit = desc.extent.depth > 1 ? device.limits().image_side_3d : device.limits().image_side_2d;
  const std::uint32_t longest = std::max({desc.extent.width, desc.extent.height, desc.extent.depth});
  if (longest > limit) {
    throw RunError(what + " is too large: the device " + device.info().name + " takes at most " +
                   std::to_string(limit) + " texels a side");
  }
}

VkFormat format_of(const Device& device, const ImageDesc& desc) {
  const bool half = desc.half && device.keeps_halves();
  if (desc.components < 4 && device.keeps_few_components(half)) {
    return desc.components == 1 ? (half ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R32_SFLOAT)
                                : (half ? VK_FORMAT_R16G16_SFLOAT : VK_FORMAT_R32G32_SFLOAT);
  }
  return half ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
}

}  // namespace

std::string describe_shape(const ImageDesc& desc) {
  std::string text = std::to_string(desc.extent.width) + "x" + std::to_string(desc.extent.height);
  if (desc.extent.depth > 1) text += "x" + std::to_string(desc.extent.depth);
  const std::string components = desc.components == 1 ? " r" : desc.components == 2 ? " rg" : " rgba";
  return text + components + (desc.half ? "16f" : "32f");
}

Image::Image(const Device& device, const ImageDesc& desc) : extent_(desc.extent) {
  const std::string what = "image " + desc.name + ", " + describe_shape(desc);
  check_sides(device, desc, what);
  device.check_size(desc.bytes(), what);
  const bool is_3d = desc.extent.depth > 1;
  const VkImageCreateInfo image_info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                     .imageType = is_3d ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D,
                                     .format = format_of(device, desc),
                                     .extent = {desc.extent.width, desc.extent.height, desc.extent.depth},
                                     .mipLevels = 1,
                                     .arrayLayers = 1,
                                     .samples = VK_SAMPLE_COUNT_1_BIT,
                                     .tiling = VK_IMAGE_TILING_OPTIMAL,
                                     .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                              VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                     .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
                                     .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED};
  image_ = ImageHandle::make(device.get(), vkCreateImage, image_info, "make " + what);

  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device.get(), image_.get(), &needs);
  bytes_ = needs.size;
  memory_ = device.allocate(needs, MemoryPlace::device, what);
  check(vkBindImageMemory(device.get(), image_.get(), memory_.get(), 0), "place " + what);

  const VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                        .image = image_.get(),
                                        .viewType = is_3d ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D,
                                        .format = image_info.format,
                                        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
  view_ = ImageViewHandle::make(device.get(), vkCreateImageView, view_info, "view " + what);
}

}  // namespace airlight
