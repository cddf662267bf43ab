// Shaders' loops test at their end, and compute what they did.

#include "core/gpu/rotate_loops.h"

#include <gtest/gtest.h>

#include <spirv/unified1/spirv.hpp>

#include "core/gpu/shader.h"
#include "tests/gpu/gpu_fixture.h"

namespace airlight {
namespace {

using uint = std::uint32_t;
#define FUNCTION inline
#include "tests/gpu/loops.h"
#undef FUNCTION

TEST(RotateLoops, LeaveWhatLoopsComputeAsItWas) {
  constexpr uint kNumbers = 100;
  Executor executor({}, test_shaders());
  Plan plan;
  const BufferId results =
      plan.add_buffer({.name = "results", .bytes = sizeof(uint) * kNumbers * kKinds, .host_readable = true});
  plan.add_pass(
      {.shader = "loops", .writes = {{"turned_out", results}}, .grid = {kNumbers, 1}, .push_constants = {kNumbers}});
  const RunResult run = executor.run(plan);
  const std::vector<uint> values = values_of<uint>(run.contents(results));
  for (uint kind = 0; kind < kKinds; kind++) {
    for (uint n = 0; n < kNumbers; n++) {
      ASSERT_EQ(values[kind * kNumbers + n], turned(kind, n)) << "kind " << kind << ", n " << n;
    }
  }
}

struct Loops {
  std::size_t all = 0;
  std::size_t test_first = 0;  // the first branch of two ways, in the header or the block behind it, leaves the loop
};

// Loops to be unrolled do not count.
Loops loops_of(std::span<const std::uint32_t> words) {
  Loops loops;
  std::uint32_t merge = 0;
  std::uint32_t proceeds = 0;
  int blocks = 0;  // since the header's first
  for (std::size_t at = 5; at < words.size(); at += words[at] >> spv::WordCountShift) {
    const std::uint32_t opcode = words[at] & spv::OpCodeMask;
    if (opcode == spv::OpLabel) blocks++;
    if (opcode == spv::OpLoopMerge && (words[at + 3] & spv::LoopControlUnrollMask) == 0) {
      loops.all++;
      merge = words[at + 1];
      proceeds = words[at + 2];
      blocks = 0;
    }
    if (opcode != spv::OpBranchConditional || blocks > 1) continue;
    const std::uint32_t first = words[at + 2];
    const std::uint32_t second = words[at + 3];
    if ((first == merge && second != proceeds) || (second == merge && first != proceeds)) loops.test_first++;
    merge = 0;
  }
  return loops;
}

TEST(RotateLoops, TurnThoseOfAllShaders) {
  std::size_t all = 0;
  for (const EmbeddedShader& source : embedded_shaders()) {
    const Loops of = loops_of(source.spirv);
    EXPECT_EQ(of.test_first, 0U) << source.name << ", of " << of.all;
    all += of.all;
  }
  EXPECT_GT(all, 300U);
}

TEST(RotateLoops, RefuseWhatIsNoModule) {
  const std::vector<std::uint32_t> none;
  EXPECT_EQ(message_of<std::logic_error>([&] { rotate_loops(none); }), "this is not SPIR-V");
  std::vector<std::uint32_t> cut(test_shaders()[0].spirv.begin(), test_shaders()[0].spirv.end());
  cut.pop_back();
  EXPECT_EQ(message_of<std::logic_error>([&] { rotate_loops(cut); }), "the SPIR-V is cut off");
}

}  // namespace
}  // namespace airlight
