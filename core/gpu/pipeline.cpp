#include "core/gpu/pipeline.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/in_parallel.h"
#include "core/base/text.h"
#include "core/gpu/specialize.h"

namespace airlight {
namespace {

ShaderModuleHandle make_module(const Device& device, const ShaderInfo& info, std::span<const std::uint32_t> spirv) {
  const VkShaderModuleCreateInfo module_info{
      .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = spirv.size_bytes(), .pCode = spirv.data()};
  return ShaderModuleHandle::make(device.get(), vkCreateShaderModule, module_info, "load the shader " + info.name);
}

DescriptorSetLayoutHandle make_set_layout(const Device& device, const ShaderInfo& info) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const ShaderBinding& binding : info.bindings) {
    bindings.push_back({.binding = binding.binding,
                        .descriptorType = descriptor_type(binding.kind),
                        .descriptorCount = 1,
                        .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT,
                        .pImmutableSamplers = nullptr});
  }
  const VkDescriptorSetLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                    .bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                                    .pBindings = bindings.data()};
  return DescriptorSetLayoutHandle::make(device.get(), vkCreateDescriptorSetLayout, layout_info,
                                         "lay out the bindings of " + info.name);
}

PipelineLayoutHandle make_layout(const Device& device, const ShaderInfo& info, VkDescriptorSetLayout set_layout) {
  if (info.push_constant_bytes > device.limits().push_constant_bytes) {
    throw RunError("shader " + info.name + " has " + std::to_string(info.push_constant_bytes) +
                   " bytes of push constants; the device " + device.info().name + " takes at most " +
                   std::to_string(device.limits().push_constant_bytes));
  }
  const VkPushConstantRange range{.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT,
                                  .size = static_cast<std::uint32_t>(info.push_constant_bytes)};
  const VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                               .setLayoutCount = 1,
                                               .pSetLayouts = &set_layout,
                                               .pushConstantRangeCount = range.size > 0 ? 1U : 0U,
                                               .pPushConstantRanges = &range};
  return PipelineLayoutHandle::make(device.get(), vkCreatePipelineLayout, layout_info,
                                    "lay out the shader " + info.name);
}

PipelineHandle make_pipeline(const Device& device, const ShaderProgram& program, std::span<const std::uint32_t> spirv,
                             const VkSpecializationInfo* specialization) {
  const ShaderInfo& info = program.info;
  const ShaderModuleHandle module = make_module(device, info, spirv);
  const VkPipelineShaderStageCreateInfo stage{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                              .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                              .module = module.get(),
                                              .pName = info.entry_point.c_str(),
                                              .pSpecializationInfo = specialization};
  const VkComputePipelineCreateInfo pipeline_info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                                  .stage = stage,
                                                  .layout = program.layout.get(),
                                                  .basePipelineIndex = -1};
  VkPipeline pipeline = nullptr;
  check(vkCreateComputePipelines(device.get(), nullptr, 1, &pipeline_info, nullptr, &pipeline),
        "compile the shader " + info.name);
  return {device.get(), pipeline};
}

}  // namespace

VkDescriptorType descriptor_type(BindingKind kind) {
  switch (kind) {
    case BindingKind::uniform_block:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingKind::sampled_image:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case BindingKind::storage_image:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case BindingKind::storage_buffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  }
  return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
}

PipelineCache::PipelineCache(const Device& device, std::span<const EmbeddedShader> extra, std::filesystem::path folder,
                             std::size_t most)
    : device_(device), frozen_(std::move(folder)), most_(most) {
  for (const EmbeddedShader& shader : embedded_shaders()) shaders_[std::string(shader.name)] = shader;
  for (const EmbeddedShader& shader : extra) shaders_[std::string(shader.name)] = shader;
}

const ShaderProgram& PipelineCache::program(const std::string& shader) {
  if (const auto found = programs_.find(shader); found != programs_.end()) return *found->second;
  const auto source = shaders_.find(shader);
  if (source == shaders_.end()) {
    const std::string names = joined_of(shaders_, [](const auto& known) { return known.first; });
    throw std::logic_error("no shader is named " + shader + "; there are: " + names);
  }
  auto program = std::make_unique<ShaderProgram>();
  program->info = reflect(shader, source->second.spirv);
  program->source = source->second;
  program->set_layout = make_set_layout(device_, program->info);
  program->layout = make_layout(device_, program->info, program->set_layout.get());
  return *programs_.emplace(shader, std::move(program)).first->second;
}

PipelineHandle PipelineCache::compile(const Request& request, bool& made) const {
  const ShaderProgram& program = *request.program;
  if (can_specialize()) {
    const FrozenModules::Words words = frozen_.get(program.source, request.constants, made);
    return make_pipeline(device_, program, words.get(), nullptr);
  }
  std::vector<VkSpecializationMapEntry> entries;
  std::vector<std::uint32_t> values;
  for (const ConstantValue& constant : request.constants) {
    entries.push_back({.constantID = constant.id,
                       .offset = static_cast<std::uint32_t>(values.size() * sizeof(std::uint32_t)),
                       .size = sizeof(std::uint32_t)});
    values.push_back(constant.value);
  }
  const VkSpecializationInfo specialization{.mapEntryCount = static_cast<std::uint32_t>(entries.size()),
                                            .pMapEntries = entries.data(),
                                            .dataSize = values.size() * sizeof(std::uint32_t),
                                            .pData = values.data()};
  return make_pipeline(device_, program, program.source.spirv, &specialization);
}

// Beyond the most, those go that were asked for longest ago, but none of this call.
void PipelineCache::drop_unused() {
  while (pipelines_.size() > most_) {
    const auto oldest =
        std::ranges::min_element(pipelines_, {}, [](const auto& entry) { return entry.second.last_call; });
    if (oldest->second.last_call == calls_) return;
    pipelines_.erase(oldest);
  }
}

std::vector<VkPipeline> PipelineCache::pipelines(const std::vector<Request>& requests) {
  ++calls_;
  std::vector<const Request*> missing;
  std::vector<Kept*> places;
  const auto key = [](const Request& request) { return Key(request.program->info.name, request.constants); };
  for (const Request& request : requests) {
    const auto [place, is_new] = pipelines_.try_emplace(key(request));
    place->second.last_call = calls_;
    if (!is_new && place->second.pipeline) continue;
    if (std::ranges::find(places, &place->second) != places.end()) continue;
    missing.push_back(&request);
    places.push_back(&place->second);
  }
  drop_unused();
  made_ += missing.size();
  std::atomic<bool> any_made = false;
  in_parallel(missing.size(), [&](std::size_t i) {
    bool made = false;
    places[i]->pipeline = compile(*missing[i], made);
    if (made) any_made = true;
  });
  if (any_made) frozen_.trim();

  std::vector<VkPipeline> found;
  found.reserve(requests.size());
  for (const Request& request : requests) found.push_back(pipelines_.at(key(request)).pipeline.get());
  return found;
}

}  // namespace airlight
