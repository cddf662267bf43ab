// Clouds in a preset: defaults, files, refusals, and the way back to JSON.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/scene/cloud_file.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

class Clouds : public FolderTest {};

// Two points of water: of 0.2 and 0.1 g/m3 in drops of 10 and 12 um.
constexpr const char* kGrid =
    "# a small cloud\n3,2,2  # nx,ny,nz\n0.02,0.03  # km\n0.44,0.48\ni,j,k,lwc,reff\n1,1,1,0.2,10\n3,2,2,0.1,12\n";

std::string volume(const std::string& file, const std::string& extra = "") {
  return R"("clouds": [{"type": "volume", "file": ")" + file + "\"" + extra + "}]";
}

TEST_F(Clouds, HaveTheDefaultsOfTheirKind) {
  const Scene scene =
      scene_from(with_one_medium(R"("clouds": [{"type": "cumulus"}, {"type": "stratocumulus"}, {"type": "cirrus"}])"));
  ASSERT_EQ(scene.clouds.size(), 3u);
  EXPECT_EQ(scene.clouds[0].cover, 0.35);
  EXPECT_EQ(scene.clouds[1].cover, 0.85);
  EXPECT_EQ(scene.clouds[0].phase, CloudPhase::drops);
  EXPECT_EQ(scene.clouds[2].phase, CloudPhase::henyey_greenstein);
  EXPECT_EQ(scene.clouds[2].phase_g, 0.75);
  EXPECT_TRUE(scene.clouds[2].repeats);
}

// Extinction is 1.5 water / radius: 30 and 12.5 per km; the radius is the mean over it.
TEST_F(Clouds, AreReadFromPlainText) {
  const std::filesystem::path file = write("grid.txt", kGrid);
  CloudFile cloud;
  ASSERT_EQ(read_cloud_file(file, cloud), "");
  EXPECT_EQ(cloud.nx, 3);
  EXPECT_EQ(cloud.ny, 2);
  EXPECT_EQ(cloud.nz, 2);
  EXPECT_DOUBLE_EQ(cloud.dz, 0.04);
  ASSERT_EQ(cloud.extinction.size(), 12u);
  EXPECT_FLOAT_EQ(cloud.extinction[0], 30.0F);
  EXPECT_FLOAT_EQ(cloud.extinction[11], 12.5F);
  EXPECT_NEAR(cloud.effective_radius, (30.0 * 10.0 + 12.5 * 12.0) / 42.5, 1e-12);
}

TEST_F(Clouds, AreReadFromShdomsText) {
  CloudFile same;
  ASSERT_EQ(read_cloud_file(write("a.txt", kGrid), same), "");
  CloudFile cloud;
  ASSERT_EQ(read_cloud_file(write("b.txt",
                                  "2 parameter LWC file\n3 2 2\n 0.02 0.03\n 0.44\t0.48\n 292.0\t292.0\n"
                                  "1 1 1  0.2 10\n3 2 2  0.1 12\n"),
                            cloud),
            "");
  EXPECT_EQ(cloud.extinction, same.extinction);
  EXPECT_EQ(cloud.dx, same.dx);
  EXPECT_EQ(cloud.lowest, same.lowest);
}

TEST_F(Clouds, ComeBackFromJson) {
  const std::filesystem::path file = write("grid.txt", kGrid);
  const std::string text = with_one_medium(
      R"("clouds": [{"type": "cumulus", "cover": 0.3, "seed": 9, "detail_m": 70, "phase": {"function": "henyey-greenstein", "g": 0.8}},
         {"type": "cirrus", "wind_to_deg": 33, "east_km": 2, "wind_m_s": [-30, 4.5]}, {"type": "volume", "file": ")" +
      file.string() + R"(", "repeat": true, "single_scattering_albedo": 0.99}])");
  const Scene scene = scene_from(text);
  const Scene again = scene_from(to_json(scene));
  EXPECT_EQ(to_json(again), to_json(scene));
  ASSERT_EQ(again.clouds.size(), 3u);
  EXPECT_EQ(again.clouds[0], scene.clouds[0]);
  EXPECT_EQ(again.clouds[1], scene.clouds[1]);
  EXPECT_EQ(again.clouds[1].drift, (std::array{-30.0, 4.5}));
  EXPECT_EQ(to_json(scene).find("wind_m_s"), to_json(scene).rfind("wind_m_s"));  // not where there is none
  EXPECT_EQ(again.clouds[2].contents->extinction, scene.clouds[2].contents->extinction);
  EXPECT_EQ(again.clouds[2].single_scattering_albedo, 0.99);
}

// The file itself is read later, by whoever knows OpenVDB.
TEST_F(Clouds, VoxelsComeBackFromJson) {
  const Scene scene = scene_from(with_one_medium(
      volume("/none/Heap.VDB", R"(, "grid": "smoke", "up": "z", "metres_per_unit": 0.3, "extinction_per_km": 7,
                                    "base_km": 2, "effective_radius_um": 9)")));
  const Scene again = scene_from(to_json(scene));
  EXPECT_EQ(to_json(again), to_json(scene));
  ASSERT_TRUE(again.clouds.at(0).voxels.has_value());
  EXPECT_EQ(again.clouds[0], scene.clouds[0]);
  EXPECT_EQ(again.clouds[0].voxels->up, UpAxis::z);
  EXPECT_EQ(again.clouds[0].voxels->base, 2.0);
  EXPECT_EQ(again.clouds[0].effective_radius, 9.0);
  EXPECT_FALSE(scene_from(with_one_medium(volume("/none/heap.vdb"))).clouds[0].voxels->base.has_value());
}

double column_of(const Medium& medium) {
  double sum = 0.0;
  for (std::size_t k = 1; k < medium.density.layers.size(); ++k) {
    const DensityLayer& a = medium.density.layers[k - 1];
    const DensityLayer& b = medium.density.layers[k];
    sum += 0.5 * (a.density + b.density) * (b.altitude - a.altitude);
  }
  return sum;
}

TEST_F(Clouds, LayersAreMediaOfTheirDepth) {
  const auto layer = [](const std::string& keys) {
    const Scene scene = scene_from(with_one_medium(R"("clouds": [{"type": "layer", )" + keys + "}]"));
    EXPECT_TRUE(scene.clouds.empty());
    EXPECT_EQ(to_json(scene_from(to_json(scene))), to_json(scene));
    return scene.media.at(1);
  };
  const Medium even = layer(R"("base_km": 0.5, "top_km": 1.5, "optical_depth": 12, "single_scattering_albedo": 0.75)");
  EXPECT_EQ(even.name, "cloud layer");
  EXPECT_EQ(even.effective_radius, 8.0);
  EXPECT_EQ(even.phase, PhaseFunction::table);
  EXPECT_NEAR((even.scattering[1] + even.absorption[1]) * column_of(even), 12.0, 1e-12);
  EXPECT_NEAR(even.scattering[1] / even.absorption[1], 3.0, 1e-12);
  EXPECT_EQ(even.density.layers.front().altitude, 0.5);
  EXPECT_EQ(even.density.layers.back().altitude, 1.5);
  // 1.5 x 80 / 10.
  const Medium water = layer(R"("water_g_per_m2": 80, "effective_radius_um": 10, "scale_height_km": 0.25)");
  EXPECT_NEAR(water.scattering[0] * column_of(water), 12.0, 1e-12);
  EXPECT_EQ(water.absorption[0], 0.0);
  const std::vector<DensityLayer>& layers = water.density.layers;
  EXPECT_NEAR(layers.at(7).density, std::exp(-(layers.at(7).altitude - layers.at(1).altitude) / 0.25), 1e-12);
  const Medium fog = layer(R"("base_km": 0, "top_km": 0.2, "optical_depth": 3, "phase": {"function":
                              "henyey-greenstein", "g": 0.8})");
  EXPECT_EQ(fog.density.layers.front(), (DensityLayer{0.0, 1.0}));
  EXPECT_EQ(fog.phase, PhaseFunction::henyey_greenstein);
  EXPECT_EQ(fog.phase_g, 0.8);
}

TEST_F(Clouds, LayersStandBesideOtherClouds) {
  const Scene scene = scene_from(with_one_medium(
      R"("clouds": [{"type": "layer", "optical_depth": 1}, {"type": "cumulus"}, {"type": "layer", "optical_depth": 2}])"));
  EXPECT_EQ(scene.clouds.size(), 1u);
  ASSERT_EQ(scene.media.size(), 3u);
  EXPECT_EQ(scene.media[2].name, "cloud layer 2");
}

TEST_F(Clouds, DropsAreAMediumsPhaseToo) {
  const std::string text =
      R"({"airlight": 1, "media": [{"name": "a", "scattering_per_km": 0.01, "phase": {"function": "drops",
          "effective_radius_um": 8}, "density": {"profile": "constant", "below_km": 1}}]})";
  const Scene scene = scene_from(text);
  EXPECT_EQ(scene.media[0].phase, PhaseFunction::table);
  EXPECT_FALSE(scene.spectra.has_value());
  const Scene again = scene_from(to_json(scene));
  EXPECT_EQ(again.media[0], scene.media[0]);
  EXPECT_EQ(to_json(again), to_json(scene));
}

struct Broken {
  const char* text;
  const char* message;
};

TEST_F(Clouds, BrokenFilesAreRefusedWithTheirLine) {
  for (const Broken& broken : {
           Broken{"", "grid.txt:0: nothing in it; expected the numbers of points toward east, north and up"},
           Broken{"3 2\n",
                  "grid.txt:1: expected three whole numbers of points, toward east, north and up, 1 to 4096, "
                  "of product at most 33554432"},
           Broken{"4096 4096 4096\n",
                  "grid.txt:1: expected three whole numbers of points, toward east, north and up, 1 "
                  "to 4096, of product at most 33554432"},
           Broken{"3 2 2\n0 0.02\n", "grid.txt:2: expected distances of 0.0001 to 100 km"},
           Broken{"3 2 2\n0.02 0.02\n0.4 0.5 0.6\n", "grid.txt:3: expected the altitudes of 2 levels, km"},
           Broken{"3 2 2\n0.02 0.02\n", "grid.txt:2: the file ends here; expected the altitudes of 2 levels, km"},
           Broken{
               "3 2 3\n0.02 0.02\n0.4 0.5 0.7\ni j k lwc reff\n",
               "grid.txt:3: level 2 is at 0.5 km; expected ascending levels, evenly spaced to 1 % of their distance"},
           Broken{"3 2 2\n0.02 0.02\n0.4 0.5\ni j k lwc reff\n1 1 1 0.2\n",
                  "grid.txt:5: expected i j k, water in g/m3 and effective radius in um: five numbers; is the file cut "
                  "short?"},
           Broken{"3 2 2\n0.02 0.02\n0.4 0.5\ni j k lwc reff\n4 1 1 0.2 10\n",
                  "grid.txt:5: the point 4 is outside 1 to 3"},
           Broken{"3 2 2\n0.02 0.02\n0.4 0.5\ni j k lwc reff\n1 1 1 -0.2 10\n",
                  "grid.txt:5: water of -0.2 g/m3 is outside 0 to 100"},
           Broken{"3 2 2\n0.02 0.02\n0.4 0.5\ni j k lwc reff\n1 1 1 nan 10\n",
                  "grid.txt:5: expected i j k, water in g/m3 and effective radius in um: five numbers; is the file cut "
                  "short?"},
           Broken{"3 2 2\n0.02 0.02\n0.4 0.5\ni j k lwc reff\n1 1 1 0.2 0\n",
                  "grid.txt:5: an effective radius of 0 um is not above 0 and at most 10000"},
           Broken{"3 2 2\n0.02 0.02\n0.4 0.5\ni j k lwc reff\n",
                  "grid.txt:4: no water in it; expected lines of i j k, water and effective radius"},
       }) {
    CloudFile cloud;
    EXPECT_EQ(read_cloud_file(write("grid.txt", broken.text), cloud), broken.message) << broken.text;
  }
}

TEST_F(Clouds, NonsenseIsRefused) {
  const std::string missing = (folder_ / "none.txt").string();
  const auto problems = [](const std::string& clouds) { return problems_of(with_one_medium(clouds)); };
  EXPECT_EQ(problems(volume(missing)), "test:1: /clouds/0/file: none.txt cannot be read: No such file or directory");
  EXPECT_EQ(problems(R"("clouds": [{"type": "volume"}])"),
            "test:1: /clouds/0/file: missing for \"volume\"; expected a string");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "cover": 1.2}])"),
            "test:1: /clouds/0/cover: 1.2 is outside 0 to 1");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "base_km": 3}])"),
            "test:1: /clouds/0/top_km: 2.4 km is not above base_km, 3 km; lower the base or raise the top");
  // No word of the default that stands for a wrong value.
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "top_km": 101, "base_km": 99}])"),
            "test:1: /clouds/0/top_km: 101 is outside 0 to 100 km");
  EXPECT_EQ(problems(R"("clouds": [{"type": "layer", "top_km": 101, "base_km": 99, "optical_depth": 1}])"),
            "test:1: /clouds/0/top_km: 101 is outside 0 to 100 km");
  EXPECT_EQ(problems(R"("planet": {"atmosphere_height_km": 2}, "clouds": [{"type": "cumulus"}])"),
            "test:1: /clouds/0/top_km: the cloud reaches from 1 to 2.4 km; expected within the air, 0 to "
            "planet.atmosphere_height_km, 2");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "period_km": 3}])"),
            "test:1: /clouds/0/period_km: 3 km is less than two cells of 2 km; make the period longer or cell_km "
            "smaller");
  EXPECT_EQ(
      problems(R"("clouds": [{"type": "cumulus", "period_km": 200, "detail_m": 5}])"),
      "test:1: /clouds/0/detail_m: 5 m makes a grid of 40001 x 40001 x 281 points; expected at most 33554432: make "
      "the cells larger or the period shorter");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "file": "x"}])"),
            "test:1: /clouds/0/file: not a key of \"cumulus\"; it belongs to volume: remove it");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cirrus", "effective_radius_um": 60, "phase": {"function": "drops"}}])"),
            "test:1: /clouds/0/effective_radius_um: an effective radius of 60 um is above 40 um, the most of the phase "
            "function \"drops\"; choose \"henyey-greenstein\"");
  const std::string text = write("grid.txt", kGrid).string();
  EXPECT_EQ(problems(volume(text, R"(, "grid": "density")")),
            "test:1: /clouds/0/grid: a key of files of OpenVDB, and the name \"" + text +
                "\" does not end in .vdb; remove it");
  EXPECT_EQ(problems(volume("a.vdb", R"(, "up": "x")")),
            "test:1: /clouds/0/up: \"x\" is unknown; expected one of \"y\", \"z\"; did you mean \"y\"?");
  EXPECT_EQ(problems(volume("a.vdb", R"(, "extinction_per_km": -1)")),
            "test:1: /clouds/0/extinction_per_km: -1 is outside 0 to 100000 per km");
  const auto layer = [&](const std::string& keys) {
    return problems(R"("clouds": [{"type": "layer", )" + keys + "}]");
  };
  EXPECT_EQ(layer(R"("base_km": 0.6)"),
            "test:1: /clouds/0/optical_depth: missing for \"layer\"; give it or water_g_per_m2");
  EXPECT_EQ(layer(R"("optical_depth": 1, "water_g_per_m2": 9)"),
            "test:1: /clouds/0/water_g_per_m2: `optical_depth` says the same in another way; give one of the two");
  EXPECT_EQ(layer(R"("optical_depth": 1, "base_km": 2)"),
            "test:1: /clouds/0/top_km: 1 km is not above base_km, 2 km; lower the base or raise the top");
  EXPECT_EQ(layer(R"("optical_depth": 1, "cover": 0.5)"),
            "test:1: /clouds/0/cover: not a key of \"layer\"; it belongs to cumulus, stratocumulus, cirrus: remove it");
  EXPECT_EQ(layer(R"("optical_depth": 1, "effective_radius_um": 60)"),
            "test:1: /clouds/0/effective_radius_um: an effective radius of 60 um is above 40 um, the most of the phase "
            "function \"drops\"; choose \"henyey-greenstein\"");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "wind_m_s": 5}])"),
            "test:1: /clouds/0/wind_m_s: 5 is not a pair; expected an array of two numbers, each -200 to 200 m/s");
  EXPECT_EQ(
      problems(R"("clouds": [{"type": "cumulus", "wind_m_s": [1, 2, 3]}])"),
      "test:1: /clouds/0/wind_m_s: an array of 3 is not a pair; expected an array of two numbers, each -200 to 200 "
      "m/s");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "wind_m_s": [0, 201]}])"),
            "test:1: /clouds/0/wind_m_s/1: 201 is outside -200 to 200 m/s");
  EXPECT_EQ(problems(R"("clouds": [{"type": "cumulus", "wind_m_s": ["east", 1]}])"),
            "test:1: /clouds/0/wind_m_s/0: \"east\" is not a number; expected -200 to 200 m/s");
  EXPECT_EQ(problems(R"("clouds": [{"type": "layer", "optical_depth": 1, "wind_m_s": [1, 1]}])"),
            "test:1: /clouds/0/wind_m_s: not a key of \"layer\"; it belongs to cumulus, stratocumulus, cirrus, volume: "
            "remove it");
  EXPECT_EQ(problems(R"("clouds": [{"type": "fog"}])"),
            "test:1: /clouds/0/type: \"fog\" is unknown; expected one of \"cumulus\", \"stratocumulus\", "
            "\"cirrus\", \"volume\", \"layer\"");
}

}  // namespace
}  // namespace airlight::test
