#include "core/gpu/specialize.h"

#include <stdexcept>

#ifdef AIRLIGHT_SPIRV_TOOLS
#include <spirv-tools/libspirv.h>

#include <spirv-tools/optimizer.hpp>
#include <unordered_map>
#endif

namespace airlight {

#ifdef AIRLIGHT_SPIRV_TOOLS

namespace {

// To be raised with every change of the passes.
constexpr const char* kPasses = "passes 3";

void register_freezing(spvtools::Optimizer& optimizer, std::span<const ConstantValue> constants) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
  for (const ConstantValue& constant : constants) values[constant.id] = {constant.value};
  optimizer.RegisterPass(spvtools::CreateStripDebugInfoPass())
      .RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
      .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass());
}

// Constant values, also through branches and phis, and the branches that they decide.
void register_folding(spvtools::Optimizer& optimizer) {
  optimizer.RegisterPass(spvtools::CreateCCPPass()).RegisterPass(spvtools::CreateDeadBranchElimPass());
}

void register_cleaning(spvtools::Optimizer& optimizer) {
  optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass()).RegisterPass(spvtools::CreateBlockMergePass());
}

// Arrays whose indices are constants become variables in registers.
void register_scalars(spvtools::Optimizer& optimizer) {
  optimizer.RegisterPass(spvtools::CreateScalarReplacementPass())
      .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
      .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass());
}

// What a pipeline's constants leave of a module, its loops that ask for it written out.
void register_folded_unrolling(spvtools::Optimizer& optimizer) {
  optimizer.RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
  register_folding(optimizer);
  register_cleaning(optimizer);
  optimizer.RegisterPass(spvtools::CreateLoopUnrollPass(true));
  register_folding(optimizer);
  optimizer.RegisterPass(spvtools::CreateSimplificationPass()).RegisterPass(spvtools::CreateAggressiveDCEPass());
  register_scalars(optimizer);
  register_folding(optimizer);
  optimizer.RegisterPass(spvtools::CreateSimplificationPass());
  register_cleaning(optimizer);
}

}  // namespace

bool can_specialize() {
  return true;
}

std::string specializer_version() {
  return std::string(kPasses) + ", " + spvSoftwareVersionDetailsString();
}

namespace {

bool is_valid(const std::vector<std::uint32_t>& words) {
  spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_2);
  tools.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&, const char*) {});
  spvtools::ValidatorOptions options;
  options.SetScalarBlockLayout(true);
  return tools.Validate(words.data(), words.size(), options);
}

std::vector<std::uint32_t> optimized(std::string_view shader, std::span<const std::uint32_t> spirv,
                                     std::span<const ConstantValue> constants, bool folds) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_2);
  std::string problem;
  optimizer.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) { problem = message; });
  register_freezing(optimizer, constants);
  if (folds) {
    register_folded_unrolling(optimizer);
  } else {
    optimizer.RegisterPass(spvtools::CreateLoopUnrollPass(true));
  }
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);  // done by the caller
  std::vector<std::uint32_t> result;
  if (!optimizer.Run(spirv.data(), spirv.size(), &result, options)) {
    throw std::logic_error("shader " + std::string(shader) + ": its constants cannot be frozen: " + problem);
  }
  return result;
}

}  // namespace

// Folding may put a composite constant before one of its parts, if that part's value equals a constant further down
// (seen with SPIRV-Tools 2023.1). Such a module keeps its expressions.
std::vector<std::uint32_t> specialize(std::string_view shader, std::span<const std::uint32_t> spirv,
                                      std::span<const ConstantValue> constants) {
  std::vector<std::uint32_t> folded = optimized(shader, spirv, constants, true);
  return is_valid(folded) ? folded : optimized(shader, spirv, constants, false);
}

#else

bool can_specialize() {
  return false;
}

std::string specializer_version() {
  return "none";
}

std::vector<std::uint32_t> specialize(std::string_view shader, std::span<const std::uint32_t>,
                                      std::span<const ConstantValue>) {
  throw std::logic_error("shader " + std::string(shader) + ": built without SPIRV-Tools, its constants stay open");
}

#endif

}  // namespace airlight
