#include "core/gpu/descriptors.h"

namespace airlight {

DescriptorCounts count_descriptors(std::span<const Step> steps) {
  DescriptorCounts counts;
  for (const Step& step : steps) {
    ++counts.sets;
    for (const ShaderBinding& binding : step.program->info.bindings) {
      switch (binding.kind) {
        case BindingKind::uniform_block:
          ++counts.uniform_blocks;
          break;
        case BindingKind::sampled_image:
          ++counts.sampled_images;
          break;
        case BindingKind::storage_image:
          ++counts.storage_images;
          break;
        case BindingKind::storage_buffer:
          ++counts.storage_buffers;
          break;
      }
    }
  }
  return counts;
}

void write_descriptors(const Device& device, const Plan& plan, const RunResources& resources, VkSampler sampler,
                       const Step& step) {
  const std::size_t count = step.program->info.bindings.size();
  std::vector<VkDescriptorImageInfo> images;
  std::vector<VkDescriptorBufferInfo> buffers;
  images.reserve(count);  // the writes point into them
  buffers.reserve(count);
  std::vector<VkWriteDescriptorSet> writes;
  const auto add = [&](const ShaderBinding& binding) -> VkWriteDescriptorSet& {
    return writes.emplace_back(VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                                    .dstSet = step.set,
                                                    .dstBinding = binding.binding,
                                                    .descriptorCount = 1,
                                                    .descriptorType = descriptor_type(binding.kind)});
  };
  for (const MatchedBinding& bound : step.matched.bindings) {
    const Resource& resource = resources.at(bound.resource);
    if (resource.buffer) {
      const BufferDesc& desc = plan.buffers()[std::get<BufferId>(bound.resource).index];
      buffers.push_back({resource.buffer->get(), 0, desc.bytes});
      add(bound.binding).pBufferInfo = &buffers.back();
    } else {
      const bool is_sampled = bound.binding.kind == BindingKind::sampled_image;
      images.push_back({is_sampled ? sampler : nullptr, resource.image->view(), VK_IMAGE_LAYOUT_GENERAL});
      add(bound.binding).pImageInfo = &images.back();
    }
  }
  std::size_t block_bytes = 0;
  for (const ShaderBinding& binding : step.program->info.bindings) {
    if (binding.kind == BindingKind::uniform_block) block_bytes = binding.block_bytes;
  }
  const std::size_t tables = scene_tables_offset(block_bytes);
  for (const ShaderBinding& binding : step.program->info.bindings) {
    if (!comes_with_scene(binding)) continue;
    const VkBuffer scene = resources.scene(step.pass->scene)->buffer->get();
    if (binding.kind == BindingKind::uniform_block) {
      buffers.push_back({scene, 0, block_bytes});
    } else {
      buffers.push_back({scene, tables, plan.scene_of(*step.pass).size() - tables});
    }
    add(binding).pBufferInfo = &buffers.back();
  }
  vkUpdateDescriptorSets(device.get(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

}  // namespace airlight
