#include "core/plan/plan.h"

#include <utility>

namespace airlight {

std::size_t ImageDesc::bytes() const {
  return std::size_t{extent.width} * extent.height * extent.depth * bytes_per_texel(format);
}

ImageId Plan::add_image(ImageDesc desc) {
  images_.push_back(std::move(desc));
  return {static_cast<std::uint32_t>(images_.size() - 1)};
}

BufferId Plan::add_buffer(BufferDesc desc) {
  buffers_.push_back(std::move(desc));
  return {static_cast<std::uint32_t>(buffers_.size() - 1)};
}

void Plan::add_pass(PassDesc desc) {
  passes_.push_back(std::move(desc));
}

BufferId Plan::add_readback(ImageId image) {
  const ImageDesc& source = images_.at(image.index);
  const BufferId buffer = add_buffer({.name = source.name + " readback",
                                      .bytes = source.bytes(),
                                      .host_readable = true,
                                      .contents = {},
                                      .key = {},
                                      .zeroed = false});
  readbacks_.push_back({image, buffer});
  return buffer;
}

std::size_t bytes_per_texel(Format format) {
  return format == Format::rgba32f ? 16 : 8;
}

const std::string& pass_name(const PassDesc& pass) {
  return pass.name.empty() ? pass.shader : pass.name;
}

}  // namespace airlight
