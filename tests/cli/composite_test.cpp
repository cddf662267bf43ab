// `airlight composite` on pictures that the test makes: channels that pass unchanged, agreement with the sky, refusals.
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfPartType.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/foreign/foreign_picture.h"
#include "core/output/exr.h"
#include "core/output/picture_reader.h"
#include "tests/cli/small_sky.h"

namespace airlight::test {
namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 16;
constexpr std::size_t kPixels = kWidth * kHeight;

// A picture of R, G, B, A, Z and a further channel, each with one value all over.
struct Beauty {
  float light = 0.0F;
  float alpha = 0.0F;
  float z = 1e10F;
  std::string z_name = "Z";

  void write(const std::filesystem::path& file, int width = kWidth) const {
    const std::vector<float> l(kPixels, light);
    const std::vector<float> a(kPixels, alpha);
    const std::vector<float> d(kPixels, z);
    const std::vector<float> id(kPixels, 7.0F);
    const std::vector<ExrChannel> channels{{"R", l.data(), 1, true},    {"G", l.data(), 1, true},
                                           {"B", l.data(), 1, true},    {"A", a.data(), 1, true},
                                           {z_name, d.data(), 1, true}, {"id", id.data(), 1, true}};
    ExrOptions options;
    options.half = false;
    write_exr(file, width, kHeight, channels, options);
  }
};

class CompositeTool : public SmallSky {
 protected:
  std::filesystem::path path(const std::string& name) const { return scratch_.path() / name; }
  Outcome composite(Names words) const {
    words.insert(words.begin(), {"composite", "sky.json", "--method", "orders"});
    return tool(std::move(words));
  }
  RadianceImage picture(const std::string& name) const { return read_exr_picture(path(name)).radiance; }
  RadianceImage sky() const {
    const Outcome done = tool({"render", "sky.json", "--method", "orders", "--float", "-q", "-o", "sky.exr", "--size",
                               std::to_string(kWidth) + "x" + std::to_string(kHeight)});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return picture("sky.exr");
  }
};

TEST_F(CompositeTool, WhereNothingIsThePictureIsTheSkyBitForBit) {
  const RadianceImage expected = sky();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float z : {1e10F, nan}) {
    Beauty{.light = 5.0F, .alpha = 1.0F, .z = z}.write(path("in.exr"));
    const Outcome done = composite({"--beauty", "in.exr", "-o", "out.exr"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    const RadianceImage found = picture("out.exr");
    for (std::size_t i = 0; i < kPixels; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(found.rgba[4 * i + c], expected.rgba[4 * i + c]) << z << ", pixel " << i;
      }
    }
    EXPECT_TRUE(contains(done.err, std::to_string(kPixels) + " opaque pixels have no depth")) << done.err;
    EXPECT_EQ(contains(done.err, "are not numbers"), std::isnan(z)) << done.err;
    EXPECT_FALSE(contains(done.err, "is a picture of airlight's")) << done.err;
  }
}

// The air before a thing has its true length where it bends light too, so that a thing shines through it as through
// straight rays. Twice the density near the ground, as a wrong length would be, is a difference of 2 %.
TEST_F(CompositeTool, DistancesAreTrueWhereLightIsBent) {
  Beauty{.light = 100.0F, .alpha = 1.0F, .z = 30000.0F}.write(path("in.exr"));
  const std::string bent = R"(/planet/refraction={"n_minus_1": 2.78e-4, "scale_height_km": 8})";
  ASSERT_EQ(composite({"--beauty", "in.exr", "-o", "straight.exr"}).exit_code, 0);
  ASSERT_EQ(composite({"--beauty", "in.exr", "-o", "bent.exr", "--set", bent}).exit_code, 0);
  const RadianceImage with = picture("bent.exr");
  const RadianceImage without = picture("straight.exr");
  EXPECT_NE(with.rgba, without.rgba);
  for (std::size_t i = 0; i < with.rgba.size(); ++i) {
    EXPECT_NEAR(with.rgba[i], without.rgba[i], 0.01F * without.rgba[i]) << i;
  }
}

// A closed sheet of cloud hides what stands behind it, and nothing that stands before it.
TEST_F(CompositeTool, CloudsStandBeforeAndBehindThings) {
  const std::string sheet =
      R"(/clouds=[{"type": "stratocumulus", "cover": 1, "water_g_per_m3": 1, "period_km": 4, "detail_m": 200}])";
  const Names words{"--beauty", "in.exr", "--set", sheet, "--set", "/camera/pitch_deg=50", "-q"};
  const auto with = [&](Names more) {
    more.insert(more.begin(), words.begin(), words.end());
    return composite(more);
  };
  Beauty{.light = 100.0F, .alpha = 1.0F, .z = 500.0F}.write(path("in.exr"));
  ASSERT_EQ(with({"-o", "before.exr"}).exit_code, 0);
  Beauty{.light = 100.0F, .alpha = 1.0F, .z = 1e5F}.write(path("in.exr"));
  ASSERT_EQ(with({"-o", "behind.exr"}).exit_code, 0);
  const RadianceImage before = picture("before.exr");
  const RadianceImage behind = picture("behind.exr");
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < kPixels; ++i) {
    EXPECT_NEAR(before.rgba[4 * i], 100.0F, 5.0F) << i;
    hidden += behind.rgba[4 * i] < 10.0F ? 1U : 0U;
  }
  EXPECT_GT(hidden, kPixels / 2);
  const Outcome volume = with({"-o", "out.exr", "--aerial", "volume"});
  EXPECT_EQ(volume.exit_code, 2);
  EXPECT_EQ(volume.err, "airlight: in.exr: --aerial volume holds no clouds; use --aerial march\n");
}

// A micrometre of air counts as none: the beauty comes through, with alpha and the further channel unchanged.
TEST_F(CompositeTool, BeforeAThingAtTheLensIsNoAir) {
  Beauty{.light = 0.25F, .alpha = 1.0F, .z = 1e-6F}.write(path("in.exr"));
  ASSERT_EQ(composite({"--beauty", "in.exr", "-o", "out.exr", "-q", "--scale", "2"}).exit_code, 0);
  const RadianceImage found = picture("out.exr");
  for (std::size_t i = 0; i < kPixels; ++i) {
    ASSERT_NEAR(found.rgba[4 * i + 1], 0.5F, 1e-6F);
    ASSERT_EQ(found.rgba[4 * i + 3], 1.0F);
  }
  EXPECT_TRUE(contains(scratch_.read("out.exr"), std::string("id\0", 3)));
}

// A black plane that recedes merges with the sky. Its colour at 10 000 km, beyond all air, is the sky's above the
// horizon, except for half of the steps on the way, which are good to a thousandth.
TEST_F(CompositeTool, FarThingsJoinTheSky) {
  const RadianceImage expected = sky();
  Beauty{.light = 0.0F, .alpha = 1.0F, .z = 1e7F}.write(path("in.exr"));
  ASSERT_EQ(composite({"--beauty", "in.exr", "-o", "out.exr", "-q"}).exit_code, 0);
  const RadianceImage found = picture("out.exr");
  for (int x = 0; x < kWidth; ++x) {
    for (int c = 0; c < 3; ++c) {
      const float want = expected.at(x, 0)[c];
      EXPECT_NEAR(found.at(x, 0)[c], want, 1e-3F * want) << x;
    }
  }
}

// A planar depth of 1 km, and the distance of that depth at the picture's corner.
TEST_F(CompositeTool, TellsThatTheNightSkyIsNotInTheAirBeforeThings) {
  Beauty{.light = 0.0F, .alpha = 1.0F, .z = 1e4F}.write(path("in.exr"));
  const auto told = [&](const char* elevation, const char* night) {
    const Outcome done =
        composite({"--beauty", "in.exr", "-o", "out.exr", "--sun-elevation", elevation, "--set", night});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return contains(done.err, "that of night_sky is left out there");
  };
  EXPECT_TRUE(told("-20", "/night_sky={}"));
  EXPECT_FALSE(told("20", "/night_sky={}"));
  EXPECT_FALSE(told("-20", "/stars={}"));
}

TEST_F(CompositeTool, PlanarDepthIsLongerTowardTheCorners) {
  Beauty{.alpha = 1.0F, .z = 10000.0F}.write(path("in.exr"));
  const Names layers{"--layers", "inscatter,transmittance", "-q", "--beauty", "in.exr", "-o"};
  const auto with = [&](Names words, const std::string& kind, const std::string& out) {
    words.push_back(out);
    words.insert(words.end(), {"--depth-kind", kind});
    EXPECT_EQ(composite(words).exit_code, 0);
    return picture(out);
  };
  const RadianceImage planar = with(layers, "planar", "p.exr");
  const RadianceImage along = with(layers, "distance", "d.exr");
  EXPECT_GT(planar.at(0, 0)[2], along.at(0, 0)[2]);
  EXPECT_TRUE(contains(scratch_.read("p.exr"), "transmittance.G"));
}

TEST_F(CompositeTool, FramesByPattern) {
  Beauty{.alpha = 1.0F, .z = 100.0F}.write(path("in.0001.exr"));
  Beauty{.alpha = 1.0F, .z = 1000.0F}.write(path("in.0007.exr"));
  const Outcome done = composite({"--beauty", "in.####.exr", "-o", "out.####.exr", "--json"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_GT(picture("out.0007.exr").at(3, 3)[2], picture("out.0001.exr").at(3, 3)[2]);
  EXPECT_TRUE(contains(done.out, "out.0001.exr") && contains(done.out, "out.0007.exr")) << done.out;
}

// A sample in each pixel with a clear one before it, equivalent to the flat picture.
void write_deep(const std::filesystem::path& file, float light, float alpha, float z) {
  Imf::Header header(kWidth, kHeight);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  const std::array<const char*, 5> names{"R", "G", "B", "A", "Z"};
  for (const char* name : names) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  }
  std::vector<unsigned int> counts(kPixels, 2);
  const std::array<std::array<float, 2>, 5> values{
      {{0.0F, light}, {0.0F, light}, {0.0F, light}, {0.0F, alpha}, {0.5F * z, z}}};
  std::array<std::vector<const float*>, 5> pointers;
  Imf::DeepFrameBuffer buffer;
  buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), sizeof(unsigned int),
                                           sizeof(unsigned int) * kWidth));
  for (std::size_t k = 0; k < names.size(); ++k) {
    pointers[k].assign(kPixels, values[k].data());
    buffer.insert(names[k], Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers[k].data()), sizeof(float*),
                                           sizeof(float*) * kWidth, sizeof(float)));
  }
  Imf::DeepScanLineOutputFile output(file.c_str(), header);
  output.setFrameBuffer(buffer);
  output.writePixels(kHeight);
}

TEST_F(CompositeTool, DeepPicturesSampleBySample) {
  Beauty{.light = 0.3F, .alpha = 0.6F, .z = 20000.0F}.write(path("flat.exr"));
  write_deep(path("deep.exr"), 0.3F, 0.6F, 20000.0F);
  for (const char* name : {"flat", "deep"}) {
    const Outcome done =
        composite({"--beauty", std::string(name) + ".exr", "-o", std::string(name) + "-out.exr", "-q"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
  }
  const RadianceImage flat = picture("flat-out.exr");
  const RadianceImage deep = picture("deep-out.exr");
  for (std::size_t i = 0; i < flat.rgba.size(); ++i) {
    ASSERT_NEAR(deep.rgba[i], flat.rgba[i], 2e-6F + 2e-6F * std::abs(flat.rgba[i])) << i;
  }
}

TEST_F(CompositeTool, ASimpleFog) {
  Beauty{.light = 1.0F, .alpha = 1.0F, .z = 2.0F}.write(path("in.exr"));
  const Outcome done = composite({"--beauty", "in.exr", "-o", "out.exr", "-q", "--depth-unit", "km", "--depth-kind",
                                  "distance", "--fog", "exponential", "--fog-set", "density=0.5"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const float kept = std::exp(-1.0F);
  EXPECT_NEAR(picture("out.exr").at(5, 5)[0], kept + 0.5F * (1.0F - kept), 1e-5F);
}

// A picture of ours already has air in it: the message says so, and what to do where it has no depth.
TEST_F(CompositeTool, APictureOfAirlightsHasItsAirAlready) {
  for (const char* name : {"plain.exr", "plate.exr"}) {
    Names words{"render", "sky.json", "--method", "orders", "-q", "-o", name, "--size", "24x16"};
    if (name == std::string("plate.exr")) {
      words.push_back("--layers");
    }
    ASSERT_EQ(tool(words).exit_code, 0);
  }
  const Outcome plain = composite({"--beauty", "plain.exr", "-o", "o.exr"});
  EXPECT_EQ(plain.exit_code, 2);
  EXPECT_TRUE(contains(plain.err, "plain.exr: has no depth channel; render it with --layers")) << plain.err;
  const Outcome plate = composite({"--beauty", "plate.exr", "-o", "o.exr"});
  EXPECT_EQ(plate.exit_code, 0) << plate.err;
  EXPECT_TRUE(contains(plate.err, "plate.exr: is a picture of airlight's")) << plate.err;
  const Outcome ground = composite({"--beauty", "plate.exr", "--layer", "ground", "-o", "o.exr"});
  EXPECT_FALSE(contains(ground.err, "is a picture of airlight's")) << ground.err;
}

// The thing's share has the air before it; the rest has the whole sky's light, also behind the thing. The volume agrees
// with the march, and a tolerance uses it where permitted.
TEST_F(CompositeTool, TheAerialVolumeBeforeTransparentThings) {
  const RadianceImage behind = sky();
  Beauty{.light = 0.1F, .alpha = 1.0F, .z = 9000.0F}.write(path("opaque.exr"));
  Beauty{.light = 0.05F, .alpha = 0.5F, .z = 9000.0F}.write(path("half.exr"));
  const auto with = [&](const std::string& beauty, Names words, const char* way) {
    words.insert(words.end(), {"--beauty", beauty, "-o", "out.exr", "--json"});
    const Outcome done = composite(words);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_TRUE(contains(done.out, std::string("\"air\":\"") + way)) << done.out;
    return picture("out.exr");
  };
  const RadianceImage march = with("opaque.exr", {}, "march");
  const RadianceImage volume = with("opaque.exr", {"--tolerance", "2%"}, "volume");
  const RadianceImage sure = with("opaque.exr", {"--tolerance", "0.0001%"}, "march");
  const RadianceImage half = with("half.exr", {"--aerial", "volume"}, "volume");
  EXPECT_EQ(sure.rgba, march.rgba);
  EXPECT_NE(volume.rgba, march.rgba);
  for (std::size_t i = 0; i < volume.rgba.size(); ++i) {
    ASSERT_NEAR(volume.rgba[i], march.rgba[i], 0.01F * march.rgba[i]) << i;
    if (i % 4 != 3) {
      const float expected = 0.5F * volume.rgba[i] + 0.5F * behind.rgba[i];
      ASSERT_NEAR(half.rgba[i], expected, 1e-5F * expected) << i;
    }
  }
}

// Light that is no number would spread over all that is computed of it.
TEST_F(CompositeTool, LightThatIsNoNumberIsMendedAndTold) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto write = [&](const std::string& name, float red, float alpha) {
    std::array<std::vector<float>, 5> planes;
    std::vector<ExrChannel> channels;
    for (std::size_t c = 0; c < planes.size(); ++c) {
      planes[c].assign(kPixels, c == 4 ? 1000.0F : c == 3 ? 1.0F : 0.25F);
      channels.push_back({std::string(1, "RGBAZ"[c]), planes[c].data(), 1, true});
    }
    planes[0][kWidth + 5] = red;  // at (5, 1)
    planes[3][kWidth + 5] = alpha;
    ExrOptions options;
    options.half = false;
    write_exr(path(name), kWidth, kHeight, channels, options);
  };
  write("good.exr", 0.25F, 1.0F);
  ASSERT_EQ(composite({"--beauty", "good.exr", "-o", "expected.exr"}).exit_code, 0);
  const RadianceImage expected = picture("expected.exr");
  const auto expect = [&](const std::string& told, bool same) {
    const Outcome done = composite({"--beauty", "bad.exr", "-o", "out.exr"});
    ASSERT_EQ(done.exit_code, 0) << done.err;
    EXPECT_TRUE(contains(done.err, "bad.exr: 1 " + told + ", the first at (5, 1)")) << done.err;
    const RadianceImage found = picture("out.exr");
    for (std::size_t i = 0; i < found.rgba.size(); ++i) {
      ASSERT_TRUE(std::isfinite(found.rgba[i])) << i;
      if (same || i / 4 != kWidth + 5) {
        ASSERT_EQ(found.rgba[i], expected.rgba[i]) << i;
      }
    }
  };
  for (const float alpha : {kNan, kInfinity}) {
    write("bad.exr", 0.25F, alpha);
    expect("alphas hold NaN or infinity and are taken as opaque", true);
  }
  for (const float red : {kNan, kInfinity, -kInfinity}) {
    write("bad.exr", red, 1.0F);
    expect("colours hold NaN or infinity and are taken as black", false);
  }
  // Finite light that the space of the output cannot hold is refused.
  write("bad.exr", 3e38F, 1.0F);
  std::filesystem::remove(path("out.exr"));
  const Outcome refused = composite({"--beauty", "bad.exr", "-o", "out.exr", "--scale", "10"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_TRUE(contains(refused.err, "the picture holds ")) << refused.err;
  EXPECT_TRUE(contains(refused.err, "values that are not finite, the first at column 5, row 1")) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(path("out.exr")));
}

// A plate of Blender's (scripts/blender-plate): hills, towers and a plain to beyond the horizon, lit but without air.
TEST_F(CompositeTool, APlateOfBlenders) {
  const std::string plate = std::string(AIRLIGHT_SOURCE_DIR) + "/presets/plates/hills.exr";
  const Outcome done = tool({"composite", "earth-golden-hour", "--beauty", plate, "--up", "z", "--tolerance", "1%",
                             "-o", "out.exr", "--float"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_TRUE(contains(done.err, "0.06 km high, azimuth -125, pitch 1")) << done.err;
  EXPECT_TRUE(contains(done.err, "air: by volume")) << done.err;
  const foreign::Picture before = foreign::read_picture(plate);
  const foreign::Picture after = foreign::read_picture(path("out.exr").string());
  const std::string blue = "ViewLayer.Combined.B";
  const auto& z = before.find("ViewLayer.Depth.Z")->values;
  const auto& was = before.find(blue)->values;
  const auto& is = after.find(blue)->values;
  int ridges = 0;
  for (std::size_t i = 320; i < z.size(); ++i) {
    ASSERT_TRUE(std::isfinite(is[i]) && is[i] > 0.0F) << i;
    // At a far ridge before the sky most light is the air's, and it is no brighter than the sky.
    if (z[i] > 15e3F && z[i] < 1e9F && z[i - 320] >= 1e9F) {
      EXPECT_GT(is[i], 4.0F * was[i]) << i;
      EXPECT_GT(is[i], 0.3F * is[i - 320]) << i;
      EXPECT_LT(is[i], 1.1F * is[i - 320]) << i;
      ++ridges;
    }
  }
  EXPECT_GT(ridges, 50);
}

struct Refused {
  Names words;
  std::string named;
};

// EXRs need no module.
TEST_F(CompositeTool, AMissingModuleIsSaidPlainly) {
  scratch_.write("plate.png", "which no EXR is");
  std::filesystem::copy_file(tool_program(), path("airlight"));
  const Outcome done = run(scratch_.path(), {path("airlight").string(), "composite", "sky.json", "--method", "orders",
                                             "--beauty", "plate.png", "-o", "o.exr"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_TRUE(contains(done.err, "airlight_foreign.so: is neither at")) << done.err;
  EXPECT_TRUE(contains(done.err, "install the package airlight-formats")) << done.err;
  EXPECT_EQ(lines_of(done.err).size(), 1U) << done.err;
  EXPECT_FALSE(std::filesystem::exists(path("o.exr")));
}

TEST_F(CompositeTool, RefusesWithPlaceAndRemedy) {
  Beauty{.z_name = "far"}.write(path("in.exr"));
  Beauty{}.write(path("good.exr"));
  Beauty{.alpha = 1.0F, .z = 1e6F}.write(path("near.exr"));
  Beauty{}.write(path("narrow.exr"), kWidth / 2);
  scratch_.write("text.exr", "not a picture");
  const std::vector<Refused> cases{
      {{}, "--beauty"},
      {{"--beauty", "good.exr"}, "-o"},
      {{"--beauty", "none.exr", "-o", "o.exr"}, "none.exr: no such file"},
      {{"--beauty", "text.exr", "-o", "o.exr"}, "text.exr: is no picture that airlight reads; expected EXR, PNG"},
      {{"--beauty", "in.exr", "-o", "o.exr"}, "has no depth channel"},
      {{"--beauty", "in.exr", "-o", "o.exr"}, "render it with a depth pass (Z)"},
      {{"--beauty", "in.exr", "-o", "o.exr"}, "far"},  // those present are listed
      {{"--beauty", "good.exr", "--depth", "good.exr:zz", "-o", "o.exr"}, "has no channel 'zz'"},
      {{"--beauty", "good.exr", "--depth", "narrow.exr:Z", "-o", "o.exr"}, "12x16"},
      {{"--beauty", "good.exr", "--layer", "foo", "-o", "o.exr"}, "has no layer 'foo'"},
      {{"--beauty", "good.exr", "-o", "o.png"}, ".exr"},
      {{"--beauty", "good.exr", "-o", "./good.exr"}, "is the file good.exr that it reads, which would be lost"},
      {{"--beauty", "in.exr", "--depth", "good.exr:Z", "-o", "good.exr"}, "is the file good.exr that it reads"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--camera", "file"}, "says nothing of its camera"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--depth-unit", "parsec"}, "parsec"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--layers", "depth"}, "'depth'"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--scale", "0"}, "--scale"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--fog-set", "a=1"}, "--fog"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--fog", "height", "--fog-set", "density=1"}, "density=1"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--fog", "height", "--fog-set", "a=x"}, "a takes one number"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--tolerance", "1%", "--aerial", "volume"}, "give one of the two"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--tolerance", "1%", "--fog", "height"}, "leave them out"},
      {{"--beauty", "near.exr", "-o", "o.exr", "--aerial", "volume", "--set", "/camera/altitude_km=500"},
       "near.exr: the camera stands above the air"},
      {{"--beauty", "good.exr", "-o", "o.exr", "--set", "/camera/polariser={}"},
       "composite: camera.polariser: nothing"},
      {{"--beauty", "good.####.exr", "-o", "o.####.exr"}, "no frame of this pattern"},
      {{"--beauty", "good.exr", "-o", "o.####.exr"}, "both as patterns"}};
  for (const Refused& refused : cases) {
    const Outcome outcome = composite(refused.words);
    EXPECT_EQ(outcome.exit_code, 2) << refused.named << ": " << outcome.err;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, refused.named)) << refused.named << ": " << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(path("o.exr"))) << refused.named;
  }
  const Outcome march = tool({"composite", "sky.json", "--method", "march", "--beauty", "good.exr", "-o", "o.exr"});
  EXPECT_EQ(march.exit_code, 2);
  EXPECT_TRUE(contains(march.err, "choose orders")) << march.err;
}

}  // namespace
}  // namespace airlight::test
