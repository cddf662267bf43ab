// The order of passes and the places of barriers, and passes that kept resources make unnecessary.

#include <gtest/gtest.h>

#include <set>

#include "core/plan/plan.h"

namespace airlight {
namespace {

using Flags = std::vector<bool>;

// Buffers named by letters; a pass is written as its reads and its writes.
class Letters {
 public:
  // "K" is kept, "h" is read by the host, "C" is carried; the others live for one run.
  explicit Letters(const std::string& letters) {
    for (const char letter : letters) {
      BufferDesc desc{.name = std::string(1, letter), .bytes = 4};
      if (letter == 'K' || letter == 'L') desc.key = desc.name;
      if (letter == 'C') desc.key = "carried";
      desc.carried = letter == 'C';
      desc.host_readable = letter == 'h';
      plan_.add_buffer(desc);
    }
    letters_ = letters;
  }

  Letters& pass(const std::string& reads, const std::string& writes) {
    PassDesc pass{.shader = "any", .grid = {1, 1}};
    for (const char letter : reads) pass.reads.push_back({std::string(1, letter), id(letter)});
    for (const char letter : writes) pass.writes.push_back({std::string(1, letter), id(letter)});
    plan_.add_pass(pass);
    return *this;
  }

  Flags runs_with(const std::string& kept) const {
    std::set<ResourceId> ids;
    for (const char letter : kept) ids.insert(id(letter));
    return passes_to_run(plan_, [&](ResourceId resource) { return ids.contains(resource); });
  }

  const Plan& plan() const { return plan_; }

 private:
  BufferId id(char letter) const { return {static_cast<std::uint32_t>(letters_.find(letter))}; }

  std::string letters_;
  Plan plan_;
};

// Numbers of the passes that run in the order in which they do, with a bar for a barrier.
std::string order(const Plan& plan, Flags runs = {}) {
  runs.resize(plan.passes().size(), runs.empty());
  std::string text;
  for (const Scheduled& next : schedule(plan, runs)) text += (next.barrier ? "|" : "") + std::to_string(next.pass);
  return text;
}

TEST(Schedule, ReadsAfterWrites) {
  EXPECT_EQ(order(Letters("ab").pass("", "a").pass("a", "b").plan()), "0|1");
}

TEST(Schedule, WritesAfterReads) {
  EXPECT_EQ(order(Letters("abc").pass("", "a").pass("a", "b").pass("", "a").plan()), "0|1|2");
}

TEST(Schedule, WritesAfterWrites) {
  EXPECT_EQ(order(Letters("a").pass("", "a").pass("", "a").plan()), "0|1");
}

TEST(Schedule, HasStrangersAndReadersAtOnce) {
  EXPECT_EQ(order(Letters("ab").pass("", "a").pass("", "b").plan()), "01");
  EXPECT_EQ(order(Letters("abc").pass("", "a").pass("a", "b").pass("a", "c").plan()), "0|12");
  EXPECT_EQ(order(Letters("abcd").pass("", "a").pass("", "b").pass("a", "c").pass("b", "d").plan()), "01|23");
}

TEST(Schedule, HasAPassNextToWhatItsReaderAlsoWaitsFor) {
  EXPECT_EQ(order(Letters("abch").pass("", "a").pass("", "b").pass("b", "c").pass("ac", "h").plan()), "1|02|3");
  // Not so late that what it writes over is still read, or what it reads is gone.
  EXPECT_EQ(order(Letters("abch").pass("", "a").pass("a", "b").pass("", "a").pass("ab", "h").plan()), "0|1|2|3");
}

TEST(Schedule, AnImageAndABufferOfOneIndexAreNotTheSame) {
  Plan plan;
  const ImageId image = plan.add_image({.name = "image"});
  const BufferId buffer = plan.add_buffer({.name = "buffer", .bytes = 4});
  ASSERT_EQ(image.index, buffer.index);
  plan.add_pass({.shader = "one", .writes = {{"out", image}}, .grid = {1, 1}});
  plan.add_pass({.shader = "two", .writes = {{"out", buffer}}, .grid = {1, 1}});
  EXPECT_EQ(order(plan), "01");
}

TEST(Schedule, PassesOfOtherPartsDoNotWait) {
  Plan plan;
  const BufferId list = plan.add_buffer({.name = "list", .bytes = 4});
  const BufferId seen = plan.add_buffer({.name = "seen", .bytes = 4});
  const auto add = [&](const char* name, std::vector<Binding> reads, std::vector<Binding> writes) {
    plan.add_pass(
        {.name = name, .shader = "any", .reads = std::move(reads), .writes = std::move(writes), .grid = {1, 1}});
  };
  add("one", {}, {{"list", list, 1U}});
  add("other", {}, {{"list", list, 2U}});
  add("of one", {{"list", list, 1U}}, {{"seen", seen, 1U}});
  add("more of one", {}, {{"list", list, 1U}});
  add("of other", {{"list", list, 2U}}, {{"seen", seen, 2U}});
  add("all", {{"seen", seen}}, {{"list", list}});
  EXPECT_EQ(order(plan), "0|12|34|5");
}

TEST(Schedule, PassesThatDoNotRunTouchNothing) {
  const Letters letters = Letters("abc").pass("", "a").pass("a", "b").pass("a", "c");
  EXPECT_EQ(order(letters.plan(), {true, false, true}), "0|2");
  EXPECT_EQ(order(letters.plan(), {false, true, true}), "12");
}

TEST(Kept, AllRunWhileNothingIsThere) {
  EXPECT_EQ(Letters("Kh").pass("", "K").pass("K", "h").runs_with(""), (Flags{true, true}));
}

TEST(Kept, ItsProducerIsSpared) {
  EXPECT_EQ(Letters("Kh").pass("", "K").pass("K", "h").runs_with("K"), (Flags{false, true}));
}

TEST(Kept, APassWithAnotherOutputRuns) {
  EXPECT_EQ(Letters("Kah").pass("", "Ka").pass("Ka", "h").runs_with("K"), (Flags{true, true}));
}

TEST(Kept, StepsThatLeadOnlyToItAreSpared) {
  EXPECT_EQ(Letters("abKh").pass("", "a").pass("a", "b").pass("b", "K").pass("K", "h").runs_with("K"),
            (Flags{false, false, false, true}));
}

TEST(Kept, AStepThatSomeoneElseReadsRuns) {
  EXPECT_EQ(Letters("aKh").pass("", "a").pass("a", "K").pass("aK", "h").runs_with("K"), (Flags{true, false, true}));
}

TEST(Kept, WhatTheHostReadsIsMade) {
  EXPECT_EQ(Letters("hK").pass("", "h").pass("h", "K").runs_with("K"), (Flags{true, false}));
  Plan plan;
  const ImageId image = plan.add_image({.name = "image"});
  const BufferId kept = plan.add_buffer({.name = "kept", .bytes = 4, .key = "kept"});
  plan.add_pass({.shader = "one", .writes = {{"out", image}}, .grid = {1, 1}});
  plan.add_pass({.shader = "two", .reads = {{"in", image}}, .writes = {{"out", kept}}, .grid = {1, 1}});
  const auto all_kept = [](ResourceId) { return true; };
  EXPECT_EQ(passes_to_run(plan, all_kept), (Flags{false, false}));
  plan.add_readback(image);
  EXPECT_EQ(passes_to_run(plan, all_kept), (Flags{true, false}));
}

TEST(Kept, APassWithoutReadersRuns) {
  EXPECT_EQ(Letters("a").pass("", "a").runs_with(""), (Flags{true}));
}

// What a file holds is made no more than what memory holds.
TEST(Kept, AStoredBufferIsThere) {
  Plan plan;
  const BufferId step = plan.add_buffer({.name = "step", .bytes = 4});
  const BufferId stored = plan.add_buffer({.name = "stored", .bytes = 4, .stored = "stored"});
  const BufferId told = plan.add_buffer({.name = "told", .bytes = 4, .host_readable = true});
  plan.add_pass({.shader = "one", .writes = {{"out", step}}, .grid = {1, 1}});
  plan.add_pass({.shader = "two", .reads = {{"in", step}}, .writes = {{"out", stored}}, .grid = {1, 1}});
  plan.add_pass({.shader = "three", .reads = {{"in", stored}}, .writes = {{"out", told}}, .grid = {1, 1}});
  EXPECT_EQ(passes_to_run(plan, [](ResourceId) { return true; }), (Flags{false, false, true}));
  EXPECT_EQ(passes_to_run(plan, [](ResourceId) { return false; }), (Flags{true, true, true}));
}

// Sums that some pass may want, beside those that lead to something kept.
TEST(Kept, ScratchMakesNoPassRun) {
  Plan plan;
  const BufferId sums = plan.add_buffer({.name = "sums", .bytes = 4, .scratch = true});
  const BufferId step = plan.add_buffer({.name = "step", .bytes = 4});
  const BufferId kept = plan.add_buffer({.name = "kept", .bytes = 4, .key = "kept"});
  plan.add_pass({.shader = "one", .writes = {{"out", step}, {"sums", sums}}, .grid = {1, 1}});
  plan.add_pass({.shader = "two", .reads = {{"in", step}}, .writes = {{"out", kept}}, .grid = {1, 1}});
  EXPECT_EQ(passes_to_run(plan, [](ResourceId) { return true; }), (Flags{false, false}));
  EXPECT_EQ(passes_to_run(plan, [](ResourceId) { return false; }), (Flags{true, true}));
  const BufferId told = plan.add_buffer({.name = "told", .bytes = 4, .host_readable = true});
  plan.add_pass({.shader = "three", .reads = {{"in", sums}}, .writes = {{"out", told}}, .grid = {1, 1}});
  EXPECT_EQ(passes_to_run(plan, [](ResourceId) { return true; }), (Flags{true, false, true}));
}

TEST(Kept, WrittenAgainItIsMadeFromTheStart) {
  // The second pass adds to K and must run for h: K's first writer has to run as well, or the pass would add to K
  // twice.
  EXPECT_EQ(Letters("Kh").pass("", "K").pass("", "Kh").runs_with("K"), (Flags{true, true}));
  // So must a pass whose result only that first writer reads.
  EXPECT_EQ(Letters("aKh").pass("", "a").pass("a", "K").pass("", "Kh").runs_with("K"), (Flags{true, true, true}));
  // Two passes that only make K are both skipped.
  EXPECT_EQ(Letters("Kh").pass("", "K").pass("", "K").pass("K", "h").runs_with("K"), (Flags{false, false, true}));
}

TEST(Kept, CarriedIsMadeByEveryPlanThatCan) {
  EXPECT_EQ(Letters("C").pass("", "C").runs_with("C"), (Flags{true}));
  EXPECT_EQ(Letters("CK").pass("", "C").pass("C", "K").runs_with("CK"), (Flags{true, false}));
}

}  // namespace
}  // namespace airlight
