// Plans on a real device: results, timings, refusals.

#include "core/gpu/executor.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "core/base/clock.h"
#include "core/gpu/frozen_modules.h"
#include "core/gpu/shader.h"
#include "core/gpu/specialize.h"
#include "tests/gpu/gpu_fixture.h"

namespace airlight {
namespace {

struct RampPlan {
  Plan plan;
  ImageId ramp;
  BufferId readback;
};

RampPlan ramp_plan(Extent extent, std::uint32_t base = 100) {
  RampPlan p;
  p.ramp = p.plan.add_image({.name = "ramp", .extent = extent});
  p.plan.add_pass({.shader = "ramp", .writes = {{"ramp_out", p.ramp}}, .grid = extent, .push_constants = {base}});
  p.readback = p.plan.add_readback(p.ramp);
  return p;
}

void expect_ramp(const std::vector<float>& texels, Extent extent, float base) {
  ASSERT_EQ(texels.size(), std::size_t{extent.width} * extent.height * 4);
  for (std::size_t y = 0; y < extent.height; ++y) {
    for (std::size_t x = 0; x < extent.width; ++x) {
      const float* texel = &texels[4 * (y * extent.width + x)];
      ASSERT_EQ(texel[0], base + static_cast<float>(y * extent.width + x)) << x << ", " << y;
      ASSERT_EQ(texel[1], static_cast<float>(x));
      ASSERT_EQ(texel[2], static_cast<float>(y));
    }
  }
}

TEST(Executor, ReadsImagesBackRowByRowWhateverTheirSize) {
  Executor executor({}, test_shaders());
  for (const Extent& extent : {Extent{1, 1}, Extent{13, 7}, Extent{8, 8}, Extent{1, 33}, Extent{33, 1}}) {
    RampPlan p = ramp_plan(extent);
    expect_ramp(values_of<float>(executor.run(p.plan).contents(p.readback)), extent, 100.0F);
  }
}

TEST(Executor, TimesPassesAndItsOwnWork) {
  Executor executor({}, test_shaders());
  RampPlan p = ramp_plan({512, 512});
  p.plan.add_pass(
      {.name = "again", .shader = "ramp", .writes = {{"ramp_out", p.ramp}}, .grid = {512, 512}, .push_constants = {1}});
  const RunResult first = executor.run(p.plan);
  ASSERT_EQ(first.passes.size(), 2U);
  EXPECT_EQ(first.passes[0].name, "ramp");
  EXPECT_EQ(first.passes[1].name, "again");
  const auto names = [](const RunResult& result) {
    std::vector<std::string> found;
    for (const Milestone& milestone : result.host) {
      found.push_back(milestone.name);
      EXPECT_GE(milestone.milliseconds, 0.0);
    }
    return found;
  };
  EXPECT_EQ(names(first),
            (std::vector<std::string>{"instance", "device", "pipelines", "record", "execute", "readback"}));
  const RunResult second = executor.run(p.plan);
  EXPECT_EQ(names(second), (std::vector<std::string>{"pipelines", "record", "execute", "readback"}));
  double passes = 0.0;
  for (const PassTiming& pass : second.passes) {
    EXPECT_GT(pass.milliseconds, 0.0) << pass.name;
    passes += pass.milliseconds;
  }
  EXPECT_LE(passes, second.host[2].milliseconds) << "passes take longer than the run that holds them";
}

// As on a GPU, which has passes at once that do not wait for one another.
TEST(Executor, TimesPassesThatNoBarrierParts) {
  Executor executor({.teams = true}, test_shaders());
  RampPlan p = ramp_plan({64, 64});
  const ImageId other = p.plan.add_image({.name = "other", .extent = {64, 64}});
  p.plan.add_readback(other);
  const auto add = [&](const char* name, ImageId image) {
    p.plan.add_pass(
        {.name = name, .shader = "ramp", .writes = {{"ramp_out", image}}, .grid = {64, 64}, .push_constants = {1}});
  };
  add("stranger", other);
  add("again", p.ramp);
  const RunResult result = executor.run(p.plan);
  ASSERT_EQ(result.passes.size(), 2U);
  EXPECT_EQ(result.passes[0].name, "ramp");
  EXPECT_EQ(result.passes[1].name, "stranger + again");
  EXPECT_GT(result.passes[1].milliseconds, 0.0);
  expect_ramp(values_of<float>(result.contents(p.readback)), {64, 64}, 1.0F);
}

// With a listener each pass is a submission of its own. The results are the same, and the reported share rises.
TEST(Executor, ReportsWhatIsDone) {
  Executor executor({}, test_shaders());
  RampPlan p = ramp_plan({300, 100});
  p.plan.add_pass(
      {.name = "again", .shader = "ramp", .writes = {{"ramp_out", p.ramp}}, .grid = {300, 100}, .push_constants = {7}});
  std::vector<double> done;
  const RunResult result = executor.run(p.plan, [&](double share) { done.push_back(share); });
  expect_ramp(values_of<float>(result.contents(p.readback)), {300, 100}, 7.0F);
  ASSERT_GE(done.size(), 2U);
  EXPECT_EQ(done.front(), 0.0);
  EXPECT_EQ(done.back(), 0.5);
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(result.passes.size(), 2U);
  for (const Milestone& milestone : result.host) {
    EXPECT_GE(milestone.milliseconds, 0.0) << milestone.name;
  }
}

// A chain over buffers: zeros, contents, read-modify-write, a copy.
TEST(Executor, RunsPassesInOrder) {
  Executor executor({}, test_shaders());
  Plan plan;
  const std::vector<std::uint32_t> start = {10, 20, 30, 40, 50};
  const BufferId zeros = plan.add_buffer({.name = "zeros", .bytes = 20, .host_readable = true});
  const BufferId numbers =
      plan.add_buffer({.name = "numbers", .bytes = 20, .host_readable = true, .contents = bytes_of(start)});
  const BufferId copy = plan.add_buffer({.name = "copy", .bytes = 20, .host_readable = true, .zeroed = false});
  const auto add = [&](BufferId to, std::uint32_t amount) {
    plan.add_pass({.shader = "accumulate", .writes = {{"numbers", to}}, .grid = {5, 1}, .push_constants = {amount}});
  };
  add(zeros, 3);
  add(numbers, 1);
  plan.add_pass(
      {.shader = "copy_numbers", .reads = {{"source", numbers}}, .writes = {{"target", copy}}, .grid = {5, 1}});
  add(numbers, 100);
  add(zeros, 4);
  for (int run = 0; run < 3; ++run) {
    const RunResult result = executor.run(plan);
    EXPECT_EQ(values_of<std::uint32_t>(result.contents(zeros)), (std::vector<std::uint32_t>(5, 7)));
    EXPECT_EQ(values_of<std::uint32_t>(result.contents(copy)), (std::vector<std::uint32_t>{11, 21, 31, 41, 51}));
    EXPECT_EQ(values_of<std::uint32_t>(result.contents(numbers)),
              (std::vector<std::uint32_t>{111, 121, 131, 141, 151}));
  }
}

// An earlier pass counts the workgroups: 2 of 32 threads, so a third of the numbers is left alone.
TEST(Executor, RunsAsManyWorkgroupsAsAPassCounts) {
  Executor executor({}, test_shaders());
  std::vector<std::uint32_t> start(96, 7);
  start[3] = 1;
  start[4] = 0;
  start[5] = 0;
  Plan plan;
  const BufferId numbers = plan.add_buffer({.name = "numbers", .bytes = 384, .contents = bytes_of(start)});
  const BufferId copy = plan.add_buffer({.name = "copy", .bytes = 384, .host_readable = true});
  plan.add_pass({.shader = "accumulate", .writes = {{"numbers", numbers}}, .grid = {96, 1}, .push_constants = {1}});
  plan.add_pass({.shader = "copy_numbers",
                 .reads = {{"source", numbers}},
                 .writes = {{"target", copy}},
                 .grid = {96, 1},
                 .groups = GroupCount{numbers, 12}});
  std::vector<std::uint32_t> wanted(96, 0);
  std::fill_n(wanted.begin(), 64, 8);
  wanted[3] = 2;
  wanted[4] = 1;
  wanted[5] = 1;
  for (int run = 0; run < 2; ++run) {
    EXPECT_EQ(values_of<std::uint32_t>(executor.run(plan).contents(copy)), wanted);
  }
}

// Neighbouring texels differ by one: linear filtering is exact between centres, and clamps beyond the outer ones.
TEST(Executor, SamplesImagesLinearlyAndClamps) {
  Executor executor({}, test_shaders());
  RampPlan p = ramp_plan({4, 2}, 0);
  const std::vector<float> points = {0.5F / 4, 0.25F, 1.0F / 4, 0.25F, 2.5F / 4, 0.5F, -1.0F, -1.0F, 2.0F, 2.0F};
  const BufferId at = p.plan.add_buffer({.name = "points", .bytes = points.size() * 4, .contents = bytes_of(points)});
  const BufferId samples = p.plan.add_buffer({.name = "samples", .bytes = 5 * 16, .host_readable = true});
  p.plan.add_pass({.shader = "sample_picture",
                   .reads = {{"picture_lut", p.ramp}, {"points", at}},
                   .writes = {{"samples", samples}},
                   .grid = {5, 1}});
  const std::vector<float> found = values_of<float>(executor.run(p.plan).contents(samples));
  const float expected[5] = {0.0F, 0.5F, 4.0F, 0.0F, 7.0F};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_FLOAT_EQ(found[4 * i], expected[i]) << i;
}

// An image that no pass makes: with a key it is filled once, without one at each run.
TEST(Executor, SamplesImagesThatTheHostFills) {
  Executor executor({}, test_shaders());
  int filled = 0;
  const auto middle_of = [&](const std::string& key, std::size_t texels) {
    Plan plan;
    const auto contents = [&filled, texels] {
      ++filled;
      std::vector<float> values;
      for (std::size_t i = 0; i < texels; ++i) {
        values.insert(values.end(), {static_cast<float>(i), 1.0F, 2.0F, 3.0F});
      }
      return bytes_of(values);
    };
    const ImageId map = plan.add_image({.name = "map", .extent = {4, 2, 1}, .key = key, .contents_when_run = contents});
    const std::vector<float> point = {2.0F / 4, 0.5F};
    const BufferId at = plan.add_buffer({.name = "points", .bytes = 8, .contents = bytes_of(point)});
    const BufferId samples = plan.add_buffer({.name = "samples", .bytes = 16, .host_readable = true});
    plan.add_pass({.shader = "sample_picture",
                   .reads = {{"picture_lut", map}, {"points", at}},
                   .writes = {{"samples", samples}},
                   .grid = {1, 1}});
    return values_of<float>(executor.run(plan).contents(samples));
  };
  const std::vector<float> expected{3.5F, 1.0F, 2.0F, 3.0F};
  for (int runs = 1; runs <= 2; ++runs) {
    EXPECT_EQ(middle_of("", 8), expected);
    EXPECT_EQ(filled, runs);
  }
  filled = 0;
  for (int runs = 1; runs <= 2; ++runs) {
    EXPECT_EQ(middle_of("a map", 8), expected);
    EXPECT_EQ(filled, 1);
  }
  EXPECT_THROW(middle_of("", 7), std::logic_error);
}

TEST(Executor, FillsAndSamplesVolumes) {
  Executor executor({}, test_shaders());
  Plan plan;
  const ImageId volume = plan.add_image({.name = "volume", .extent = {5, 3, 7}});
  plan.add_pass({.shader = "volume", .writes = {{"volume_out", volume}}, .grid = {5, 3, 7}});
  const std::vector<float> points = {2.5F / 5, 1.5F / 3, 3.5F / 7, 3.0F / 5, 1.0F / 3, 6.0F / 7, 9.0F, 9.0F, 9.0F};
  const BufferId at = plan.add_buffer({.name = "points", .bytes = points.size() * 4, .contents = bytes_of(points)});
  const BufferId samples = plan.add_buffer({.name = "samples", .bytes = 3 * 16, .host_readable = true});
  plan.add_pass({.shader = "sample_volume",
                 .reads = {{"volume_lut", volume}, {"points", at}},
                 .writes = {{"samples", samples}},
                 .grid = {3, 1}});
  const BufferId readback = plan.add_readback(volume);
  const RunResult result = executor.run(plan);
  const std::vector<float> found = values_of<float>(result.contents(samples));
  const float expected[3][3] = {{2.0F, 1.0F, 3.0F}, {2.5F, 0.5F, 5.5F}, {4.0F, 2.0F, 6.0F}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[4 * i + c], expected[i][c], 1e-5F) << i << ", " << c;
  }
  const std::vector<float> texels = values_of<float>(result.contents(readback));
  ASSERT_EQ(texels.size(), 5U * 3U * 7U * 4U);
  const float* texel = &texels[4 * ((4 * 3 + 1) * 5 + 3)];  // z 4, y 1, x 3
  EXPECT_EQ(texel[0], 3.0F);
  EXPECT_EQ(texel[1], 1.0F);
  EXPECT_EQ(texel[2], 4.0F);
}

// Whole numbers up to 7 are the same in 16 bits.
TEST(Executor, FiltersImagesOfFewComponents) {
  Executor executor({}, test_shaders());
  for (const std::uint32_t components : {1U, 2U}) {
    Plan plan;
    const ImageId volume =
        plan.add_image({.name = "volume", .extent = {5, 3, 7}, .half = true, .components = components});
    plan.add_pass({.shader = "volume_of_any_format", .writes = {{"volume_out", volume}}, .grid = {5, 3, 7}});
    const std::vector<float> points = {2.5F / 5, 1.5F / 3, 3.5F / 7, 3.0F / 5, 1.0F / 3, 6.0F / 7};
    const BufferId at = plan.add_buffer({.name = "points", .bytes = points.size() * 4, .contents = bytes_of(points)});
    const BufferId samples = plan.add_buffer({.name = "samples", .bytes = 2 * 16, .host_readable = true});
    plan.add_pass({.shader = "sample_volume",
                   .reads = {{"volume_lut", volume}, {"points", at}},
                   .writes = {{"samples", samples}},
                   .grid = {2, 1}});
    const RunResult result = executor.run(plan);
    const std::vector<float> found = values_of<float>(result.contents(samples));
    const float expected[2][2] = {{2.0F, 1.0F}, {2.5F, 0.5F}};
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t c = 0; c < components; ++c) EXPECT_NEAR(found[4 * i + c], expected[i][c], 1e-5F) << i << c;
    }
  }
}

// Output of tests/gpu/shaders/constants.comp.
struct Report {
  std::uint32_t count;
  float scale;
  std::uint32_t flag;
  std::uint32_t width;
  float radius;
  float sun[3];
  std::uint32_t pushed[3];
  std::uint32_t invocations;
};

// The shader's constants: this count, the others as it declares them.
std::vector<Specialization> with_count(std::uint32_t count) {
  return {{"kCount", count}, {"kScale", std::bit_cast<std::uint32_t>(0.5F)}, {"kFlag", 1}, {"local_size_x", 1}};
}

Report report_of(Executor& executor, const std::vector<Specialization>& specialization) {
  Plan plan;
  plan.scene_data = bytes_of(std::vector<float>{6360.0F, 0.25F, 0.5F, 0.75F});
  const BufferId report = plan.add_buffer({.name = "report", .bytes = sizeof(Report), .host_readable = true});
  plan.add_pass({.shader = "constants",
                 .writes = {{"report", report}},
                 .grid = {30, 1},
                 .push_constants = {7, 8, 9},
                 .specialization = specialization});
  return values_of<Report>(executor.run(plan).contents(report)).front();
}

TEST(Executor, PassesConstantsSceneAndPushConstants) {
  Executor executor({}, test_shaders());
  const Report defaults = report_of(executor, with_count(3));
  EXPECT_EQ(defaults.count, 3U);
  EXPECT_EQ(defaults.scale, 0.5F);
  EXPECT_EQ(defaults.flag, 1U);
  EXPECT_EQ(defaults.width, 1U);
  EXPECT_EQ(defaults.invocations, 30U);
  EXPECT_EQ(defaults.radius, 6360.0F);
  EXPECT_EQ(defaults.sun[0], 0.25F);
  EXPECT_EQ(defaults.sun[2], 0.75F);
  EXPECT_EQ(defaults.pushed[0], 7U);
  EXPECT_EQ(defaults.pushed[2], 9U);

  const Report set = report_of(
      executor, {{"kCount", 11}, {"kScale", std::bit_cast<std::uint32_t>(2.5F)}, {"kFlag", 0}, {"local_size_x", 16}});
  EXPECT_EQ(set.count, 11U);
  EXPECT_EQ(set.scale, 2.5F);
  EXPECT_EQ(set.flag, 0U);
  EXPECT_EQ(set.width, 16U);
  EXPECT_EQ(set.invocations, 32U);  // two workgroups

  // Another value gives another pipeline, and the first one still exists.
  EXPECT_EQ(report_of(executor, with_count(12)).count, 12U);
  EXPECT_EQ(report_of(executor, with_count(3)).count, 3U);
}

// A program that renders ever new scenes keeps a bounded number of pipelines, and those in use among them.
TEST(Executor, KeepsABoundedNumberOfPipelines) {
  constexpr std::size_t kMost = 3;
  Executor executor({.pipelines_max = kMost}, test_shaders());
  EXPECT_EQ(DeviceOptions().pipelines_max, 160U);
  for (std::uint32_t count = 1; count <= 6; ++count) {
    EXPECT_EQ(report_of(executor, with_count(count)).count, count);
    EXPECT_EQ(executor.memory_use().pipelines, std::min<std::size_t>(count, kMost));
  }
  EXPECT_EQ(executor.memory_use().pipelines_made, 6U);
  EXPECT_EQ(report_of(executor, with_count(5)).count, 5U);
  EXPECT_EQ(executor.memory_use().pipelines_made, 6U) << "5 is there still";
  EXPECT_EQ(report_of(executor, with_count(1)).count, 1U);
  EXPECT_EQ(executor.memory_use().pipelines_made, 7U) << "1 is made anew";
  EXPECT_EQ(executor.memory_use().pipelines, kMost);
}

// A module is stored under another's name: a result computed with it shows that it was read from the folder.
TEST(Executor, KeepsPreparedShadersInItsFolderAlone) {
  if (!can_specialize()) GTEST_SKIP() << "built without SPIRV-Tools";
  std::string name = (std::filesystem::temp_directory_path() / "airlight-cache-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  const auto count_of = [&](const std::filesystem::path& cache_folder, std::uint32_t count) {
    Executor executor({.cache_folder = cache_folder}, test_shaders());
    return report_of(executor, with_count(count)).count;
  };
  EXPECT_EQ(count_of("", 12), 12U);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  EXPECT_EQ(count_of(folder, 12), 12U);

  const auto source = std::find_if(test_shaders().begin(), test_shaders().end(),
                                   [](const EmbeddedShader& shader) { return shader.name == "constants"; });
  const ShaderInfo info = reflect("constants", source->spirv);
  const KeptFiles cache(folder / "modules", ".module");
  const auto key = [&](std::uint32_t count) {
    std::vector<ConstantValue> values;
    for (const SpecializationConstant& constant : info.constants) {
      values.push_back({constant.id, constant.name == "kCount" ? count : constant.default_value});
    }
    std::ranges::sort(values);
    return module_key(source->digest, values);
  };
  const std::vector<std::uint32_t> twelve = cache.find(key(12));
  EXPECT_FALSE(twelve.empty());
  cache.keep(key(11), twelve);
  EXPECT_EQ(count_of(folder, 11), 12U);
  EXPECT_EQ(count_of("", 11), 11U);
  std::filesystem::resize_file(folder / "modules" / (hexadecimal(key(11)) + ".module"), 100);
  EXPECT_EQ(count_of(folder, 11), 11U);
  EXPECT_EQ(count_of(folder, 11), 11U);
  std::filesystem::remove_all(folder);
}

TEST(Executor, GivesTheSameBitsInEveryRun) {
  Executor executor({}, test_shaders());
  const RampPlan p = ramp_plan({67, 41}, 3);
  const RunResult first = executor.run(p.plan);
  const std::vector<std::byte> bits(first.contents(p.readback).begin(), first.contents(p.readback).end());
  for (int run = 0; run < 5; ++run) {
    const RunResult again = executor.run(p.plan);
    EXPECT_TRUE(std::equal(bits.begin(), bits.end(), again.contents(p.readback).begin()));
  }
  Executor other({}, test_shaders());
  const RunResult elsewhere = other.run(p.plan);
  EXPECT_TRUE(std::equal(bits.begin(), bits.end(), elsewhere.contents(p.readback).begin()));
}

TEST(Executor, NamesBothSidesOfAMismatch) {
  Executor executor({}, test_shaders());
  RampPlan p = ramp_plan({4, 4});
  p.plan.add_pass(
      {.name = "second", .shader = "ramp", .writes = {{"rmap_out", p.ramp}}, .grid = {4, 4}, .push_constants = {1}});
  EXPECT_EQ(message_of<std::logic_error>([&] { executor.run(p.plan); }),
            "pass second, shader ramp: the shader has no binding named rmap_out; it has ramp_out");

  Plan unknown;
  const BufferId out = unknown.add_buffer({.name = "out", .bytes = 4});
  unknown.add_pass({.shader = "rampp", .writes = {{"out", out}}, .grid = {1, 1}});
  const std::string message = message_of<std::logic_error>([&] { executor.run(unknown); });
  EXPECT_NE(message.find("no shader is named rampp"), std::string::npos) << message;
  EXPECT_NE(message.find("accumulate, "), std::string::npos) << message;
}

TEST(Executor, ChecksThePlan) {
  Executor executor({}, test_shaders());
  Plan plan;
  const ImageId image = plan.add_image({.name = "image"});
  plan.add_readback(image);
  EXPECT_EQ(message_of<std::logic_error>([&] { executor.run(plan); }),
            "plan: image image is read back, but no pass wrote it");
}

TEST(Executor, RunsAPlanOfNothing) {
  Executor executor({}, test_shaders());
  EXPECT_TRUE(executor.run(Plan()).passes.empty());
}

}  // namespace
}  // namespace airlight
