// `extends`: chains, merging, circles.

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

class Extends : public FolderTest {
 protected:
  Scene load(const std::filesystem::path& file) const { return resolve(load_preset(file), local_methods()); }
  std::string name(std::string_view file) const { return (folder_ / file).string(); }
};

constexpr std::string_view kBase = R"({
  "airlight": 1,
  "name": "base",
  "planet": {"radius_km": 1000, "ground_albedo": 0.5},
  "media": [
    {"name": "air", "scattering_per_km": 0.1, "density": {"profile": "exponential", "scale_height_km": 8}},
    {"name": "dust", "density": {"profile": "exponential", "scale_height_km": 2},
     "phase": {"function": "henyey-greenstein", "g": 0.5}}
  ],
  "render": {"steps": 64}
})";

TEST_F(Extends, MergesKeyByKey) {
  write("base.json", kBase);
  const Scene scene = load(write("top.json", R"({"airlight": 1, "extends": "base.json",
    "planet": {"radius_km": 2000}, "name": "top"})"));
  EXPECT_EQ(scene.name, "top");
  EXPECT_EQ(scene.planet.ground_radius, 2000);
  EXPECT_EQ(scene.planet.ground_albedo, (Spectrum{0.5, 0.5, 0.5}));
  EXPECT_EQ(scene.render.get<int>("steps"), 64);
}

TEST_F(Extends, MergesMediaByNameAndAddsTheNewInOrder) {
  write("base.json", kBase);
  const Scene scene = load(write("top.json", R"({"airlight": 1, "extends": "base.json", "media": [
    {"name": "fog", "density": {"profile": "constant", "below_km": 1}},
    {"name": "dust", "scattering_per_km": 0.3, "phase": {"function": "schlick"}},
    {"name": "smog", "density": {"profile": "constant", "below_km": 2}}]})"));
  ASSERT_EQ(scene.media.size(), 4U);
  EXPECT_EQ(scene.media[0].name, "air");
  EXPECT_EQ(scene.media[0].scattering[0], 0.1);
  EXPECT_EQ(scene.media[1].name, "dust");
  EXPECT_EQ(scene.media[1].scattering[0], 0.3);
  EXPECT_EQ(scene.media[1].density.scale_height, 2);
  EXPECT_EQ(scene.media[1].phase, PhaseFunction::schlick);
  EXPECT_EQ(scene.media[1].phase_g, 0.5);
  EXPECT_EQ(scene.media[2].name, "fog");
  EXPECT_EQ(scene.media[3].name, "smog");
}

TEST_F(Extends, ADensityWithItsOwnProfileLeavesNoStrays) {
  write("base.json", kBase);
  const Scene tent = load(write("tent.json", R"({"airlight": 1, "extends": "base.json", "media": [
    {"name": "air", "density": {"profile": "tent", "center_km": 5, "half_width_km": 1}}]})"));
  EXPECT_EQ(tent.media[0].density.profile, DensityProfile::tent);
  const Scene scaled = load(write("scaled.json", R"({"airlight": 1, "extends": "base.json", "media": [
    {"name": "air", "density": {"scale_height_km": 5}}]})"));
  EXPECT_EQ(scaled.media[0].density.profile, DensityProfile::exponential);
  EXPECT_EQ(scaled.media[0].density.scale_height, 5);
}

TEST_F(Extends, ASpectrumReplacesASpectrum) {
  write("base.json", kBase);
  const Scene scene = load(write("top.json", R"({"airlight": 1, "extends": "base.json",
    "planet": {"ground_albedo": [0.1, 0.2, 0.3]}})"));
  EXPECT_EQ(scene.planet.ground_albedo, (Spectrum{0.1, 0.2, 0.3}));
}

TEST_F(Extends, FollowsChainsByPathsRelativeToEachFile) {
  write("air/base.json", kBase);
  write("air/middle.json", R"({"airlight": 1, "extends": "base.json", "planet": {"atmosphere_height_km": 50}})");
  const Scene scene = load(write("sky/top.json", R"({"airlight": 1, "extends": "../air/middle.json", "name": "top"})"));
  EXPECT_EQ(scene.planet.ground_radius, 1000);
  EXPECT_EQ(scene.planet.atmosphere_height, 50);
  EXPECT_EQ(scene.name, "top");
}

TEST_F(Extends, TextBuildsOnTheGivenFolder) {
  write("base.json", kBase);
  const Preset preset = parse_preset(R"({"airlight": 1, "extends": "base.json"})", "text", folder_);
  EXPECT_EQ(resolve(preset, local_methods()).planet.ground_radius, 1000);
}

TEST_F(Extends, InheritedKeysOfAnotherMethodAreLeftOut) {
  write("base.json", R"({"airlight": 1, "media": [{"name": "a", "density": {"profile": "constant", "below_km": 1}}],
    "render": {"method": "orders", "steps": 20, "multiple_scattering_scale": 2, "color": "warm"}})");
  const Scene scene =
      load(write("top.json", R"({"airlight": 1, "extends": "base.json", "render": {"method": "still"}})"));
  EXPECT_EQ(scene.render.method, "still");
  EXPECT_EQ(scene.render.get<int>("steps"), 20);
  EXPECT_FALSE(scene.render.parameters.contains("color"));
  EXPECT_EQ(problems_of_file(write("own.json", R"({"airlight": 1, "extends": "base.json",
    "render": {"method": "still", "color": "cold"}})")),
            name("own.json") +
                ":2: /render/color: the method \"still\" does not take this key; it belongs to orders: remove it");
}

TEST_F(Extends, AnInheritedMisspeltKeyStaysAnError) {
  write("base.json", R"({"airlight": 1, "media": [{"name": "a", "density": {"profile": "constant", "below_km": 1}}],
    "render": {"stpes": 20}})");
  EXPECT_EQ(problems_of_file(write("top.json", R"({"airlight": 1, "extends": "base.json"})")),
            name("base.json") + ":2: /render/stpes: unknown key; did you mean \"steps\"?");
}

TEST_F(Extends, NamesTheFileAndLineOfEachProblem) {
  write("base.json",
        "{\"airlight\": 1,\n\"sun\": {\"elevation_deg\": 100},\n"
        "\"media\": [{\"name\": \"a\", \"density\": {\"profile\": \"constant\", \"below_km\": 1}}]}");
  EXPECT_EQ(problems_of_file(write("top.json",
                                   "{\"airlight\": 1, \"extends\": \"base.json\",\n\n\"media\": [{\"name\": "
                                   "\"a\",\n\"phase\": {\"g\": 1.2}}]}")),
            name("base.json") + ":2: /sun/elevation_deg: 100 is outside -90 to 90 degrees\n" + name("top.json") +
                ":4: /media/0/phase/g: 1.2 is outside -0.99 to 0.99");
}

TEST_F(Extends, RefusesAMissingFile) {
  EXPECT_EQ(problems_of_file(write("top.json", "{\"airlight\": 1,\n\"extends\": \"nowhere.json\"}")),
            name("top.json") + ":2: /extends: \"nowhere.json\" cannot be read: " + name("nowhere.json") +
                ": No such file or directory; expected a preset, by a path relative to the file that names it");
  EXPECT_EQ(problems_of_file(write("folder.json", "{\"airlight\": 1, \"extends\": \".\"}")),
            name("folder.json") + ":1: /extends: \".\" cannot be read: " + folder_.string() +
                "/: is a directory; expected a preset, by a path relative to the file that names it");
}

// A bundle of a built-in preset and one that extends it.
const BundledPresets& bundle() {
  static const BundledPresets presets = {
      {"base.json", kBase}, {"thick.json", R"({"airlight": 1, "extends": "base.json", "planet": {"radius_km": 7}})"}};
  return presets;
}

TEST_F(Extends, FindsBuiltInPresetsByTheirNames) {
  const auto radius = [&](std::string_view text) {
    return resolve(load_preset(write("top.json", text), bundle()), local_methods()).planet.ground_radius;
  };
  EXPECT_EQ(radius(R"({"airlight": 1, "extends": "base"})"), 1000);
  EXPECT_EQ(radius(R"({"airlight": 1, "extends": "base.json"})"), 1000);
  EXPECT_EQ(radius(R"({"airlight": 1, "extends": "thick"})"), 7);
  EXPECT_EQ(resolve(parse_bundled_preset("thick.json", bundle()), local_methods()).planet.ground_radius, 7);
}

// A file beside the preset has precedence, but built-in presets still extend built-in ones.
TEST_F(Extends, AFileBesideThePresetComesBeforeABuiltInOne) {
  write("base.json", R"({"airlight": 1, "planet": {"radius_km": 5},
    "media": [{"name": "a", "density": {"profile": "constant", "below_km": 1}}]})");
  const auto radius = [&](std::string_view text) {
    return resolve(load_preset(write("top.json", text), bundle()), local_methods()).planet.ground_radius;
  };
  EXPECT_EQ(radius(R"({"airlight": 1, "extends": "base.json"})"), 5);
  EXPECT_EQ(radius(R"({"airlight": 1, "extends": "base"})"), 1000);
  EXPECT_EQ(radius(R"({"airlight": 1, "extends": "thick"})"), 7);
}

TEST_F(Extends, SaysWhereItLookedForABuiltInPreset) {
  const std::filesystem::path file = write("top.json", R"({"airlight": 1, "extends": "thik"})");
  try {
    load_preset(file, bundle());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), name("top.json") + ":1: /extends: \"thik\" cannot be read: " + name("thik") +
                                ": No such file or directory, and no built-in preset is called so; did you mean "
                                "\"thick\"?; expected a preset, by a path relative to the file that names it, or a "
                                "built-in one by its name");
  }
}

TEST_F(Extends, ASchemaForEditorsIsAllowed) {
  const std::string media = R"("media": [{"name": "a", "density": {"profile": "constant", "below_km": 1}}]})";
  EXPECT_NO_THROW(load(write("a.json", R"({"$schema": "preset-1.schema.json", "airlight": 1, )" + media)));
  EXPECT_EQ(problems_of_file(write("b.json", R"({"$schema": 1, "airlight": 1, )" + media)),
            name("b.json") + ":1: /$schema: 1 is not a string; expected a string");
}

TEST_F(Extends, RefusesACircle) {
  const std::string self = name("self.json");
  EXPECT_EQ(problems_of_file(write("self.json", R"({"airlight": 1, "extends": "./self.json"})")),
            self + ":1: /extends: \"./self.json\" makes a circle (" + self + " -> " + self +
                "); a preset cannot build on itself");
  write("a.json", R"({"airlight": 1, "extends": "b.json"})");
  write("b.json", R"({"airlight": 1, "extends": "c.json"})");
  write("c.json", R"({"airlight": 1, "extends": "b.json"})");
  EXPECT_EQ(problems_of_file(name("a.json")), name("c.json") + ":1: /extends: \"b.json\" makes a circle (" +
                                                  name("a.json") + " -> " + name("b.json") + " -> " + name("c.json") +
                                                  " -> " + name("b.json") + "); a preset cannot build on itself");
}

TEST_F(Extends, RefusesACircleThroughALink) {
  write("a.json", R"({"airlight": 1, "extends": "link.json"})");
  std::filesystem::create_symlink("a.json", folder_ / "link.json");
  EXPECT_NE(problems_of_file(name("a.json")).find("makes a circle"), std::string::npos);
}

TEST_F(Extends, RefusesABaseOfAnotherFormatOrSyntax) {
  write("base.json", R"({"airlight": 2, "media": [{"name": "a", "density": {"profile": "constant", "below_km": 1}}]})");
  EXPECT_EQ(
      problems_of_file(write("top.json", R"({"airlight": 1, "extends": "base.json"})")),
      name("base.json") + ":1: /airlight: 2 is no format that this program reads; expected 1, the format's version");
  write("broken.json", "{\n]");
  EXPECT_EQ(problems_of_file(write("top2.json", R"({"airlight": 1, "extends": "broken.json"})"))
                .substr(0, name("broken.json").size() + 15),
            name("broken.json") + ":2:1: not JSON:");
}

TEST_F(Extends, ANameTwiceInOneFileIsADuplicateThoughItIsInheritedToo) {
  write("base.json", kBase);
  EXPECT_EQ(
      problems_of_file(write("top.json", R"({"airlight": 1, "extends": "base.json", "media": [
    {"name": "air"}, {"name": "air", "density": {"profile": "constant", "below_km": 1}}]})")),
      name("top.json") + ":2: /media/2/name: \"air\" is taken by /media/0; expected a name of its own for each medium");
}

TEST_F(Extends, WrongTypesReplaceAndAreThenRefused) {
  write("base.json", kBase);
  EXPECT_EQ(problems_of_file(write("top.json", R"({"airlight": 1, "extends": "base.json", "media": {}, "planet": 3})")),
            name("top.json") + ":1: /planet: 3 is not an object; expected {...}\n" + name("top.json") +
                ":1: /media: an object is no list of media; expected an array of 1 to 8 media");
}

}  // namespace
}  // namespace airlight::test
