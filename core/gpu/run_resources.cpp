#include "core/gpu/run_resources.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace airlight {

RunResources::RunResources(const Device& device, ResourceCache& cache, const StoredTables& tables, const Plan& plan)
    : plan_(plan),
      cache_(cache),
      tables_(tables),
      buffer_place_(device.is_unified() ? MemoryPlace::shared : MemoryPlace::device),
      images_(plan.images().size()),
      buffers_(plan.buffers().size()),
      downloads_(plan.buffers().size()),
      stores_(plan.images().size()) {
  for (std::uint32_t i = 0; i < images_.size(); ++i) {
    const ImageDesc& image = plan.images()[i];
    if (!image.key.empty() && cache.holds(image)) {
      held_.insert(ImageId{i});
    } else if (std::vector<std::uint32_t> words = tables.find(image); !words.empty()) {
      held_.insert(ImageId{i});
      contents_.emplace(i, std::move(words));
    }
  }
  for (std::uint32_t i = 0; i < buffers_.size(); ++i) {
    const BufferDesc& buffer = plan.buffers()[i];
    if (!buffer.key.empty() && cache.holds(buffer, buffer_place_)) held_.insert(BufferId{i});
  }
}

bool RunResources::find_stored(const std::vector<bool>& runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const Binding& write : plan_.passes()[i].writes) {
      const auto* id = std::get_if<BufferId>(&write.resource);
      if (!runs[i] || id == nullptr) continue;
      std::vector<std::uint32_t> words = tables_.find(plan_.buffers()[id->index]);
      if (words.empty()) continue;
      held_.insert(*id);
      stored_.emplace(id->index, std::move(words));
    }
  }
  return !stored_.empty();
}

Resource& RunResources::at(ResourceId id) const {
  if (const auto* image = std::get_if<ImageId>(&id)) return *images_[image->index];
  return *buffers_[std::get<BufferId>(id).index];
}

Resource& RunResources::acquire(ResourceId id) {
  if (const auto* image = std::get_if<ImageId>(&id)) {
    Resource*& place = images_[image->index];
    if (place == nullptr) place = &cache_.image(plan_.images()[image->index]);
    return *place;
  }
  const BufferId buffer = std::get<BufferId>(id);
  Resource*& place = buffers_[buffer.index];
  if (place == nullptr) {
    // Only the copy writes a readback's buffer; no shader sees it.
    const bool is_readback = std::any_of(plan_.readbacks().begin(), plan_.readbacks().end(),
                                         [&](const Plan::Readback& readback) { return readback.buffer == buffer; });
    place = &cache_.buffer(plan_.buffers()[buffer.index], is_readback ? MemoryPlace::readback : buffer_place_);
  }
  return *place;
}

void RunResources::acquire(std::span<const Step> steps) {
  for (const Step& step : steps) {
    for (const MatchedBinding& bound : step.matched.bindings) acquire(bound.resource);
  }
  acquire_for_host();
  fill_images();
  acquire_for_storing(steps);
  check_kept_are_made(steps);
  write_scenes();
}

void RunResources::acquire_for_host() {
  for (const Plan::Readback& readback : plan_.readbacks()) acquire(readback.image);
  for (std::uint32_t i = 0; i < buffers_.size(); ++i) {
    const BufferDesc& desc = plan_.buffers()[i];
    if (!desc.host_readable || !acquire(BufferId{i}).buffer->mapped().empty()) continue;
    downloads_[i] = &cache_.buffer({.name = desc.name + " for the host", .bytes = desc.bytes}, MemoryPlace::readback);
  }
}

void RunResources::fill_images() {
  for (std::uint32_t i = 0; i < images_.size(); ++i) {
    const ImageDesc& image = plan_.images()[i];
    if (images_[i] == nullptr || !image.contents_when_run || held_.contains(ImageId{i})) continue;
    const std::vector<std::byte> contents = image.contents_when_run();
    if (contents.size() != image.bytes()) {
      throw std::logic_error("image " + image.name + " has " + std::to_string(contents.size()) +
                             " bytes of contents and is " + std::to_string(image.bytes()) + " long");
    }
    std::vector<std::uint32_t>& words = contents_[i];
    words.resize(contents.size() / sizeof(words[0]));
    std::memcpy(words.data(), contents.data(), contents.size());
  }
}

void RunResources::acquire_for_storing(std::span<const Step> steps) {
  for (const Step& step : steps) {
    for (const Binding& write : step.pass->writes) {
      const auto* id = std::get_if<ImageId>(&write.resource);
      if (id == nullptr || !tables_.takes(plan_.images()[id->index])) continue;
      const ImageDesc& table = plan_.images()[id->index];
      stores_[id->index] =
          &cache_.buffer({.name = table.name + " to be stored", .bytes = table.bytes()}, MemoryPlace::readback);
    }
  }
}

std::span<const std::uint32_t> RunResources::contents(std::uint32_t image) const {
  const auto found = contents_.find(image);
  return found == contents_.end() ? std::span<const std::uint32_t>() : found->second;
}

std::vector<std::uint32_t> RunResources::take_stored(std::uint32_t buffer) {
  const auto found = stored_.find(buffer);
  return found == stored_.end() ? std::vector<std::uint32_t>() : std::exchange(found->second, {});
}

void RunResources::write_scenes() {
  scenes_.assign(plan_.scene_count(), nullptr);
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    const std::vector<std::byte>& data = plan_.scene(i);
    if (data.empty()) continue;
    scenes_[i] = &cache_.buffer({.name = "scene data " + std::to_string(i), .bytes = data.size()}, MemoryPlace::upload);
    std::memcpy(scenes_[i]->buffer->mapped().data(), data.data(), data.size());
  }
}

const Buffer& RunResources::upload(const BufferDesc& of, std::span<const std::byte> contents) {
  const Buffer& buffer =
      *cache_.buffer({.name = "upload of " + of.name, .bytes = of.bytes}, MemoryPlace::upload).buffer;
  std::memcpy(buffer.mapped().data(), contents.data(), contents.size());
  return buffer;
}

const std::string& RunResources::key(ResourceId id) const {
  if (const auto* image = std::get_if<ImageId>(&id)) return plan_.images()[image->index].key;
  return plan_.buffers()[std::get<BufferId>(id).index].key;
}

bool RunResources::has_contents(ResourceId id) const {
  if (const auto* image = std::get_if<ImageId>(&id)) return bool{plan_.images()[image->index].contents_when_run};
  return plan_.buffers()[std::get<BufferId>(id).index].has_contents();
}

void RunResources::check_kept_are_made(std::span<const Step> steps) const {
  std::set<ResourceId> made = held_;
  const auto require = [&](ResourceId id, const std::string& who) {
    if (key(id).empty() || has_contents(id) || made.contains(id)) return;
    throw std::logic_error(who + " reads " + describe(plan_, id) + ", kept as \"" + key(id) +
                           "\", but nothing has made it so far");
  };
  for (const Step& step : steps) {
    for (const Binding& read : step.pass->reads) require(read.resource, "pass " + pass_name(*step.pass));
    for (const Binding& write : step.pass->writes) made.insert(write.resource);
  }
  for (const Plan::Readback& readback : plan_.readbacks()) require(readback.image, "the host");
}

void RunResources::remember(std::span<const Step> steps) {
  for (Resource* image : images_) {
    if (image != nullptr) image->has_layout = true;
  }
  for (const auto& [image, words] : contents_) {
    if (images_[image] != nullptr) images_[image]->has_contents = !key(ImageId{image}).empty();
  }
  const auto keep = [&](ResourceId id) { at(id).has_contents = !key(id).empty(); };
  for (const Step& step : steps) {
    for (const Binding& write : step.pass->writes) keep(write.resource);
  }
  for (std::uint32_t i = 0; i < buffers_.size(); ++i) {
    if (buffers_[i] != nullptr && has_contents(BufferId{i})) keep(BufferId{i});
  }
}

}  // namespace airlight
