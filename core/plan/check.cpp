// Checks a plan for errors that can be found without a device.

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/plan/plan.h"

namespace airlight {
namespace {

[[noreturn]] void refuse(const std::string& problem) {
  throw std::logic_error("plan: " + problem);
}

bool known(const Plan& plan, ResourceId id) {
  if (const auto* image = std::get_if<ImageId>(&id)) return image->index < plan.images().size();
  return std::get<BufferId>(id).index < plan.buffers().size();
}

void check_names(const Plan& plan) {
  std::set<std::string> names;
  std::set<std::string> keys;
  const auto add = [&](const std::string& name, const std::string& key) {
    if (name.empty()) refuse("a resource has no name");
    if (!names.insert(name).second) refuse("two resources are named " + name);
    if (!key.empty() && !keys.insert(key).second) refuse(name + ": another resource has the key " + key + " too");
  };
  for (const ImageDesc& image : plan.images()) {
    add(image.name, image.key);
    if (image.extent.width == 0 || image.extent.height == 0 || image.extent.depth == 0) {
      refuse("image " + image.name + " is empty");
    }
    if (image.half && image.contents_when_run) {
      refuse("image " + image.name + " of 16 bits starts with 32-bit contents");
    }
  }
  for (const BufferDesc& buffer : plan.buffers()) {
    add(buffer.name, buffer.key);
    if (buffer.bytes == 0) refuse("buffer " + buffer.name + " is empty");
    if (!buffer.contents.empty() && buffer.contents.size() != buffer.bytes) {
      refuse("buffer " + buffer.name + " has " + std::to_string(buffer.contents.size()) + " bytes of contents and is " +
             std::to_string(buffer.bytes) + " long");
    }
  }
}

// The resources that hold something, as the passes are visited in order.
class Contents {
 public:
  explicit Contents(const Plan& plan) {
    for (const ImageDesc& image : plan.images()) {
      images_.push_back(!image.key.empty() || image.contents_when_run);
    }
    for (const BufferDesc& buffer : plan.buffers()) buffers_.push_back(!buffer.key.empty() || buffer.has_contents());
  }
  bool there(ResourceId id) const {
    if (const auto* image = std::get_if<ImageId>(&id)) return images_[image->index];
    return buffers_[std::get<BufferId>(id).index];
  }
  void write(ResourceId id) {
    if (const auto* image = std::get_if<ImageId>(&id)) {
      images_[image->index] = true;
    } else {
      buffers_[std::get<BufferId>(id).index] = true;
    }
  }

 private:
  std::vector<bool> images_;
  std::vector<bool> buffers_;
};

void check_bindings(const Plan& plan, const PassDesc& pass, const std::string& where) {
  std::set<std::string> names;
  const auto check_one = [&](const Binding& binding) {
    if (!names.insert(binding.name).second) refuse(where + "two bindings are named " + binding.name);
    if (!known(plan, binding.resource)) refuse(where + binding.name + " is bound to a resource that the plan lacks");
    if (binding.parts == 0 || binding.parts > kAllParts) {
      refuse(where + binding.name + " is bound to no part, or to one that nothing has");
    }
    for (const Plan::Readback& readback : plan.readbacks()) {
      if (binding.resource == ResourceId(readback.buffer)) {
        refuse(where + binding.name + " is bound to " + describe(plan, readback.buffer) +
               ", which is filled after the last pass");
      }
    }
  };
  for (const Binding& binding : pass.reads) check_one(binding);
  for (const Binding& binding : pass.writes) check_one(binding);

  for (std::size_t i = 0; i < pass.writes.size(); ++i) {
    const ResourceId written = pass.writes[i].resource;
    for (const Binding& read : pass.reads) {
      if (read.resource == written) {
        refuse(where + describe(plan, written) + " is both read (" + read.name + ") and written (" +
               pass.writes[i].name + "); what is read and written stands among the writes only");
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (pass.writes[j].resource == written) {
        refuse(where + describe(plan, written) + " is written as " + pass.writes[j].name + " and as " +
               pass.writes[i].name);
      }
    }
  }
}

void check_groups(const Plan& plan, const PassDesc& pass, const std::string& where) {
  constexpr std::size_t kBytes = 3 * sizeof(std::uint32_t);
  if (!pass.groups) return;
  const auto is_counts = [&](const Binding& binding) { return binding.resource == ResourceId(pass.groups->buffer); };
  if (std::ranges::none_of(pass.reads, is_counts) && std::ranges::none_of(pass.writes, is_counts)) {
    refuse(where + "the buffer that counts its workgroups is none of those that it has");
  }
  if (pass.groups->offset % 4 != 0 || pass.groups->offset + kBytes > plan.buffers()[pass.groups->buffer.index].bytes) {
    refuse(where + "byte " + std::to_string(pass.groups->offset) + " of " + describe(plan, pass.groups->buffer) +
           " cannot hold its three counts of workgroups");
  }
}

}  // namespace

std::string describe(const Plan& plan, ResourceId id) {
  if (const auto* image = std::get_if<ImageId>(&id)) return "image " + plan.images()[image->index].name;
  return "buffer " + plan.buffers()[std::get<BufferId>(id).index].name;
}

void check(const Plan& plan) {
  check_names(plan);
  Contents contents(plan);
  for (const PassDesc& pass : plan.passes()) {
    if (pass.shader.empty()) refuse("pass " + pass.name + " has no shader");
    const std::string where = "pass " + pass_name(pass) + ": ";
    check_bindings(plan, pass, where);
    if (pass.grid.width == 0 || pass.grid.height == 0 || pass.grid.depth == 0) refuse(where + "its grid is empty");
    check_groups(plan, pass, where);
    if (pass.writes.empty()) refuse(where + "it writes nothing");
    for (const Binding& read : pass.reads) {
      if (!contents.there(read.resource)) {
        refuse(where + describe(plan, read.resource) + " is read as " + read.name + ", but no earlier pass wrote it");
      }
    }
    for (const Binding& write : pass.writes) contents.write(write.resource);
  }
  for (const Plan::Readback& readback : plan.readbacks()) {
    if (!contents.there(readback.image)) refuse(describe(plan, readback.image) + " is read back, but no pass wrote it");
  }
}

}  // namespace airlight
