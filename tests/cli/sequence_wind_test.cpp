// Clouds that wind moves through a sequence.
#include "tests/cli/sequence_fixture.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

class SequenceWind : public Sequence {
 protected:
  void SetUp() override {
    Sequence::SetUp();
    Json preset = Json::parse(small_preset());
    preset["clouds"] = {{{"type", "layer"}, {"optical_depth", 0.01}},
                        {{"type", "cumulus"},
                         {"cover", 0.5},
                         {"period_km", 4},
                         {"detail_m", 250},
                         {"east_km", 1},
                         {"wind_m_s", {10, -5}}}};
    preset["render"]["method"] = "orders";
    scratch_.write("sky.json", preset.dump());
  }
  static Names windy(const Names& more) { return morning(more); }
};

// A frame is the same to the bit in a run of all, in a shard, in a run that goes on, and rendered from itself.
TEST_F(SequenceWind, AFrameIsTheSameHoweverItIsRendered) {
  for (const char* folder : {"whole", "shards", "resumed"}) {
    make_folder(folder);
  }
  ASSERT_EQ(tool(windy({"-q", "--float", "-o", "whole/s.#.exr"})).exit_code, 0);
  const auto whole = pictures("whole");
  ASSERT_EQ(whole.size(), 6U);
  for (const char* shard : {"2/2", "1/2"}) {
    ASSERT_EQ(tool(windy({"-q", "--float", "-o", "shards/s.#.exr", "--shard", shard})).exit_code, 0);
  }
  EXPECT_EQ(pictures("shards"), whole);
  scratch_.write("resumed/s.2.exr", whole.at("s.2.exr"));
  scratch_.write("resumed/s.3.exr", whole.at("s.3.exr"));
  EXPECT_EQ(statuses(tool(windy({"--json", "--float", "-o", "resumed/s.#.exr"})).out),
            (Names{"rendered", "kept", "kept", "rendered", "rendered", "rendered"}));
  EXPECT_EQ(pictures("resumed"), whole);
  ASSERT_EQ(tool({"render", "whole/s.4.exr", "-q", "--float", "-o", "alone.exr"}).exit_code, 0);
  EXPECT_EQ(tool({"diff", "whole/s.4.exr", "alone.exr", "--fail", "0"}).exit_code, 0);
  // The wind is what moves it: without, another picture.
  ASSERT_EQ(
      tool({"render", "whole/s.4.exr", "-q", "--float", "-o", "still.exr", "--set", "/clouds/0/east_km=1"}).exit_code,
      0);
  EXPECT_NE(tool({"diff", "whole/s.4.exr", "still.exr", "--fail", "0"}).exit_code, 0);
}

// The cloud's number counts layers too, as in the preset. 5 m/s to the south over half an hour are 9 km, or one of a
// field of 4 km.
TEST_F(SequenceWind, IsListed) {
  const Outcome outcome = tool(windy({"--dry-run", "--json", "-o", "s.#.exr", "--set", "/clouds/1/east_km=2"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<std::string> lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(Json::parse(lines[0])["keys"]["/clouds/1/east_km"], 2.0);
  EXPECT_EQ(Json::parse(lines[0])["keys"]["/clouds/1/north_km"], 0.0);
  EXPECT_EQ(Json::parse(lines[1])["keys"]["/clouds/1/east_km"], 0.0 + 4.0);
  EXPECT_EQ(Json::parse(lines[1])["keys"]["/clouds/1/north_km"], -1.0);
}

TEST_F(SequenceWind, NeedsTime) {
  const Outcome sweep = tool({"sequence", "sky.json", "-o", "s.#.exr", "--sun-elevation", "3:4:1"});
  EXPECT_EQ(sweep.exit_code, 2);
  EXPECT_EQ(sweep.err,
            "airlight: sequence: clouds[1].wind_m_s: wind moves a cloud with the time of the frames, and a "
            "sweep has none; give a sun path (--date, --from, --to, --step, --lat, --lon), or --set "
            "/clouds/1/wind_m_s=[0,0]\n");
  const Outcome still = tool({"sequence", "sky.json", "-q", "--png", "s.#.png", "--sun-elevation", "3:4:1", "--set",
                              "/clouds/1/wind_m_s=[0,0]"});
  EXPECT_EQ(still.exit_code, 0) << still.err;
}

TEST_F(SequenceWind, DoesNotCarryACloudOutOfReach) {
  const Outcome outcome = tool(windy({"-o", "s.#.exr", "--set", "/clouds/1/east_km=-999"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err,
                       "sequence: clouds[1].wind_m_s: the wind of 10 m/s takes the cloud 1001 km east or "
                       "west of the camera"))
      << outcome.err;
}

}  // namespace
}  // namespace airlight::test
