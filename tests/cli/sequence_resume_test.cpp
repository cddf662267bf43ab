// A sequence that is stopped, killed, resumed, shared among processes, or on a full disk: every frame is whole.
#include <algorithm>
#include <csignal>
#include <thread>

#include "tests/cli/sequence_fixture.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class SequenceResume : public Sequence {};

TEST_F(SequenceResume, ASecondRunKeepsWhatIsWholeAndOfThePreset) {
  const Names words = morning({"-o", "s.#.exr", "--png", "s.#.png", "--json"});
  const Outcome first = tool(words);
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.err, "");
  EXPECT_EQ(statuses(first.out), Names(6, "rendered"));
  const Json before = Json::parse(scratch_.read("s.manifest.json"));
  const Outcome second = tool(words);
  EXPECT_EQ(statuses(second.out), Names(6, "kept"));
  EXPECT_EQ(Json::parse(scratch_.read("s.manifest.json")), before);  // milliseconds of the first run included
  // Cut short, of another kind, missing, of another preset.
  scratch_.write("s.2.exr", scratch_.read("s.2.exr").substr(0, scratch_.read("s.2.exr").size() - 1));
  scratch_.write("s.3.png", scratch_.read("s.3.png").substr(0, 200));
  fs::remove(scratch_.path() / "s.4.png");
  fs::copy_file(scratch_.path() / "s.6.exr", scratch_.path() / "s.5.exr", fs::copy_options::overwrite_existing);
  EXPECT_EQ(statuses(tool(words).out), (Names{"kept", "rendered", "rendered", "rendered", "rendered", "kept"}));
  EXPECT_EQ(statuses(tool(words).out), Names(6, "kept"));
  // Options that give other files, each with a hash of its own.
  EXPECT_EQ(statuses(tool(morning({"--png", "s.#.png", "--json", "--bits", "16"})).out), Names(6, "rendered"));
  EXPECT_EQ(statuses(tool(morning({"-o", "s.#.exr", "--json"})).out), Names(6, "kept"));
  EXPECT_EQ(statuses(tool(morning({"-o", "s.#.exr", "--json", "--float"})).out), Names(6, "rendered"));
  EXPECT_EQ(statuses(tool(morning({"-o", "s.#.exr", "--json", "--float", "--overwrite"})).out), Names(6, "rendered"));
  EXPECT_EQ(statuses(tool(morning({"-o", "s.#.exr", "--json", "--set", "/camera/pitch_deg=11"})).out),
            Names(6, "rendered"));
}

TEST_F(SequenceResume, KilledAndResumedIsTheSameAsUninterrupted) {
  make_folder("whole");
  make_folder("killed");
  Names words = morning({"-q", "-o", "whole/s.#.exr", "--png", "whole/s.#.png", "--size", "192x108"});
  ASSERT_EQ(tool(words).exit_code, 0);
  const auto whole = pictures("whole");
  ASSERT_EQ(whole.size(), 12U);
  words = morning({"-q", "-o", "killed/s.#.exr", "--png", "killed/s.#.png", "--size", "192x108"});
  int killed = 0;
  for (const char* at : {".part-", "s.2.exr", "s.4.png"}) {
    Start start;
    start.kill_signal = SIGKILL;
    start.kill_at_file = at;
    Names in_folder = {"bash", "-c", "cd .. && exec \"$@\"", "-", tool_program()};  // where the file is watched for
    in_folder.insert(in_folder.end(), words.begin(), words.end());
    const Outcome outcome = run(scratch_.path() / "killed", in_folder, start);
    killed += outcome.signal == SIGKILL ? 1 : 0;
    for (const auto& [name, text] : pictures("killed")) {
      EXPECT_TRUE(contains(name, ".part-") || whole.at(name) == text) << name;
    }
  }
  EXPECT_GT(killed, 0) << "no run was slow enough to be killed";
  const Outcome last = tool(words);
  EXPECT_EQ(last.exit_code, 0) << last.err;
  // Half-written files of the kills are gone too. Empty ones stay: they may be a moment old and another run's.
  auto resumed = pictures("killed");
  std::erase_if(resumed, [](const auto& file) { return contains(file.first, ".part-") && file.second.empty(); });
  EXPECT_EQ(resumed, whole);
  EXPECT_EQ(Json::parse(scratch_.read("killed/s.manifest.json"))["frames"].size(), 6U);
}

// The frame in work is finished, the manifest lists what there is, and the same command continues.
TEST_F(SequenceResume, StoppedBySignalsItLeavesWholeFramesAndSaysSo) {
  Names words = morning({"-o", "s.#.exr", "--size", "192x108"});
  words[9] = "1m";  // --step
  int stopped = 0;
  for (const int signal : {SIGINT, SIGTERM}) {
    Start start;
    start.kill_signal = signal;
    start.kill_at_file = signal == SIGINT ? "s.1.exr" : "s.9.exr";
    const Outcome outcome = tool(words, start);
    const Json manifest = Json::parse(scratch_.read("s.manifest.json"));
    if (outcome.exit_code == 0 || manifest["complete"] == true) {
      continue;  // over before the signal came
    }
    ++stopped;
    EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.err;
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_TRUE(contains(outcome.err, "frames are whole; the same command goes on from there")) << outcome.err;
    EXPECT_EQ(manifest["complete"], false);
    std::size_t frames = 0;
    for (const std::string& name : scratch_.files()) {
      EXPECT_FALSE(contains(name, ".part-")) << name;
      frames += name.ends_with(".exr") ? 1U : 0U;
    }
    EXPECT_EQ(manifest["frames"].size(), frames);
    fs::remove(scratch_.path() / "s.9.exr");
  }
  EXPECT_GT(stopped, 0);
}

// Before a frame of path-trace has its first samples too.
TEST_F(SequenceResume, StoppedWhileItSamplesItSaysSo) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Start start;
    start.kill_signal = signal;
    start.kill_at_file = signal == SIGINT ? "a.1.exr" : "b.1.exr";
    const Outcome outcome = tool({"sequence", "sky.json", "--method", "path-trace", "--size", "320x180", "--samples",
                                  "1", "--sun-elevation", "10:12:1", "-o", signal == SIGINT ? "a.#.exr" : "b.#.exr"},
                                 start);
    EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "of 3 frames are whole; the same command goes on from there")) << outcome.err;
  }
}

TEST_F(SequenceResume, ShardsAreTheWhole) {
  make_folder("whole");
  make_folder("shards");
  ASSERT_EQ(tool(morning({"-q", "-o", "whole/s.#.exr"})).exit_code, 0);
  for (const char* shard : {"1/4", "2/4", "3/4", "4/4"}) {
    const Outcome outcome = tool(morning({"-q", "-o", "shards/s.#.exr", "--shard", shard}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_EQ(pictures("shards"), pictures("whole"));
  EXPECT_EQ(Json::parse(scratch_.read("shards/s.manifest.2-of-4.json"))["frames"].size(), 2U);
  // More machines than frames: a shard without work does not fail.
  EXPECT_EQ(tool(morning({"-q", "-o", "shards/s.#.exr", "--shard", "9/9"})).exit_code, 0);
  // One more run without --shard finds all of it.
  EXPECT_EQ(statuses(tool(morning({"-o", "shards/s.#.exr", "--json"})).out), Names(6, "kept"));
}

TEST_F(SequenceResume, TwoRunsOnOneFolderLeaveWholeFrames) {
  make_folder("whole");
  make_folder("both");
  ASSERT_EQ(tool(morning({"-q", "-o", "whole/s.#.exr"})).exit_code, 0);
  Outcome outcomes[2];
  std::thread other([&] { outcomes[1] = tool(morning({"-q", "-o", "both/s.#.exr"})); });
  outcomes[0] = tool(morning({"-q", "-o", "both/s.#.exr"}));
  other.join();
  for (const Outcome& outcome : outcomes) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_EQ(pictures("both"), pictures("whole"));
  EXPECT_EQ(Json::parse(scratch_.read("both/s.manifest.json"))["complete"], true);
}

// Early frames are small, later ones are not.
TEST_F(SequenceResume, AFullDiskKeepsTheFramesBefore) {
  if (mount_privately().empty()) GTEST_SKIP() << "may not mount";
  std::string preset = small_preset();
  preset.insert(preset.rfind('}'), R"(, "sequence": {"frames": [{"at": 1, "/image/width": 16}, {"at": 6,
      "/image/width": 2048}]})");
  scratch_.write("keys.json", preset);
  const Outcome outcome =
      airlight_on_a_small_disk(scratch_.path(), "256k", {"sequence", "keys.json", "-q", "-o", "s.#.exr", "--float"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "No space left on device")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "of 6 frames are whole")) << outcome.err;
  int whole = 0;
  for (const std::string& name : scratch_.files()) {
    EXPECT_FALSE(contains(name, ".part-")) << name;
    if (name.ends_with(".exr")) {
      ++whole;
      EXPECT_EQ(tool({"diff", name, name}).exit_code, 0) << name;
    }
  }
  EXPECT_GT(whole, 0);
  EXPECT_LT(whole, 6);
}

}  // namespace
}  // namespace airlight::test
