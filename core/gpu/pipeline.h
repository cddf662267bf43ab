#pragma once
// Compute pipelines by shader and specialization, made once for an executor's life.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/gpu/device.h"
#include "core/gpu/embedded_shaders.h"
#include "core/gpu/frozen_modules.h"
#include "core/gpu/match.h"
#include "core/gpu/shader.h"

namespace airlight {

// Objects that all pipelines of one shader share.
struct ShaderProgram {
  ShaderInfo info;
  EmbeddedShader source;
  DescriptorSetLayoutHandle set_layout;
  PipelineLayoutHandle layout;
};

VkDescriptorType descriptor_type(BindingKind kind);

class PipelineCache {
 public:
  // Shaders by name: airlight's and `extra`, which replace airlight's of the same name. `folder`: for frozen modules;
  // empty: none.
  PipelineCache(const Device& device, std::span<const EmbeddedShader> extra, std::filesystem::path folder);

  // Throws std::logic_error listing the names that exist.
  const ShaderProgram& program(const std::string& shader);

  struct Request {
    const ShaderProgram* program;
    std::vector<ConstantValue> constants;
  };
  // One pipeline for each request, in order. Missing ones are compiled on all the machine's threads.
  std::vector<VkPipeline> pipelines(const std::vector<Request>& requests);

 private:
  using Key = std::pair<std::string, std::vector<ConstantValue>>;
  // `made`: whether the optimiser had to make the module.
  PipelineHandle compile(const Request& request, bool& made) const;

  const Device& device_;
  FrozenModules frozen_;
  std::map<std::string, EmbeddedShader, std::less<>> shaders_;
  std::map<std::string, std::unique_ptr<ShaderProgram>, std::less<>> programs_;
  std::map<Key, PipelineHandle> pipelines_;
};

}  // namespace airlight
