// Resources that an executor keeps between runs, and that it keeps no others.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/gpu/executor.h"
#include "core/gpu/stored_tables.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/this_build.h"

namespace airlight {
namespace {

struct KeptRun {
  std::vector<std::string> passes;
  std::vector<std::uint32_t> numbers;
};

// Numbers made under a key, then copied to where the host reads them.
KeptRun run_kept(Executor& executor, const std::string& key, std::uint32_t amount, std::size_t count = 8) {
  Plan plan;
  const BufferId kept = plan.add_buffer({.name = "kept", .bytes = 4 * count, .key = key});
  const BufferId copy = plan.add_buffer({.name = "copy", .bytes = 4 * count, .host_readable = true});
  const Extent grid{static_cast<std::uint32_t>(count), 1};
  plan.add_pass({.shader = "accumulate", .writes = {{"numbers", kept}}, .grid = grid, .push_constants = {amount}});
  plan.add_pass({.shader = "copy_numbers", .reads = {{"source", kept}}, .writes = {{"target", copy}}, .grid = grid});
  const RunResult result = executor.run(plan);
  KeptRun run;
  for (const PassTiming& pass : result.passes) run.passes.push_back(pass.name);
  run.numbers = values_of<std::uint32_t>(result.contents(copy));
  return run;
}

const std::vector<std::string> kBoth = {"accumulate", "copy_numbers"};
const std::vector<std::string> kCopyAlone = {"copy_numbers"};

TEST(Kept, IsMadeOnceForAKey) {
  Executor executor({}, test_shaders());
  EXPECT_EQ(run_kept(executor, "five", 5).passes, kBoth);
  // A caller must not use another amount under the same key; here it shows that nothing was made.
  const KeptRun again = run_kept(executor, "five", 6);
  EXPECT_EQ(again.passes, kCopyAlone);
  EXPECT_EQ(again.numbers, std::vector<std::uint32_t>(8, 5));
  EXPECT_EQ(run_kept(executor, "six", 6).numbers, std::vector<std::uint32_t>(8, 6));
  EXPECT_EQ(run_kept(executor, "five", 7).passes, kCopyAlone);
}

TEST(Kept, AnotherSizeIsAnotherThing) {
  Executor executor({}, test_shaders());
  run_kept(executor, "key", 5, 8);
  const KeptRun larger = run_kept(executor, "key", 6, 9);
  EXPECT_EQ(larger.passes, kBoth);
  EXPECT_EQ(larger.numbers, std::vector<std::uint32_t>(9, 6));
}

TEST(Kept, ImagesOutliveOtherPlans) {
  Executor executor({}, test_shaders());
  const auto run = [&](std::uint32_t base) {
    Plan plan;
    const ImageId ramp = plan.add_image({.name = "ramp", .extent = {5, 3}, .key = "ramp"});
    plan.add_pass({.shader = "ramp", .writes = {{"ramp_out", ramp}}, .grid = {5, 3}, .push_constants = {base}});
    const BufferId readback = plan.add_readback(ramp);
    return values_of<float>(executor.run(plan).contents(readback)).front();
  };
  EXPECT_EQ(run(7), 7.0F);
  for (int i = 0; i < 10; ++i) run_kept(executor, "", 1);
  EXPECT_EQ(run(8), 7.0F);
}

// What a later run finds by its contents stays, and with it what the last result shows.
TEST(Kept, TablesStayWherePicturesAreFreed) {
  Executor executor({}, test_shaders());
  constexpr std::size_t kCount = 16384;
  Plan plan;
  const BufferId kept = plan.add_buffer({.name = "numbers", .bytes = 4 * kCount, .key = "key"});
  const BufferId plain = plan.add_buffer({.name = "plain", .bytes = 4 * kCount});
  const BufferId copy = plan.add_buffer({.name = "copy", .bytes = 4 * kCount, .host_readable = true});
  const Extent grid{kCount, 1};
  plan.add_pass({.shader = "accumulate", .writes = {{"numbers", kept}}, .grid = grid, .push_constants = {5}});
  plan.add_pass({.shader = "copy_numbers", .reads = {{"source", kept}}, .writes = {{"target", plain}}, .grid = grid});
  plan.add_pass({.shader = "copy_numbers", .reads = {{"source", plain}}, .writes = {{"target", copy}}, .grid = grid});
  const RunResult result = executor.run(plan);
  const std::size_t before = executor.memory_use().bytes;
  executor.free_pictures(true);
  EXPECT_EQ(executor.memory_use().bytes + 4 * kCount, before) << "the plain buffer is gone";
  EXPECT_EQ(values_of<std::uint32_t>(result.contents(copy)), std::vector<std::uint32_t>(kCount, 5));
  executor.free_pictures(false);
  EXPECT_EQ(executor.memory_use().bytes, executor.memory_use().kept_bytes);
  EXPECT_EQ(run_kept(executor, "key", 7, kCount).passes, kCopyAlone);
  executor.free_pictures(false);
  EXPECT_EQ(executor.run(plan).passes.size(), 2U) << "made anew but for the kept one";
  // A result may lie where another plan's plain buffer was; it stays as well as the earlier result.
  Plan other;
  const BufferId eights = other.add_buffer({.name = "eights", .bytes = 4 * kCount, .host_readable = true});
  other.add_pass({.shader = "accumulate", .writes = {{"numbers", eights}}, .grid = grid, .push_constants = {8}});
  const RunResult swapped = executor.run(other);
  executor.free_pictures(true);
  EXPECT_EQ(executor.memory_use().bytes, executor.memory_use().kept_bytes + 2 * 4 * kCount);
  EXPECT_EQ(values_of<std::uint32_t>(swapped.contents(eights)), std::vector<std::uint32_t>(kCount, 8));
}

// The least recently used resource goes first. The current plan's resources stay, whatever the limit.
TEST(Kept, IsBounded) {
  constexpr std::size_t kCount = 16384;  // 64 KiB
  DeviceOptions options;
  options.kept_bytes_max = 3 * 4 * kCount;
  Executor executor(options, test_shaders());
  for (const char* key : {"a", "b", "c"}) run_kept(executor, key, 1, kCount);
  EXPECT_EQ(executor.memory_use().kept_bytes, options.kept_bytes_max);
  EXPECT_EQ(run_kept(executor, "a", 1, kCount).passes, kCopyAlone);
  EXPECT_EQ(run_kept(executor, "d", 1, kCount).passes, kBoth);  // b goes
  EXPECT_LE(executor.memory_use().kept_bytes, options.kept_bytes_max);
  EXPECT_EQ(run_kept(executor, "a", 1, kCount).passes, kCopyAlone);
  EXPECT_EQ(run_kept(executor, "c", 1, kCount).passes, kCopyAlone);
  EXPECT_EQ(run_kept(executor, "d", 1, kCount).passes, kCopyAlone);
  EXPECT_EQ(run_kept(executor, "b", 1, kCount).passes, kBoth);

  Plan plan;
  const auto size = static_cast<std::uint32_t>(kCount);
  std::vector<BufferId> all;
  for (const char* name : {"p", "q", "r", "s", "t"}) {
    all.push_back(plan.add_buffer({.name = name, .bytes = 4 * kCount, .host_readable = true, .key = name}));
    plan.add_pass(
        {.shader = "accumulate", .writes = {{"numbers", all.back()}}, .grid = {size, 1}, .push_constants = {2}});
  }
  const RunResult made = executor.run(plan);
  EXPECT_EQ(made.passes.size(), 5U);
  for (const BufferId id : all) {
    EXPECT_EQ(values_of<std::uint32_t>(made.contents(id)), std::vector<std::uint32_t>(kCount, 2));
  }
  EXPECT_EQ(executor.run(plan).passes.size(), 0U);
}

TEST(Kept, MayBeReadByAPlanThatDoesNotMakeIt) {
  Executor executor({}, test_shaders());
  Plan reader;
  const BufferId kept = reader.add_buffer({.name = "numbers", .bytes = 32, .key = "five"});
  const BufferId copy = reader.add_buffer({.name = "copy", .bytes = 32, .host_readable = true});
  reader.add_pass(
      {.shader = "copy_numbers", .reads = {{"source", kept}}, .writes = {{"target", copy}}, .grid = {8, 1}});
  EXPECT_EQ(message_of<std::logic_error>([&] { executor.run(reader); }),
            "pass copy_numbers reads buffer numbers, kept as \"five\", but nothing has made it so far");
  run_kept(executor, "five", 5);
  EXPECT_EQ(values_of<std::uint32_t>(executor.run(reader).contents(copy)), std::vector<std::uint32_t>(8, 5));
}

TEST(Kept, CarriedIsMadeAnew) {
  Executor executor({}, test_shaders());
  const auto make = [&](std::uint32_t amount) {
    Plan plan;
    const BufferId carried =
        plan.add_buffer({.name = "sum", .bytes = 32, .host_readable = true, .key = "sum", .carried = true});
    plan.add_pass(
        {.shader = "accumulate", .writes = {{"numbers", carried}}, .grid = {8, 1}, .push_constants = {amount}});
    return values_of<std::uint32_t>(executor.run(plan).contents(carried)).front();
  };
  EXPECT_EQ(make(5), 5U);
  EXPECT_EQ(make(6), 6U);
  Plan reader;
  const BufferId carried = reader.add_buffer({.name = "sum", .bytes = 32, .key = "sum", .carried = true});
  const BufferId copy = reader.add_buffer({.name = "copy", .bytes = 32, .host_readable = true});
  reader.add_pass(
      {.shader = "copy_numbers", .reads = {{"source", carried}}, .writes = {{"target", copy}}, .grid = {8, 1}});
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(values_of<std::uint32_t>(executor.run(reader).contents(copy)), std::vector<std::uint32_t>(8, 6));
  }
  // The host may make it.
  const auto fill = [&](std::uint32_t value) {
    Plan plan;
    const std::vector<std::uint32_t> numbers(8, value);
    const BufferId source =
        plan.add_buffer({.name = "sum", .bytes = 32, .contents = bytes_of(numbers), .key = "sum", .carried = true});
    const BufferId target = plan.add_buffer({.name = "copy", .bytes = 32, .host_readable = true});
    plan.add_pass(
        {.shader = "copy_numbers", .reads = {{"source", source}}, .writes = {{"target", target}}, .grid = {8, 1}});
    return values_of<std::uint32_t>(executor.run(plan).contents(target)).front();
  };
  EXPECT_EQ(fill(41), 41U);
  EXPECT_EQ(fill(42), 42U);
  EXPECT_EQ(values_of<std::uint32_t>(executor.run(reader).contents(copy)), std::vector<std::uint32_t>(8, 42));
}

// Contents that take long to compute are requested when a pass that reads them runs, and at no other time.
TEST(Kept, ContentsAreFoundWhenTheyAreNeeded) {
  Executor executor({}, test_shaders());
  int asked = 0;
  const auto plan_of = [&](const std::string& key, std::size_t count) {
    Plan plan;
    const BufferId found = plan.add_buffer({.name = "found", .bytes = 32, .contents_when_run = [&asked, count] {
                                              ++asked;
                                              return bytes_of(std::vector<std::uint32_t>(count, 7));
                                            }});
    const BufferId copy = plan.add_buffer({.name = "copy", .bytes = 32, .host_readable = true, .key = key});
    plan.add_pass(
        {.shader = "copy_numbers", .reads = {{"source", found}}, .writes = {{"target", copy}}, .grid = {8, 1}});
    return std::pair(plan, copy);
  };
  const auto [plan, copy] = plan_of("sevens", 8);
  check(plan);
  EXPECT_EQ(asked, 0);
  const std::vector<std::uint32_t> sevens(8, 7);
  EXPECT_EQ(values_of<std::uint32_t>(executor.run(plan).contents(copy)), sevens);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(values_of<std::uint32_t>(executor.run(plan).contents(copy)), sevens);
  EXPECT_EQ(asked, 1) << "what is made of them is kept";
  const Plan wrong = plan_of("", 7).first;
  EXPECT_EQ(message_of<std::logic_error>([&] { executor.run(wrong); }),
            "buffer found has 28 bytes of contents and is 32 long");
  EXPECT_EQ(run_kept(executor, "", 5).numbers, std::vector<std::uint32_t>(8, 5));
}

TEST(Kept, AFailedPlanLeavesNothingThatLooksMade) {
  Executor executor({}, test_shaders());
  Plan plan;
  const BufferId kept = plan.add_buffer({.name = "kept", .bytes = 32, .key = "five"});
  plan.add_pass({.shader = "accumulate", .writes = {{"numbers", kept}}, .grid = {8, 1}, .push_constants = {5}});
  const ImageId ramp = plan.add_image({.name = "ramp", .extent = {5, 3}, .key = "ramp"});
  plan.add_pass({.shader = "ramp", .writes = {{"ramp_out", ramp}}, .grid = {5, 3}, .push_constants = {5}});
  Plan failing = plan;
  const ImageId huge = failing.add_image({.name = "huge", .extent = {1U << 20, 1}});
  failing.add_pass({.shader = "ramp", .writes = {{"ramp_out", huge}}, .grid = {1, 1}, .push_constants = {1}});
  EXPECT_THROW(executor.run(failing), RunError);
  EXPECT_EQ(executor.run(plan).passes.size(), 2U);
  EXPECT_EQ(executor.run(plan).passes.size(), 0U);
  EXPECT_EQ(run_kept(executor, "five", 6).numbers, std::vector<std::uint32_t>(8, 5));
}

std::size_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  statm >> total >> resident;
  return resident * 4096;
}

// A sequence: the picture's plan and another one alternate, hundreds of times.
TEST(Executor, DoesNotGrowOverManyRuns) {
  Executor executor({}, test_shaders());
  const auto frame = [&](std::uint32_t i) {
    Plan plan;
    plan.scene_data = bytes_of(std::vector<float>(4, static_cast<float>(i)));
    const ImageId ramp = plan.add_image({.name = "ramp", .extent = {128, 128}});
    plan.add_pass({.shader = "ramp", .writes = {{"ramp_out", ramp}}, .grid = {128, 128}, .push_constants = {i}});
    const BufferId readback = plan.add_readback(ramp);
    EXPECT_EQ(values_of<float>(executor.run(plan).contents(readback)).front(), static_cast<float>(i));
    run_kept(executor, "", i, 4096);
  };
  for (std::uint32_t i = 0; i < 20; ++i) frame(i);
  const MemoryUse before = executor.memory_use();
  const std::size_t resident_before = resident_bytes();
  for (std::uint32_t i = 20; i < 220; ++i) frame(i);
  EXPECT_EQ(executor.memory_use().resources, before.resources);
  EXPECT_EQ(executor.memory_use().bytes, before.bytes);
  // Measured: 0.2 MiB. 400 runs that kept one 256 KiB image each would need 100. AddressSanitizer holds freed memory
  // back.
  if (!test::sanitized()) {
    EXPECT_LT(resident_bytes(), resident_before + (std::size_t{2} << 20));
  }
}

TEST(Executor, GivesBackWhatNoPlanUsesAnyMore) {
  Executor executor({}, test_shaders());
  run_kept(executor, "", 1, 1 << 20);
  const std::size_t large = executor.memory_use().bytes;
  EXPECT_GE(large, std::size_t{8} << 20);
  for (int i = 0; i < 6; ++i) run_kept(executor, "", 1, 8);
  EXPECT_LT(executor.memory_use().bytes, std::size_t{1} << 20);
}

struct StoredRun {
  bool made;
  float first;
};

// A ramp that starts at `base`, as a table that later executors may ask for.
StoredRun run_stored(const DeviceOptions& options, const std::string& key, std::uint32_t base, bool stored = true) {
  Executor executor(options, test_shaders());
  Plan plan;
  const ImageId ramp = plan.add_image({.name = "ramp", .extent = {5, 3}, .key = key, .stored = stored});
  plan.add_pass({.shader = "ramp", .writes = {{"ramp_out", ramp}}, .grid = {5, 3}, .push_constants = {base}});
  const BufferId readback = plan.add_readback(ramp);
  const RunResult result = executor.run(plan);
  const std::vector<float> values = values_of<float>(result.contents(readback));
  EXPECT_EQ(values.size(), 60U);
  EXPECT_EQ(values[4] - values[0], 1.0F) << "the whole of it comes back";
  return {!result.passes.empty(), values.front()};
}

TEST(Stored, TablesOutliveTheirExecutor) {
  ASSERT_NE(program_build(), "") << "linked without a build id";
  std::string name = (std::filesystem::temp_directory_path() / "airlight-tables-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  const DeviceOptions options{.cache_folder = folder, .stores_tables = true};
  const auto expect = [](const StoredRun& run, bool made, float first, const char* why) {
    EXPECT_EQ(run.made, made) << why;
    EXPECT_EQ(run.first, first) << why;
  };
  expect(run_stored(options, "plain", 7, false), true, 7.0F, "not to be stored");
  EXPECT_FALSE(std::filesystem::exists(folder / "tables"));
  expect(run_stored(options, "a", 7), true, 7.0F, "the first");
  // A caller must not use another ramp under the same key; here it shows that nothing was made.
  expect(run_stored(options, "a", 8), false, 7.0F, "the second");
  expect(run_stored(options, "b", 9), true, 9.0F, "another key");
  expect(run_stored({.teams = true, .cache_folder = folder, .stores_tables = true}, "a", 8), true, 8.0F,
         "passes that round otherwise");
  expect(run_stored({.cache_folder = folder}, "a", 6), true, 6.0F, "nobody asked for it");
  expect(run_stored({.cache_folder = "", .stores_tables = true}, "a", 5), true, 5.0F, "no folder");
  expect(run_stored(options, "a", 8), false, 7.0F, "none of these wrote over it");
  for (const auto& file : std::filesystem::directory_iterator(folder / "tables")) {
    std::fstream stream(file.path(), std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(100).put('x');
  }
  expect(run_stored(options, "a", 4), true, 4.0F, "a damaged file");
  expect(run_stored(options, "a", 3), false, 4.0F, "replaced");
  std::filesystem::remove_all(folder);
}

using Numbers = std::vector<std::uint32_t>;

// Numbers that later executors may ask for: 64 of `base`, to half of them one is added, then 32 zeros.
struct StoredNumbers {
  bool made;
  Numbers numbers;
};

StoredNumbers run_stored_buffer(const DeviceOptions& options, const std::string& key, std::uint32_t base,
                                std::uint32_t slice = 32) {
  constexpr std::size_t kCount = 96;
  Executor executor(options, test_shaders());
  Plan plan;
  const BufferId made = plan.add_buffer({.name = "made", .bytes = 4 * kCount, .stored = key, .slice = slice});
  const BufferId copy = plan.add_buffer({.name = "copy", .bytes = 4 * kCount, .host_readable = true});
  plan.add_pass({.shader = "accumulate", .writes = {{"numbers", made}}, .grid = {64, 1}, .push_constants = {base}});
  plan.add_pass({.shader = "accumulate", .writes = {{"numbers", made}}, .grid = {32, 1}, .push_constants = {1}});
  plan.add_pass({.shader = "copy_numbers", .reads = {{"source", made}}, .writes = {{"target", copy}}, .grid = {96, 1}});
  const RunResult result = executor.run(plan);
  return {result.passes.size() == 3, values_of<std::uint32_t>(result.contents(copy))};
}

Numbers numbers_from(std::uint32_t base) {
  Numbers numbers(32, base + 1);
  numbers.resize(64, base);
  numbers.resize(96, 0);
  return numbers;
}

TEST(Stored, BuffersOutliveTheirExecutorOnProcessors) {
  std::string name = (std::filesystem::temp_directory_path() / "airlight-buffers-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  const DeviceOptions options{.cache_folder = folder, .stores_tables = true};
  const auto expect = [](const StoredNumbers& run, bool made, std::uint32_t base, const char* why) {
    EXPECT_EQ(run.made, made) << why;
    EXPECT_EQ(run.numbers, numbers_from(base)) << why;
  };
  if (!Executor(options).device().is_cpu) {
    expect(run_stored_buffer(options, "a", 7), true, 7, "the first");
    expect(run_stored_buffer(options, "a", 8), true, 8, "no processor");
    EXPECT_FALSE(std::filesystem::exists(folder / "buffers"));
    std::filesystem::remove_all(folder);
    GTEST_SKIP() << "no processor";
  }
  const DeviceOptions as_a_gpu{.cache_folder = folder, .stores_tables = true, .stores_buffers = false};
  expect(run_stored_buffer(as_a_gpu, "a", 6), true, 6, "the first of no processor");
  EXPECT_FALSE(std::filesystem::exists(folder / "buffers"));
  expect(run_stored_buffer(options, "a", 7), true, 7, "the first");
  expect(run_stored_buffer(options, "a", 8), false, 7, "the second");
  expect(run_stored_buffer(options, "b", 9), true, 9, "another key");
  expect(run_stored_buffer(options, "a", 8, 96), true, 8, "slices as long as the whole");
  expect(run_stored_buffer(options, "a", 9, 96), false, 8, "the same");
  expect(run_stored_buffer(as_a_gpu, "a", 5), true, 5, "as no processor");
  expect(run_stored_buffer({.cache_folder = folder}, "a", 4), true, 4, "nobody asked for it");
  expect(run_stored_buffer(options, "a", 8), false, 7, "none of these wrote over it");
  EXPECT_FALSE(std::filesystem::exists(folder / "tables")) << "they push no table out";
  const auto each_file = [&folder](const auto& visit) {
    for (const auto& file : std::filesystem::directory_iterator(folder / "buffers")) visit(file.path());
  };
  each_file([](const auto& path) { std::filesystem::resize_file(path, std::filesystem::file_size(path) - 4); });
  expect(run_stored_buffer(options, "a", 3), true, 3, "a short file");
  each_file(
      [](const auto& path) { std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(84).put('x'); });
  expect(run_stored_buffer(options, "a", 4), true, 4, "a damaged file");
  expect(run_stored_buffer(options, "a", 3), false, 4, "replaced");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace airlight
