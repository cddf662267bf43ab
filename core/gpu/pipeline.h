#pragma once
// Compute pipelines by shader and specialization, kept from run to run. Of those that no recent run used, the most
// recent stay: an executor that renders ever new scenes holds a bounded number of them.

#include <cstdint>
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
  // empty: none. `most`: DeviceOptions::pipelines_max.
  PipelineCache(const Device& device, std::span<const EmbeddedShader> extra, std::filesystem::path folder,
                std::size_t most);

  // Throws std::logic_error listing the names that exist.
  const ShaderProgram& program(const std::string& shader);

  struct Request {
    const ShaderProgram* program;
    std::vector<ConstantValue> constants;
  };
  // One pipeline for each request, in order. Missing ones are compiled on all the machine's threads. They stay until
  // the next call at least, by which time the device is done with them.
  std::vector<VkPipeline> pipelines(const std::vector<Request>& requests);

  std::size_t count() const { return pipelines_.size(); }
  std::size_t made() const { return made_; }  // so far

 private:
  using Key = std::pair<std::string, std::vector<ConstantValue>>;
  // `made`: whether the optimiser had to make the module.
  PipelineHandle compile(const Request& request, bool& made) const;
  void drop_unused();

  const Device& device_;
  FrozenModules frozen_;
  std::map<std::string, EmbeddedShader, std::less<>> shaders_;
  std::map<std::string, std::unique_ptr<ShaderProgram>, std::less<>> programs_;
  struct Kept {
    PipelineHandle pipeline;
    std::uint64_t last_call = 0;
  };
  std::map<Key, Kept> pipelines_;
  std::size_t most_;
  std::uint64_t calls_ = 0;
  std::size_t made_ = 0;
};

}  // namespace airlight
