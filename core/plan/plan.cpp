#include "core/plan/plan.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace airlight {

std::size_t ImageDesc::bytes() const {
  const std::size_t texel = std::size_t{components} * (half ? sizeof(float) / 2 : sizeof(float));
  return std::size_t{extent.width} * extent.height * extent.depth * texel;
}

void Plan::begin_scene(std::vector<std::byte> data, std::string suffix, std::string channels) {
  more_scenes_.push_back(std::move(data));
  current_scene_ = static_cast<std::uint32_t>(more_scenes_.size());
  suffix_ = std::move(suffix);
  channels_ = std::move(channels);
}

void Plan::end_scene() {
  current_scene_ = first_scene_;
  suffix_.clear();
  channels_.clear();
}

void Plan::put_scene(std::vector<std::byte> data) {
  (first_scene_ == 0 ? scene_data : more_scenes_[first_scene_ - 1]) = std::move(data);
}

void Plan::begin_light(std::vector<std::byte> data, std::string suffix) {
  more_scenes_.push_back(std::move(data));
  first_scene_ = static_cast<std::uint32_t>(more_scenes_.size());
  light_ = std::move(suffix);
  end_scene();
}

void Plan::end_light() {
  first_scene_ = 0;
  light_.clear();
  end_scene();
}

void Plan::tell_apart(std::string name) {
  apart_ = std::move(name);
}

std::optional<ImageId> Plan::table_of(const std::string& key) const {
  const auto found = light_.empty() ? images_.end() : std::ranges::find(images_, key + suffix_, &ImageDesc::key);
  return found == images_.end() ? std::nullopt
                                : std::optional(ImageId{static_cast<std::uint32_t>(found - images_.begin())});
}

std::optional<ImageId> Plan::shared_image(const std::string& key) const {
  const auto is_it = [&](const ImageDesc& image) { return image.shared && image.key == key; };
  const auto found = std::ranges::find_if(images_, is_it);
  return found == images_.end() ? std::nullopt
                                : std::optional(ImageId{static_cast<std::uint32_t>(found - images_.begin())});
}

const std::vector<std::byte>& Plan::scene(std::size_t index) const {
  return index == 0 ? scene_data : more_scenes_.at(index - 1);
}

const std::vector<std::byte>& Plan::scene_of(const PassDesc& pass) const {
  return scene(pass.scene);
}

ImageId Plan::add_image(ImageDesc desc) {
  assert(desc.components == 4 || desc.half);
  desc.name += apart_ + suffix_ + light_;
  if (!desc.shared) {
    desc.key += desc.key.empty() ? "" : desc.stored ? suffix_ : suffix_ + light_;
    desc.channels = channels_;
  }
  images_.push_back(std::move(desc));
  return {static_cast<std::uint32_t>(images_.size() - 1)};
}

BufferId Plan::add_buffer(BufferDesc desc) {
  desc.name += apart_ + suffix_ + light_;
  desc.key += desc.key.empty() ? "" : suffix_ + light_;
  buffers_.push_back(std::move(desc));
  return {static_cast<std::uint32_t>(buffers_.size() - 1)};
}

BufferId Plan::add_shared_buffer(BufferDesc desc) {
  desc.name += light_;
  desc.key += desc.key.empty() ? "" : light_;
  const auto found = std::ranges::find(buffers_, desc.name, &BufferDesc::name);
  if (found != buffers_.end()) {
    assert(found->bytes == desc.bytes);
    return {static_cast<std::uint32_t>(found - buffers_.begin())};
  }
  buffers_.push_back(std::move(desc));
  return {static_cast<std::uint32_t>(buffers_.size() - 1)};
}

BufferId Plan::add_buffer_once(BufferDesc desc) {
  desc.name += suffix_;
  desc.key += desc.key.empty() ? "" : suffix_;
  return add_shared_buffer(std::move(desc));
}

void Plan::add_pass(PassDesc desc) {
  desc.scene = current_scene_;
  if (const std::string suffix = apart_ + suffix_ + light_; !suffix.empty()) {
    desc.name = pass_name(desc) + suffix;
  }
  passes_.push_back(std::move(desc));
}

BufferId Plan::add_readback(ImageId image) {
  const ImageDesc& source = images_.at(image.index);
  assert(!source.half);
  const BufferId buffer =
      add_buffer({.name = source.name + " readback", .bytes = source.bytes(), .host_readable = true, .zeroed = false});
  readbacks_.push_back({image, buffer});
  return buffer;
}

const std::string& pass_name(const PassDesc& pass) {
  return pass.name.empty() ? pass.shader : pass.name;
}

}  // namespace airlight
