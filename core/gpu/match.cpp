#include "core/gpu/match.h"

#include <algorithm>
#include <stdexcept>

namespace airlight {
namespace {

class Matcher {
 public:
  Matcher(const Plan& plan, const PassDesc& pass, const ShaderInfo& shader, bool teams)
      : plan_(plan), pass_(pass), shader_(shader), team_(teams ? pass.team : 1) {}

  MatchedPass run() const {
    MatchedPass matched;
    for (const Binding& read : pass_.reads) matched.bindings.push_back(match_binding(read, false));
    for (const Binding& write : pass_.writes) matched.bindings.push_back(match_binding(write, true));
    check_nothing_left_out();
    check_blocks();
    match_constants(matched);
    match_grid(matched);
    return matched;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw std::logic_error("pass " + pass_name(pass_) + ", shader " + shader_.name + ": " + problem);
  }

  // "it has a, b".
  std::string known_bindings() const {
    std::string text;
    for (const ShaderBinding& binding : shader_.bindings) {
      if (!comes_with_scene(binding)) text += (text.empty() ? "it has " : ", ") + binding.name;
    }
    return text.empty() ? "it has none" : text;
  }

  std::string known_constants() const {
    std::string text;
    for (const SpecializationConstant& constant : shader_.constants) {
      text += (text.empty() ? "it has " : ", ") + constant.name;
    }
    return text.empty() ? "it has none" : text;
  }

  MatchedBinding match_binding(const Binding& bound, bool writes) const {
    const auto found = std::ranges::find_if(
        shader_.bindings, [&](const ShaderBinding& b) { return b.name == bound.name && !comes_with_scene(b); });
    if (found == shader_.bindings.end()) {
      refuse("the shader has no binding named " + bound.name + "; " + known_bindings());
    }
    const std::string what = bound.name + " is " + std::string(describe(found->kind)) + " in the shader";
    const std::string bound_to = describe(plan_, bound.resource);
    const bool is_buffer = found->kind == BindingKind::storage_buffer;
    if (is_buffer != std::holds_alternative<BufferId>(bound.resource)) {
      refuse(what + " and is bound to " + bound_to);
    }
    if (writes && !found->writable) refuse(what + " that is only read; the pass lists it among its writes");
    if (!writes && found->writable) {
      refuse(what + " that may be written; declare it readonly there, or list it among the writes");
    }
    if (is_buffer) {
      check_buffer(*found, bound, what + " and is bound to " + bound_to);
    } else {
      check_image(*found, bound, what + " and is bound to " + bound_to);
    }
    return {*found, bound.resource};
  }

  void check_image(const ShaderBinding& binding, const Binding& bound, const std::string& what) const {
    const ImageDesc& image = plan_.images()[std::get<ImageId>(bound.resource).index];
    if (binding.is_3d != (image.extent.depth > 1)) {
      refuse(what + ": one of them is 3-D and the other is not");
    }
    if (binding.kind == BindingKind::storage_image && binding.is_half != image.half) {
      refuse(what + ": one of them has 16 bits a channel and the other 32");
    }
  }

  void check_buffer(const ShaderBinding& binding, const Binding& bound, const std::string& what) const {
    const BufferDesc& buffer = plan_.buffers()[std::get<BufferId>(bound.resource).index];
    if (buffer.bytes < binding.block_bytes) {
      refuse(what + " of " + std::to_string(buffer.bytes) + " bytes; the shader's block has " +
             std::to_string(binding.block_bytes));
    }
  }

  void check_nothing_left_out() const {
    for (const ShaderBinding& binding : shader_.bindings) {
      const auto is_it = [&](const Binding& bound) { return bound.name == binding.name; };
      if (!comes_with_scene(binding) && std::ranges::none_of(pass_.reads, is_it) &&
          std::ranges::none_of(pass_.writes, is_it)) {
        refuse("the pass binds nothing to " + binding.name + ", " + std::string(describe(binding.kind)));
      }
    }
  }

  void check_blocks() const {
    for (const ShaderBinding& binding : shader_.bindings) {
      if (binding.kind == BindingKind::uniform_block && plan_.scene_of(pass_).size() < binding.block_bytes) {
        refuse("the uniform block " + binding.name + " has " + std::to_string(binding.block_bytes) +
               " bytes, the plan's scene data " + std::to_string(plan_.scene_of(pass_).size()));
      }
      if (binding.kind == BindingKind::storage_buffer && comes_with_scene(binding)) check_tables(binding);
    }
    const std::size_t pushed = pass_.push_constants.size() * sizeof(std::uint32_t);
    if (pushed != shader_.push_constant_bytes) {
      refuse("the push constants have " + std::to_string(shader_.push_constant_bytes) + " bytes in the shader and " +
             std::to_string(pushed) + " in the pass");
    }
  }

  void check_tables(const ShaderBinding& binding) const {
    const auto block = std::ranges::find_if(
        shader_.bindings, [](const ShaderBinding& b) { return b.kind == BindingKind::uniform_block; });
    if (block == shader_.bindings.end()) refuse(binding.name + " stands behind a uniform block, and there is none");
    if (plan_.scene_of(pass_).size() <= scene_tables_offset(block->block_bytes)) {
      refuse("the plan's scene data ends before " + binding.name);
    }
  }

  void match_constants(MatchedPass& matched) const {
    std::vector<Specialization> all = pass_.specialization;
    const auto is_team = [](const SpecializationConstant& constant) { return constant.name == "kTeam"; };
    if (pass_.team > 1 || std::ranges::any_of(shader_.constants, is_team)) all.push_back({"kTeam", team_});
    for (const Specialization& wanted : all) {
      const auto found = std::ranges::find_if(shader_.constants,
                                              [&](const SpecializationConstant& c) { return c.name == wanted.name; });
      if (found == shader_.constants.end()) {
        refuse("the shader has no specialization constant named " + wanted.name + "; " + known_constants());
      }
      const auto is_it = [&](const ConstantValue& constant) { return constant.id == found->id; };
      if (std::ranges::any_of(matched.constants, is_it)) {
        refuse("specialization constant " + wanted.name + " is set twice");
      }
      matched.constants.push_back({found->id, wanted.value});
    }
    for (const SpecializationConstant& constant : shader_.constants) {
      if (std::ranges::none_of(matched.constants, [&](const ConstantValue& set) { return set.id == constant.id; })) {
        refuse("the pass sets no value of the specialization constant " + constant.name);
      }
    }
    std::ranges::sort(matched.constants);
  }

  void match_grid(MatchedPass& matched) const {
    const std::array<std::uint32_t, 3> grid = {pass_.grid.width * team_, pass_.grid.height, pass_.grid.depth};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::uint32_t size = shader_.workgroup_size[axis];
      for (const ConstantValue& constant : matched.constants) {
        if (constant.id == shader_.workgroup_size_ids[axis]) size = constant.value;
      }
      if (size == 0) refuse("a side of the workgroup is 0");
      matched.workgroup_size[axis] = size;
      matched.workgroups[axis] = (grid[axis] - 1) / size + 1;
    }
  }

  const Plan& plan_;
  const PassDesc& pass_;
  const ShaderInfo& shader_;
  const std::uint32_t team_;
};

}  // namespace

MatchedPass match(const Plan& plan, const PassDesc& pass, const ShaderInfo& shader, bool teams) {
  return Matcher(plan, pass, shader, teams).run();
}

}  // namespace airlight
