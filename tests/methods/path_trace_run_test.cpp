// Runs of path-trace: seeds, threads, checkpoints, stop rules, and the honesty of its standard error.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/base/error.h"
#include "core/methods/path_trace/checkpoint.h"
#include "path_trace_scene.h"

namespace airlight {
namespace {

class Checkpoint : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove(file_); }
  void TearDown() override { std::filesystem::remove(file_); }

  // The message of the InputError that a run with the checkpoint throws.
  std::string refusal(const Scene& scene) {
    try {
      trace(scene, View{}, {.checkpoint = file_});
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  std::string file_ =
      testing::TempDir() + "airlight-checkpoint-test-" + testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST(PathTraceRun, SameSeedSamePictureWhateverTheThreads) {
  const Scene scene = earth(10, 0.001, 0.3);
  const HostPicture one = trace(scene, View{}, {.threads = 1});
  const HostPicture five = trace(scene, View{}, {.threads = 5});
  EXPECT_EQ(one.radiance.rgba, five.radiance.rgba);
  EXPECT_EQ(one.standard_error.rgba, five.standard_error.rgba);
  EXPECT_EQ(one.samples, 64u);
  Scene other = scene;
  set(other, "seed", 2);
  EXPECT_NE(trace(other).radiance.rgba, one.radiance.rgba);
}

TEST_F(Checkpoint, ResumedRunIsBitwiseTheUninterruptedOne) {
  Scene scene = earth(10, 0.001, 0.3);
  set(scene, "samples", 400);
  const HostPicture whole = trace(scene);
  // Stopped by its listener again and again; a stop may fall anywhere.
  int stops = 0;
  HostPicture resumed;
  for (int limit = 1; limit < 200; ++limit) {
    int calls = 0;
    HostOptions options{.report = [&](double) { return ++calls < 2 + limit / 4; },
                        .checkpoint = file_,
                        .checkpoint_interval_s = 0.01,
                        .threads = 2};
    try {
      resumed = trace(scene, View{}, options);
    } catch (const RunError&) {
      ++stops;
      continue;
    }
    if (resumed.samples == whole.samples) {
      break;
    }
    ++stops;
  }
  EXPECT_GT(stops, 2);
  EXPECT_EQ(resumed.samples, 400u);
  EXPECT_EQ(resumed.radiance.rgba, whole.radiance.rgba);
  EXPECT_EQ(resumed.standard_error.rgba, whole.standard_error.rgba);
}

TEST_F(Checkpoint, MoreSamplesGoOnWhereFewerEnded) {
  Scene scene = earth(10, 0.001, 0.3);
  set(scene, "samples", 160);
  const HostPicture whole = trace(scene);
  set(scene, "samples", 48);
  trace(scene, View{}, {.checkpoint = file_});
  set(scene, "samples", 160);
  const HostPicture resumed = trace(scene, View{}, {.checkpoint = file_});
  EXPECT_EQ(resumed.radiance.rgba, whole.radiance.rgba);
}

TEST_F(Checkpoint, AnotherSceneIsRefusedByName) {
  Scene scene = earth(10, 0.001, 0.3);
  trace(scene, View{}, {.checkpoint = file_});
  scene.media[1].scattering[2] = 0.005;
  const std::string message = refusal(scene);
  EXPECT_NE(message.find(file_), std::string::npos) << message;
  EXPECT_NE(message.find("/media/1/scattering_per_km/2 0.005"), std::string::npos) << message;
  EXPECT_NE(message.find("0.0039"), std::string::npos) << message;
}

TEST_F(Checkpoint, SpheresOfAnotherMatterAreRefused) {
  Scene scene = earth(10, 0.001, 0.3);
  scene.spheres.push_back({.distance = 0.01, .radius = 0.001, .material = SphereMaterial::translucent});
  trace(scene, View{}, {.checkpoint = file_});
  scene.spheres[0].scatter_strength = 3.0;
  EXPECT_NE(refusal(scene).find("/scene/spheres/0/scatter_strength 3"), std::string::npos) << refusal(scene);
  scene.spheres[0].material = SphereMaterial::matte;
  EXPECT_NE(refusal(scene).find("/scene/spheres/0/material"), std::string::npos) << refusal(scene);
}

TEST_F(Checkpoint, NamesSpectraOfTheSunAndDisplayMayChange) {
  Scene scene = earth(10, 0.001, 0.3);
  const HostPicture first = trace(scene, View{}, {.checkpoint = file_});
  scene.name = "other";
  scene.sun.irradiance = {2.0, 2.0, 2.0};
  const HostPicture second = trace(scene, View{}, {.checkpoint = file_});
  EXPECT_FLOAT_EQ(second.radiance.at(3, 3)[0], 2.0f * first.radiance.at(3, 3)[0]);
}

TEST_F(Checkpoint, DamagedFilesAreRefused) {
  const Scene scene = earth(10, 0.001, 0.3);
  trace(scene, View{}, {.checkpoint = file_});
  std::ifstream in(file_, std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto with = [&](const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    return refusal(scene);
  };
  EXPECT_EQ(with(good), "accepted");
  EXPECT_NE(with(good.substr(0, good.size() - 1)).find("cut short"), std::string::npos);
  EXPECT_NE(with(good.substr(0, 200)).find("cut short"), std::string::npos);
  EXPECT_NE(with("").find("not a checkpoint"), std::string::npos);
  EXPECT_NE(with("{}").find("not a checkpoint"), std::string::npos);
  std::string flipped = good;
  flipped[flipped.size() - 100] = static_cast<char>(flipped[flipped.size() - 100] ^ 1);
  EXPECT_NE(with(flipped).find("damaged"), std::string::npos);
}

TEST_F(Checkpoint, AFolderThatDoesNotExistIsSaidBeforeTheFirstSample) {
  int reports = 0;
  HostOptions options{.report = [&](double) { return ++reports > 0; }, .checkpoint = file_ + "-no/such/file"};
  EXPECT_THROW(trace(earth(10, 0.001), View{}, options), RunError);
  EXPECT_EQ(reports, 0);
}

TEST_F(Checkpoint, NoTemporaryFileIsLeft) {
  trace(earth(10, 0.001), View{}, {.checkpoint = file_});
  for (const auto& entry : std::filesystem::directory_iterator(testing::TempDir())) {
    EXPECT_EQ(entry.path().string().find(file_ + ".part-"), std::string::npos) << entry.path();
  }
}

// The spread over seeds agrees with the standard error.
TEST(PathTraceRun, StandardErrorIsHonest) {
  Scene scene = earth(5, 0.5, 0.4);
  set(scene, "samples", 160);
  std::vector<Direction> directions;
  for (int k = 0; k < 12; ++k) {
    directions.push_back({radians(-30 + 10 * k), radians(29 * k)});
  }
  constexpr int kSeeds = 60;
  std::vector<double> sum(directions.size());
  std::vector<double> squares(directions.size());
  std::vector<double> claimed(directions.size());
  for (int seed = 0; seed < kSeeds; ++seed) {
    set(scene, "seed", seed);
    const HostPicture picture = trace(scene, directions);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double x = picture.radiance.at(static_cast<int>(k), 0)[1];
      sum[k] += x;
      squares[k] += x * x;
      claimed[k] += std::pow(picture.standard_error.at(static_cast<int>(k), 0)[1], 2) / kSeeds;
    }
  }
  double ratio = 0.0;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double variance = (squares[k] - sum[k] * sum[k] / kSeeds) / (kSeeds - 1);
    ratio += variance / claimed[k] / static_cast<double>(directions.size());
  }
  // A mean of 12 ratios of 59 degrees of freedom: deviation sqrt(2 / 59 / 12) = 0.053, and some more for heavy tails.
  EXPECT_NEAR(ratio, 1.0, 0.2);
}

TEST(PathTraceRun, StopsAtTheTargetError) {
  Scene scene = earth(40, 0.001, 0.3);
  set(scene, "target_error", 0.02);
  const HostPicture loose = trace(scene);
  set(scene, "target_error", 0.01);
  const HostPicture fine = trace(scene);
  EXPECT_GT(loose.samples, 16u);
  EXPECT_GT(fine.samples, 2 * loose.samples);
  EXPECT_LT(fine.samples, 10 * loose.samples);
}

TEST(PathTraceRun, StopsAtTheTimeLimitWithEveryPixelSampled) {
  Scene scene = earth(40, 0.001, 0.3);
  set(scene, "time_limit_s", 0.3);
  const HostPicture picture = trace(scene);
  EXPECT_GE(picture.samples, 32u);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      EXPECT_GT(picture.standard_error.at(x, y)[1], 0.0f);
    }
  }
}

TEST(PathTraceRun, SaysWhenStoppedBeforeThereIsAPicture) {
  Scene scene = earth(40, 0.001, 0.3);
  EXPECT_THROW(trace(scene, View{}, {.report = [](double) { return false; }}), RunError);
}

TEST(PathTraceRun, ReportsRisingFractionsUpToOne) {
  Scene scene = earth(40, 0.001, 0.3);
  set(scene, "samples", 800);
  double last = 0.0;
  int reports = 0;
  trace(scene, View{}, {.report = [&](double done) {
          EXPECT_GE(done, last - 1e-12);
          EXPECT_LE(done, 1.0);
          last = done;
          ++reports;
          return true;
        }});
  EXPECT_GT(reports, 3);
  EXPECT_GT(last, 0.8);
}

// A time limit that is over at once does not stop the first samples, and progress says so.
TEST(PathTraceRun, ReportsTheFirstSamplesWhateverTheTimeLimit) {
  Scene scene = earth(40, 0.001, 0.3);
  set(scene, "time_limit_s", 1e-9);
  std::vector<double> reports;
  const HostPicture picture = trace(scene, View{}, {.report = [&](double done) {
                                      reports.push_back(done);
                                      return true;
                                    }});
  ASSERT_FALSE(reports.empty());
  EXPECT_EQ(reports.front(), 0.0);
  ASSERT_EQ(picture.notes.size(), 1U);
  EXPECT_EQ(picture.notes.front().rfind("the time limit of 1e-09 s was passed: the first 32 samples", 0), 0U)
      << picture.notes.front();
}

TEST(PathTraceRun, RoundsSamplesUpToBatches) {
  Scene scene = earth(40, 0.001);
  set(scene, "samples", 33);
  EXPECT_EQ(trace(scene).samples, 48u);
  set(scene, "samples", 1);
  EXPECT_EQ(trace(scene).samples, 32u);
}

TEST(PathTraceRun, FisheyeIsTransparentOutsideItsCircle) {
  Scene scene = earth(40, 0.001);
  scene.camera.projection = Projection::fisheye;
  scene.camera.pitch = radians(90);
  scene.camera.vertical_fov = std::numbers::pi;
  scene.image = {9, 9};
  const HostPicture picture = trace(scene);
  EXPECT_EQ(picture.radiance.at(0, 0)[3], 0.0f);
  EXPECT_EQ(picture.radiance.at(0, 0)[2], 0.0f);
  EXPECT_EQ(picture.radiance.at(4, 4)[3], 1.0f);
  EXPECT_GT(picture.radiance.at(4, 4)[2], 0.0f);
}

}  // namespace
}  // namespace airlight
