// --tile and --layers in use: files, refusals, leftovers.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

using Json = nlohmann::json;

class Tiles : public SmallSky {
 protected:
  void expect_refusal(const Names& arguments, const std::string& part) const {
    const Outcome outcome = tool(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part)) << outcome.err;
    EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
  }
};

TEST_F(Tiles, TheFileIsTheSameByteForByte) {
  const Names base = {"render", "sky.json", "-q", "--size", "75x41", "--layers"};
  const auto with = [&](const Names& more) {
    Names words = base;
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  with({"-o", "whole.exr"});
  EXPECT_EQ(Json::parse(with({"-o", "rows.exr", "--tile", "75x16", "--json"}))["tile"],
            (Json{{"width", 75}, {"height", 16}}));
  with({"-o", "odd.exr", "--tile", "19x7"});
  EXPECT_EQ(scratch_.read("rows.exr"), scratch_.read("whole.exr"));
  EXPECT_EQ(scratch_.read("odd.exr"), scratch_.read("whole.exr"));
  with({"-o", "whole32.exr", "--float"});
  with({"-o", "odd32.exr", "--float", "--tile", "19x7"});
  EXPECT_EQ(scratch_.read("odd32.exr"), scratch_.read("whole32.exr"));
  with({"stokes", "-o", "stokes.exr", "--set", "/render/tabulate=\"always\""});
  with({"stokes", "-o", "odd-stokes.exr", "--set", "/render/tabulate=\"always\"", "--tile", "19x7"});
  EXPECT_EQ(scratch_.read("odd-stokes.exr"), scratch_.read("stokes.exr"));
  for (const char* part : {"Q.R", "U.B", "airlight:stokes"}) {
    EXPECT_TRUE(contains(scratch_.read("stokes.exr"), part)) << part;
    EXPECT_FALSE(contains(scratch_.read("whole.exr"), part)) << part;
  }
}

// Every output of a render, as a whole and in tiles that divide nothing evenly.
TEST_F(Tiles, EveryOutputIsTheSameByteForByte) {
  const Names disc = {"--set", "/sun/disc/angular_radius_deg=2"};
  const std::vector<Names> wishes = {
      {"--size", "31x23", "-o", "a.exr", "--png", "a.png", "--set", "/bloom/enabled=true", "--irradiance", "light.exr",
       "--luts", "tables"},
      {"--size", "31x23", "--png", "a.png", "--view", "gpu", "--bits", "16"},
      {"--size", "31x23", "--png", "a.png", "--view", "diagnostic"},
      {"--size", "13x11", "-o", "a.exr", "--png", "a.png", "--method", "path-trace", "--samples", "2"},
      {"--size", "7x42", "--set", "/camera/projection=cube", "--set", "/camera/pitch_deg=0", "-o", "a.exr", "--png",
       "a.png", "--cube-faces", "--layers"}};
  for (const Names& wish : wishes) {
    Names base = {"render", "../sky.json", "-q"};
    base.insert(base.end(), disc.begin(), disc.end());
    base.insert(base.end(), wish.begin(), wish.end());
    std::map<std::string, std::map<std::string, std::string>> made;
    for (const std::string tile : {"whole", "11x4"}) {
      const Scratch folder;
      folder.write("sky.json", small_preset());
      std::filesystem::create_directory(folder.path() / "out");
      Names words = base;
      if (tile != "whole") {
        words.insert(words.end(), {"--tile", tile});
      }
      const Outcome outcome = airlight(folder.path() / "out", words);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      for (const std::string& name : folder.files()) {
        made[tile][name] = folder.read(name);
      }
    }
    EXPECT_GT(made["whole"].size(), 1U);
    EXPECT_TRUE(made["11x4"] == made["whole"]) << testing::PrintToString(wish);
  }
}

TEST_F(Tiles, FramesOfASequenceAreTheSameByteForByte) {
  for (const std::string folder : {"whole", "tiles"}) {
    std::filesystem::create_directory(scratch_.path() / folder);
    Names words = {"sequence",          "sky.json",        "-q",      "-o", folder + "/f.#.exr", "--png",
                   folder + "/f.#.png", "--sun-elevation", "10:20:10"};
    if (folder == "tiles") {
      words.insert(words.end(), {"--tile", "9x5"});
    }
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(scratch_.read(folder + "/f.manifest.json"), "\"complete\":true"));
  }
  for (const std::string name : {"/f.1.exr", "/f.2.exr", "/f.1.png", "/f.2.png"}) {
    EXPECT_FALSE(scratch_.read("whole" + name).empty());
    EXPECT_TRUE(scratch_.read("tiles" + name) == scratch_.read("whole" + name)) << name;
  }
  const Outcome again = tool({"sequence", "sky.json", "-o", "whole/f.#.exr", "--png", "whole/f.#.png",
                              "--sun-elevation", "10:20:10", "--tile", "4x4"});
  EXPECT_TRUE(contains(again.err, "0 frames rendered, 2 kept")) << again.err;
}

// A PNG is written forward and may go through a pipe; an EXR has its table of offsets at the beginning.
TEST_F(Tiles, APngInTilesGoesThroughAPipe) {
  const Outcome outcome = shell(
      "airlight render sky.json -q --png a.png && "
      "airlight render sky.json -q --tile 8x3 --png /dev/stdout | cat > b.png");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_FALSE(scratch_.read("a.png").empty());
  EXPECT_TRUE(scratch_.read("b.png") == scratch_.read("a.png"));
}

TEST_F(Tiles, WhatIsNoTileIsRefusedInOneLine) {
  expect_refusal({"render", "sky.json", "-o", "a.exr", "--tile", "8"}, "'8' is no size");
  expect_refusal({"render", "sky.json", "-o", "a.exr", "--tile", "0x8"}, "'0x8' is no size");
  expect_refusal({"render", "sky.json", "-o", "a.exr", "--size", "9000x9000", "--tile", "9000x9000"}, "8388608 pixels");
  expect_refusal({"render", "sky.json", "--tile", "8x8", "-o", "/dev/null"}, "a file in which one can go back");
  expect_refusal({"sequence", "sky.json", "-o", "f.#.exr", "--sun-elevation", "1:2:1", "--tile", "x"},
                 "sequence: --tile: 'x' is no size");
}

TEST_F(Tiles, ADiskThatFillsUpLeavesNothing) {
  if (mount_privately().empty()) GTEST_SKIP() << "may not mount";
  const Outcome outcome =
      airlight_on_a_small_disk(scratch_.path(), "100k",
                               {"render", "sky.json", "--float", "-o", "a.exr", "--size", "512x256", "--tile", "512x32",
                                "--set", "/camera/projection=equirectangular", "--set", "/camera/pitch_deg=0"});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "a.exr: cannot write: No space left on device")) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

TEST_F(Tiles, AnEndInTheMiddleLeavesNoHalfFile) {
  Start start;
  start.kill_signal = SIGTERM;
  start.kill_at_file = ".part-";
  const Outcome outcome = tool({"render", "sky.json", "-o", "a.exr", "--size", "4096x2048", "--tile", "4096x8"}, start);
  EXPECT_EQ(outcome.signal, SIGTERM) << outcome.err;
  EXPECT_EQ(scratch_.files(), (Names{"sky.json"}));
}

TEST_F(Tiles, LayersAreNamedAndCompared) {
  const Outcome made = tool({"render", "sky.json", "-o", "a.exr", "--layers", "--json", "--size", "64x36"});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  const Json layers = Json::parse(made.out)["layers"];
  EXPECT_EQ(layers.back(), "N");
  EXPECT_EQ(tool({"render", "a.exr", "-o", "again.exr", "--layers", "-q"}).exit_code, 0);
  EXPECT_EQ(scratch_.read("again.exr"), scratch_.read("a.exr"));
  for (const Json& layer : layers) {
    const Outcome same = tool({"diff", "a.exr", "again.exr", "--layer", layer.get<std::string>(), "--rel-max", "0"});
    EXPECT_EQ(same.exit_code, 0) << layer << ": " << same.err << same.out;
  }
  EXPECT_EQ(Json::parse(tool({"render", "sky.json", "-o", "plain.exr", "--json"}).out).count("layers"), 0U);
}

// In any colour space the sum of the light layers is the picture; here for one pixel in each face of a cube.
TEST_F(Tiles, LayersGoWithSpacesAndFaces) {
  const Names cube = {"render",
                      "sky.json",
                      "-q",
                      "--layers",
                      "--float",
                      "--size",
                      "8x48",
                      "--set",
                      "/camera/projection=cube",
                      "--set",
                      "/camera/pitch_deg=0",
                      "--colorspace",
                      "ACEScg"};
  Names whole = cube;
  whole.insert(whole.end(), {"-o", "cube.exr"});
  Names tiled = cube;
  tiled.insert(tiled.end(), {"-o", "tiles.exr", "--tile", "5x9"});
  Names faces = cube;
  faces.insert(faces.end(), {"-o", "face.exr", "--cube-faces"});
  for (const Names& words : {whole, tiled, faces}) {
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_EQ(scratch_.read("tiles.exr"), scratch_.read("cube.exr"));
  EXPECT_TRUE(contains(scratch_.read("face.posx.exr"), "transmittance.R"));
}

// It is made of the whole picture; an EXR alone has no bloom.
TEST_F(Tiles, ABloomChainIsRefused) {
  const Names chain = {"render", "sky.json", "--tile", "16x8", "--set", "/bloom/model=chain"};
  Names shown = chain;
  shown.insert(shown.end(), {"--png", "a.png"});
  expect_refusal(shown, "/bloom/model: a chain is made of the whole picture");
  Names light = chain;
  light.insert(light.end(), {"-o", "a.exr"});
  EXPECT_EQ(tool(light).exit_code, 0);
}

TEST_F(Tiles, LayersThatCannotBeAreRefused) {
  expect_refusal({"render", "sky.json", "--png", "a.png", "--layers"}, "give -o FILE.exr too");
  for (const std::string method : {"analytic", "nested", "march", "sky-view", "path-trace"}) {
    expect_refusal({"render", "sky.json", "-o", "a.exr", "--layers", "--method", method},
                   method + " does not tell its light apart; choose --method orders");
  }
  const Names layers = {"render", "sky.json", "-o", "a.exr", "--set", "/render/polarisation=false", "--layers"};
  Names stokes = layers;
  stokes.push_back("stokes");
  expect_refusal(stokes, "--layers stokes: render.polarisation is false");
  expect_refusal({"render", "sky.json", "-o", "a.exr", "--set", "/camera/polariser={}", "--layers"},
                 "--layers: layers hold light before the lens");
}

TEST_F(Tiles, APictureThroughAFilterIsTheSameByteForByte) {
  const Names base = {"render", "sky.json",
                      "-q",     "--float",
                      "--size", "75x41",
                      "--set",  "/render/tabulate=\"always\"",
                      "--set",  "/camera/polariser/angle_deg=40"};
  const auto with = [&](const Names& more) {
    Names words = base;
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = tool(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  };
  with({"-o", "whole.exr"});
  with({"-o", "odd.exr", "--tile", "19x7"});
  EXPECT_EQ(scratch_.read("odd.exr"), scratch_.read("whole.exr"));
  with({"-o", "other.exr", "--set", "/camera/polariser/angle_deg=130"});
  EXPECT_NE(scratch_.read("other.exr"), scratch_.read("whole.exr"));
}

TEST_F(Tiles, ASequenceHasLayersTooAndTellsFramesWithoutThemFromOthers) {
  const Names sweep = {"sequence", "sky.json", "-o", "f.#.exr", "--sun-elevation", "10:20:10", "--size", "16x9"};
  Names layered = sweep;
  layered.push_back("--layers");
  EXPECT_EQ(tool(sweep).exit_code, 0);
  const std::string plain = scratch_.read("f.1.exr");
  EXPECT_EQ(tool(layered).exit_code, 0);
  EXPECT_NE(scratch_.read("f.1.exr"), plain) << "a frame without layers was kept";
  EXPECT_TRUE(contains(tool(layered).err, "0 frames rendered, 2 kept"));
  EXPECT_TRUE(contains(scratch_.read("f.2.exr"), "transmittance.R"));
  EXPECT_TRUE(contains(scratch_.read("f.2.exr"), "depth.Z"));
}

}  // namespace
}  // namespace airlight::test
