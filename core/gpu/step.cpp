#include "core/gpu/step.h"

#include <algorithm>

#include "core/base/error.h"

namespace airlight {
namespace {

class LimitCheck {
 public:
  LimitCheck(const Plan& plan, const Step& step, const Device& device)
      : plan_(plan), step_(step), device_(device), limits_(device.limits()) {}

  void buffers() const {
    for (const MatchedBinding& bound : step_.matched.bindings) {
      if (bound.binding.kind != BindingKind::storage_buffer) continue;
      const BufferDesc& buffer = plan_.buffers()[std::get<BufferId>(bound.resource).index];
      if (buffer.bytes > limits_.storage_buffer_bytes) {
        refuse(bound.binding.name + " (buffer " + buffer.name + ") has " + describe_bytes(buffer.bytes),
               describe_bytes(limits_.storage_buffer_bytes) + " in a storage buffer");
      }
    }
    for (const ShaderBinding& binding : step_.program->info.bindings) {
      if (binding.kind == BindingKind::uniform_block && binding.block_bytes > limits_.uniform_block_bytes) {
        refuse("the scene data has " + describe_bytes(binding.block_bytes),
               describe_bytes(limits_.uniform_block_bytes) + " in a uniform block");
      }
    }
  }

  void workgroups() const {
    std::uint64_t threads = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      threads *= step_.matched.workgroup_size[axis];
      if (step_.matched.workgroups[axis] > limits_.workgroups[axis]) {
        refuse("its grid needs " + std::to_string(step_.matched.workgroups[axis]) + " workgroups along one axis",
               std::to_string(limits_.workgroups[axis]));
      }
    }
    if (threads > limits_.workgroup_invocations) {
      refuse("its workgroup has " + std::to_string(threads) + " threads",
             std::to_string(limits_.workgroup_invocations));
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& limit) const {
    throw RunError("pass " + pass_name(*step_.pass) + ": " + what + "; the device " + device_.info().name +
                   " takes at most " + limit);
  }

  const Plan& plan_;
  const Step& step_;
  const Device& device_;
  const DeviceLimits& limits_;
};

}  // namespace

bool Step::writes(ResourceId id) const {
  return std::ranges::any_of(pass->writes, [&](const Binding& write) { return write.resource == id; });
}

void check_limits(const Plan& plan, const Step& step, const Device& device) {
  const LimitCheck limit_check(plan, step, device);
  limit_check.buffers();
  limit_check.workgroups();
}

}  // namespace airlight
