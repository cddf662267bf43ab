// Every refusal and its exact message.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "tests/scene/scene_fixture.h"

namespace airlight::test {
namespace {

struct Case {
  std::string_view extra;  // put into a preset of one line
  std::string_view message;
};

class Refusal : public testing::TestWithParam<Case> {};

TEST_P(Refusal, SaysWhereWhatAndWhatWasExpected) {
  EXPECT_EQ(problems_of(with_one_medium(GetParam().extra)), "test:1: " + std::string(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, Refusal,
    testing::Values(
        Case{R"("planet": {"radius_km": 0})", "/planet/radius_km: 0 is outside 0.001 to 1e7 km"},
        Case{R"("planet": {"radius_km": -1})", "/planet/radius_km: -1 is outside 0.001 to 1e7 km"},
        Case{R"("planet": {"radius_km": 1e300})", "/planet/radius_km: 1e300 is outside 0.001 to 1e7 km"},
        Case{R"("planet": {"radius_km": "tall"})",
             "/planet/radius_km: \"tall\" is not a number; expected a number, 0.001 to 1e7 km"},
        Case{R"("planet": {"radius_km": null})",
             "/planet/radius_km: null is not a number; expected a number, 0.001 to 1e7 km"},
        Case{R"("planet": {"radius_km": true})",
             "/planet/radius_km: true is not a number; expected a number, 0.001 to 1e7 km"},
        Case{R"("planet": {"radius_km": [1]})",
             "/planet/radius_km: an array of 1 is not a number; expected a number, 0.001 to 1e7 km"},
        Case{R"("planet": {"radius_km": {}})",
             "/planet/radius_km: an object is not a number; expected a number, 0.001 to 1e7 km"},
        Case{R"("planet": {"refraction": {"n_minus_1": 0.011, "scale_height_km": 8}})",
             "/planet/refraction/n_minus_1: 0.011 is outside 0 to 0.01"},
        Case{R"("planet": {"refraction": {"n_minus_1": -1e-4, "scale_height_km": 8}})",
             "/planet/refraction/n_minus_1: -0.0001 is outside 0 to 0.01"},
        Case{R"("planet": {"refraction": {"n_minus_1": 2.78e-4}})",
             "/planet/refraction: expected exactly one of medium and scale_height_km, by which n - 1 falls with "
             "altitude"},
        Case{
            R"("planet": {"refraction": {"n_minus_1": 2.78e-4, "medium": "argon"}})",
            "/planet/refraction/medium: no medium has this name; expected one of air, or scale_height_km in its place"},
        Case{R"("planet": {"refraction": {"n_minus_1": 2e-3, "scale_height_km": 8}})",
             "/planet/refraction: a level ray at 0 km is bent by 1.59 of the planet's curvature; expected at most "
             "0.95: give a smaller n_minus_1 or a greater scale height"},
        Case{R"("planet": {"atmosphere_height_km": 0})", "/planet/atmosphere_height_km: 0 is outside 0.001 to 1e7 km"},
        Case{R"("sun": {"elevation_deg": 90.5})", "/sun/elevation_deg: 90.5 is outside -90 to 90 degrees"},
        Case{R"("moon": {"elevation_deg": 91, "azimuth_deg": 0})",
             "/moon/elevation_deg: 91 is outside -90 to 90 degrees"},
        Case{R"("stars": {"magnitude_limit": 7})", "/stars/magnitude_limit: 7 is outside -2 to 6.5"},
        Case{R"("night_sky": {"airglow": -1})", "/night_sky/airglow: -1 is outside 0 to 10000"},
        Case{R"("night_sky": {"light_pollution_cd_per_m2": 2000})",
             "/night_sky/light_pollution_cd_per_m2: 2000 is outside 0 to 1000 cd/m2"},
        Case{R"("night_sky": {"lamps": "neon"})",
             "/night_sky/lamps: \"neon\" is unknown; expected one of \"led\", \"sodium\""},
        Case{R"("display": {"rods": true, "view": "gpu"})",
             "/display/rods: the view \"gpu\" does not know the eye's rods; take another view, or false"},
        Case{R"("camera": {"julian_date": 1e6})",
             "/camera/julian_date: 1e6 is outside 2.3054475e6 to 2.5976415e6 days"},
        Case{R"("moon": {"elevation_deg": 9, "azimuth_deg": 0, "phase_deg": 200})",
             "/moon/phase_deg: 200 is outside -180 to 180 degrees"},
        Case{R"("moon": {"elevation_deg": 9, "azimuth_deg": 0, "distance_km": 5000})",
             "/moon/distance_km: 5000 is outside 10000 to 1e7 km"},
        Case{R"("moon": {"elevation_deg": 9, "azimuth_deg": 0, "phase_deg": 20, "illuminated": 0.9})",
             "/moon/illuminated: `phase_deg` says the same in another way; give one of the two"},
        Case{R"("sun": {"elevation_deg": -21}, "moon": {"elevation_deg": 20, "azimuth_deg": 180})",
             "/moon: the full moon stands in the planet's shadow, and a lunar eclipse is not modelled; move it or the "
             "sun "
             "by a degree"},
        Case{R"("sun": {"disc": {"angular_radius_deg": 0}})",
             "/sun/disc/angular_radius_deg: 0 is outside 0.0001 to 10 degrees"},
        Case{R"("sun": {"disc": {"limb_darkening": 1.1}})", "/sun/disc/limb_darkening: 1.1 is outside 0 to 1"},
        Case{R"("camera": {"altitude_km": -0.001})",
             "/camera/altitude_km: -0.001 is outside 0 to 1e7 km; below 0 the camera is inside the planet"},
        Case{R"("camera": {"pitch_deg": 91})", "/camera/pitch_deg: 91 is outside -90 to 90 degrees"},
        Case{R"("camera": {"vertical_fov_deg": 180})",
             "/camera/vertical_fov_deg: 180 is not above 0 and below 180 degrees; a view of 180 degrees or more "
             "needs the projection \"fisheye\""},
        Case{R"("camera": {"vertical_fov_deg": 0})",
             "/camera/vertical_fov_deg: 0 is not above 0 and below 180 degrees; a view of 180 degrees or more "
             "needs the projection \"fisheye\""},
        Case{R"("camera": {"projection": "fisheye", "vertical_fov_deg": 360.5})",
             "/camera/vertical_fov_deg: 360.5 is not above 0 and at most 360 degrees"},
        Case{R"("camera": {"projection": "equirectangular", "pitch_deg": 5})",
             "/camera/pitch_deg: 5 is not 0; an equirectangular picture cannot be tilted: set it to 0"},
        Case{R"("camera": {"projection": "equirectangular", "roll_deg": -5})",
             "/camera/roll_deg: -5 is not 0; an equirectangular picture cannot be tilted: set it to 0"},
        Case{R"("camera": {"polariser": {"angle_deg": "up"}})",
             "/camera/polariser/angle_deg: \"up\" is not a number; expected a number, -1e6 to 1e6 degrees"},
        Case{R"("camera": {"projection": "cube", "polariser": {}}, "image": {"width": 8, "height": 48})",
             "/camera/polariser: a polarising filter turns with the camera, and a cube map has none; choose the "
             "projection \"perspective\" or \"fisheye\", or remove it"},
        Case{R"("camera": {"polariser": {}}, "render": {"polarisation": false})",
             "/camera/polariser: render.polarisation is false, and light without polarisation passes all filters "
             "alike; set it to true, or remove the filter"},
        Case{R"("image": {"width": 0})", "/image/width: 0 is outside 1 to 65536 pixels"},
        Case{R"("image": {"height": 65537})", "/image/height: 65537 is outside 1 to 65536 pixels"},
        Case{R"("image": {"width": 10.5})",
             "/image/width: 10.5 is not whole; expected a whole number, 1 to 65536 pixels"},
        Case{R"("image": {"width": "1280"})",
             "/image/width: \"1280\" is not a number; expected a whole number, 1 to 65536 pixels"},
        Case{R"("image": {"width": 1e300})", "/image/width: 1e300 is outside 1 to 65536 pixels"},
        Case{R"("bloom": {"levels": 0})", "/bloom/levels: 0 is outside 1 to 16"},
        Case{R"("bloom": {"threshold": -1})", "/bloom/threshold: -1 is outside 0 to 1e9"},
        Case{R"("display": {"exposure": 0})", "/display/exposure: 0 is outside 1e-9 to 1e9"},
        Case{R"("display": {"exposure": "bright"})",
             "/display/exposure: \"bright\" is not a number; expected a number, 1e-9 to 1e9, \"auto\", \"day\" or "
             "\"lock:FRAME\""},
        Case{R"("display": {"exposure": "lock:x"})",
             "/display/exposure: \"lock:x\" is not a number; expected a number, 1e-9 to 1e9, \"auto\", \"day\" or "
             "\"lock:FRAME\""},
        Case{R"("display": {"night_ev": 11})", "/display/night_ev: 11 is outside -10 to 10 stops"},
        Case{R"("display": {"compensation_ev": 31})", "/display/compensation_ev: 31 is outside -30 to 30 stops"}));

INSTANTIATE_TEST_SUITE_P(
    Spectra, Refusal,
    testing::Values(Case{R"("planet": {"ground_albedo": 1.2})", "/planet/ground_albedo: 1.2 is outside 0 to 1"},
                    Case{R"("planet": {"ground_albedo": [0.1, 2, 0.3]})",
                         "/planet/ground_albedo/1: 2 is outside 0 to 1"},
                    Case{R"("planet": {"ground_albedo": [0.1, 0.2]})",
                         "/planet/ground_albedo: an array of 2 is not a spectrum; expected a number or an array of "
                         "three, 0 to 1, or a curve {...}"},
                    Case{R"("sun": {"irradiance": [1, "x", 1]})",
                         "/sun/irradiance/1: \"x\" is not a number; expected a number or an array of three, 0 to "
                         "1e9"},
                    Case{R"("sun": {"irradiance": -1})", "/sun/irradiance: -1 is outside 0 to 1e9"}));

INSTANTIATE_TEST_SUITE_P(
    Words, Refusal,
    testing::Values(
        Case{R"("name": 5)", "/name: 5 is not a string; expected a string"},
        Case{R"("sun": {"disc": {"visible": 1}})", "/sun/disc/visible: 1 is not a boolean; expected true or false"},
        Case{R"("sun": 30)", "/sun: 30 is not an object; expected {...}"},
        Case{R"("sun": {"disc": "big"})", "/sun/disc: \"big\" is not an object; expected {...}"},
        Case{R"("camera": {"projection": "cube", "roll_deg": 3}, "image": {"width": 8, "height": 48})",
             "/camera/roll_deg: 3 is not 0; a cube map cannot be tilted: set it to 0"},
        Case{R"("camera": {"projection": "cube"})",
             "/image: 1280x720 does not fit; a cube's stack is 1 x 6 square faces: give for example 120x720"},
        Case{R"("camera": {"projection": "cube", "cube_layout": "cross"}, "image": {"width": 30, "height": 44})",
             "/image: 30x44 does not fit; a cube's cross is 3 x 4 square faces: give for example 30x40"},
        Case{R"("camera": {"projection": "cube", "cube_layout": "strip"}, "image": {"width": 5, "height": 1})",
             "/image: 5x1 does not fit; a cube's strip is 6 x 1 square faces: give for example 6x1"},
        Case{R"("camera": {"projection": "octahedral"}, "image": {"width": 64, "height": 63})",
             "/image: 64x63 does not fit; an octahedral map is square: give for example 63x63"},
        Case{
            R"("camera": {"projection": "octahedral"}, "image": {"width": 8, "height": 8}, "bloom": {"enabled": true})",
            "/bloom/enabled: true is not possible for an octahedral map, where the glow would stop at the edges; set "
            "it to false"},
        Case{R"("camera": {"projection": "fisheye", "cube_layout": "strip"})",
             "/camera/cube_layout: not a key of \"fisheye\"; it belongs to cube: remove it"},
        Case{R"("sun": {"unit": "lumen"})",
             "/sun/unit: \"lumen\" is unknown; expected one of \"relative\", \"W/m2\", \"lux\""},
        Case{R"("camera": {"projection": "fish-eye"})",
             "/camera/projection: \"fish-eye\" is unknown; expected one of \"perspective\", \"equirectangular\", "
             "\"fisheye\", \"cube\", \"octahedral\"; did you mean \"fisheye\"?"},
        Case{R"("camera": {"projection": "panini"})",
             "/camera/projection: \"panini\" is unknown; expected one of \"perspective\", \"equirectangular\", "
             "\"fisheye\", \"cube\", \"octahedral\""},
        Case{R"("camera": {"projection": 3})",
             "/camera/projection: 3 is not a string; expected one of \"perspective\", \"equirectangular\", "
             "\"fisheye\", \"cube\", \"octahedral\""},
        Case{R"("display": {"tonemap": "ACES"})",
             "/display/tonemap: \"ACES\" is unknown; expected one of \"aces\", \"reinhard\", \"reinhard-luminance\", "
             "\"exponential\", \"clamp\", \"none\"; did you mean \"aces\"?"},
        Case{R"("display": {"view": null})", "/display/view: null is not a string; expected a string"},
        Case{R"("extends": 7)", "/extends: 7 is not a string; expected a file name or that of a built-in preset"}));

INSTANTIATE_TEST_SUITE_P(
    UnknownKeys, Refusal,
    testing::Values(
        Case{R"("planet": {"radius": 6360})", "/planet/radius: unknown key; did you mean \"radius_km\"?"},
        Case{R"("sun": {"elevatoin_deg": 3})", "/sun/elevatoin_deg: unknown key; did you mean \"elevation_deg\"?"},
        Case{R"("Camera": {})", "/Camera: unknown key; did you mean \"camera\"?"},
        Case{R"("elevation_deg": 3)", "/elevation_deg: unknown key; did you mean sun.elevation_deg?"},
        Case{R"("image": {"zzzz": 3})", "/image/zzzz: unknown key; expected one of height, white, width"},
        Case{R"("a/b~c": 3)",
             "/a~1b~0c: unknown key; expected one of $schema, airlight, bloom, camera, clouds, description, "
             "display, extends, image, "
             "media, moon, name, night_sky, planet, render, scene, sequence, sky_of_date, stars, sun"},
        Case{R"("": 3)",
             "/: unknown key; expected one of $schema, airlight, bloom, camera, clouds, description, display, "
             "extends, image, media, moon, "
             "name, night_sky, planet, render, scene, sequence, sky_of_date, stars, sun"}));

INSTANTIATE_TEST_SUITE_P(
    Methods, Refusal,
    testing::Values(
        Case{R"("render": {"method": "odrers"})",
             "/render/method: \"odrers\" is not a method; expected one of orders, still; did you mean \"orders\"?"},
        Case{R"("render": {"method": "nothing-near"})",
             "/render/method: \"nothing-near\" is not a method; expected one of orders, still"},
        Case{R"("render": {"method": 1})", "/render/method: 1 is not a string; expected the name of a method"},
        Case{R"("render": {"step": 5})", "/render/step: unknown key; did you mean \"steps\"?"},
        Case{R"("render": {"qwerty": 5})", "/render/qwerty: unknown key; `airlight methods` lists them"},
        Case{R"("render": {"smooth": true})",
             "/render/smooth: the method \"orders\" does not take this key; it belongs to still: remove it"},
        Case{R"("render": {"steps": 0})", "/render/steps: 0 is outside 1 to 4096"},
        Case{R"("render": {"steps": 1.5})", "/render/steps: 1.5 is not whole; expected a whole number, 1 to 4096"},
        Case{R"("render": {"method": "still", "steps": 65})", "/render/steps: 65 is outside 1 to 64"},
        Case{R"("render": {"method": "still", "smooth": "yes"})",
             "/render/smooth: \"yes\" is not a boolean; expected true or false"},
        Case{R"("render": {"transmittance_lut": [256, 1]})", "/render/transmittance_lut/1: 1 is outside 2 to 4096"},
        Case{R"("render": {"transmittance_lut": [256, 2.5]})",
             "/render/transmittance_lut/1: 2.5 is not whole; expected a whole number, 2 to 4096"},
        Case{R"("render": {"transmittance_lut": 256})",
             "/render/transmittance_lut: 256 is not a table size; expected [width, height], each 2 to 4096"},
        Case{R"("render": {"transmittance_lut": [1, 2, 3]})",
             "/render/transmittance_lut: an array of 3 is not a table size; expected [width, height], each 2 to 4096"},
        Case{R"("render": {"multiple_scattering_scale": -1})",
             "/render/multiple_scattering_scale: -1 is outside 0 to 1e9"},
        Case{R"("render": {"color": "wram"})",
             "/render/color: \"wram\" is unknown; expected one of \"warm\", \"cold\"; did you mean \"warm\"?"},
        Case{R"("render": {"sun_fade": 10})",
             "/render/sun_fade: 10 is not a fade; expected {\"scale\": number, \"bias\": number}"},
        Case{R"("render": {"sun_fade": {"scale": 10}})",
             "/render/sun_fade/bias: missing; expected a number, -1e9 to 1e9"},
        Case{R"("render": {"sun_fade": {"scale": 10, "bias": 0, "bais": 1}})",
             "/render/sun_fade/bais: unknown key; did you mean \"bias\"?"},
        Case{R"("render": {"sun_fade": {"scale": "x", "bias": 0}})",
             "/render/sun_fade/scale: \"x\" is not a number; expected a number, -1e9 to 1e9"},
        Case{R"("render": [])", "/render: an array of 0 is not an object; expected {...}"}));

struct MediaCase {
  std::string_view media;
  std::string_view message;
};

class MediaRefusal : public testing::TestWithParam<MediaCase> {};

TEST_P(MediaRefusal, SaysWhereWhatAndWhatWasExpected) {
  const std::string text = R"({"airlight": 1, "media": )" + std::string(GetParam().media) + "}";
  EXPECT_EQ(problems_of(text), "test:1: " + std::string(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Media, MediaRefusal,
    testing::Values(
        MediaCase{"[]", "/media: an array of 0 is no list of media; expected an array of 1 to 8 media"},
        MediaCase{"{}", "/media: an object is no list of media; expected an array of 1 to 8 media"},
        MediaCase{"[1,2,3,4,5,6,7,8,9]",
                  "/media: an array of 9 is no list of media; expected an array of 1 to 8 media"},
        MediaCase{R"([{"density": {"profile": "constant", "below_km": 1}}])",
                  "/media/0/name: missing; expected a string of at least one character"},
        MediaCase{R"([{"name": "", "density": {"profile": "constant", "below_km": 1}}])",
                  "/media/0/name: empty; expected a string of at least one character"},
        MediaCase{R"([{"name": "a", "density": {"profile": "constant", "below_km": 1}},)"
                  R"({"name": "a", "density": {"profile": "constant", "below_km": 1}}])",
                  "/media/1/name: \"a\" is taken by /media/0; expected a name of its own for each medium"},
        MediaCase{R"([{"name": "a"}])",
                  "/media/0/density/profile: missing; expected one of \"exponential\", \"tent\", \"lorentzian\", "
                  "\"constant\", \"layers\", \"height-fog\""},
        MediaCase{R"([{"name": "a", "density": 1}])", "/media/0/density: 1 is not an object; expected {...}"},
        MediaCase{R"([{"name": "a", "density": {"profile": "linear"}}])",
                  "/media/0/density/profile: \"linear\" is unknown; expected one of \"exponential\", \"tent\", "
                  "\"lorentzian\", \"constant\", \"layers\", \"height-fog\""},
        MediaCase{R"([{"name": "a", "density": {"profile": "tent", "center_km": 25}}])",
                  "/media/0/density/half_width_km: missing for \"tent\"; expected a number, 1e-6 to 1e7 km"},
        MediaCase{R"([{"name": "a", "density": {"profile": "constant", "below_km": 1, "scale_height_km": 8}}])",
                  "/media/0/density/scale_height_km: not a key of \"constant\"; it belongs to exponential, "
                  "lorentzian, height-fog: remove it"},
        MediaCase{R"([{"name": "a", "density": {"profile": "height-fog", "base_km": -1, "scale_height_km": 1}}])",
                  "/media/0/density/base_km: -1 is outside 0 to 1e7 km"},
        MediaCase{R"([{"name": "a", "density": {"profile": "exponential", "scale_height": 8, "scale_height_km": 8}}])",
                  "/media/0/density/scale_height: unknown key; did you mean \"scale_height_km\"?"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": []}}])",
                  "/media/0/density/layers: empty; expected an array of [altitude_km, density], altitudes ascending"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": 3}}])",
                  "/media/0/density/layers: 3 is not an array; expected an array of [altitude_km, density], altitudes "
                  "ascending"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": [[0, 1], [5, 1], [5, 0]]}}])",
                  "/media/0/density/layers/2/0: 5 is not above the layer before it (5 km); expected ascending "
                  "altitudes"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": [[0, 1], 5]}}])",
                  "/media/0/density/layers/1: 5 is not a layer; expected [altitude_km, density]"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": [[0, -1]]}}])",
                  "/media/0/density/layers/0/1: -1 is outside 0 to 1e6"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": [[-1, 1]]}}])",
                  "/media/0/density/layers/0/0: -1 is outside 0 to 1e7 km"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": [["low", 1]]}}])",
                  "/media/0/density/layers/0/0: \"low\" is not a number; expected a number, 0 to 1e7 km"},
        MediaCase{R"([{"name": "a", "density": {"profile": "layers", "layers": [[0, "x"]]}}])",
                  "/media/0/density/layers/0/1: \"x\" is not a number; expected 0 to 1e6"},
        MediaCase{R"([{"name": "a", "density": {"profile": "constant", "below_km": 1}, "phase": {"g": 1.2}}])",
                  "/media/0/phase/g: 1.2 is outside -0.99 to 0.99"},
        MediaCase{R"([{"name": "a", "density": {"profile": "constant", "below_km": 1}, "scattering_per_km": -1}])",
                  "/media/0/scattering_per_km: -1 is outside 0 to 100000 per km"},
        MediaCase{R"([{"name": "a", "density": {"profile": "constant", "below_km": 1}, "phase": {"function": "mie"}}])",
                  "/media/0/phase/function: \"mie\" is unknown; expected one of \"rayleigh\", \"henyey-greenstein\", "
                  "\"cornette-shanks\", \"schlick\", \"isotropic\", \"table\", \"drops\""}));

TEST(Refusals, NameTheMissingVersionAndMedia) {
  EXPECT_EQ(problems_of("{}"),
            "test:1: /airlight: missing; expected 1\n"
            "test:1: /media: missing; expected an array of 1 to 8 media: write \"media\": [...] or build on a preset "
            "that has it, e.g. \"extends\": \"earth\"");
}

TEST(Refusals, NameAnUnreadableVersion) {
  for (const std::string_view version : {"2", "\"1\"", "1.5", "null"}) {
    const std::string text = R"({"airlight": )" + std::string(version) +
                             R"(, "media": [{"name": "a", "density": {"profile": "constant", "below_km": 1}}]})";
    EXPECT_EQ(problems_of(text), "test:1: /airlight: " + std::string(version) +
                                     " is no format that this program reads; expected 1, the format's version");
  }
}

TEST(Refusals, ComeAllAtOnceInTheOrderOfTheLines) {
  EXPECT_EQ(problems_of("{\n"
                        "  \"airlight\": 1,\n"
                        "  \"sun\": {\"elevation_deg\": 100},\n"
                        "  \"media\": [\n"
                        "    {\"name\": \"a\", \"density\": {\"profile\": \"tent\"}},\n"
                        "    {\"name\": \"b\", \"phase\": {\"g\": 2}, \"density\": {\"profile\": \"constant\",\n"
                        "      \"below_km\": 0}}\n"
                        "  ],\n"
                        "  \"colour\": 1\n"
                        "}\n"),
            "test:3: /sun/elevation_deg: 100 is outside -90 to 90 degrees\n"
            "test:5: /media/0/density/center_km: missing for \"tent\"; expected a number, 0 to 1e7 km\n"
            "test:5: /media/0/density/half_width_km: missing for \"tent\"; expected a number, 1e-6 to 1e7 km\n"
            "test:6: /media/1/phase/g: 2 is outside -0.99 to 0.99\n"
            "test:7: /media/1/density/below_km: 0 is outside 1e-6 to 1e7 km\n"
            "test:9: /colour: unknown key; expected one of $schema, airlight, bloom, camera, clouds, description, "
            "display, extends, "
            "image, media, moon, name, night_sky, planet, render, scene, sequence, sky_of_date, stars, sun");
}

TEST(Refusals, CountTheLayersOfAllMediaTogether) {
  const auto medium = [](const std::string& name, int count) {
    std::string layers;
    for (int i = 0; i < count; ++i) {
      layers += (layers.empty() ? "[" : ",[") + std::to_string(i) + ",1]";
    }
    return R"({"name": ")" + name + R"(", "density": {"profile": "layers", "layers": [)" + layers + "]}}";
  };
  const auto both = [&](int a, int b) {
    return R"({"airlight": 1, "media": [)" + medium("a", a) + "," + medium("b", b) + "]}";
  };
  EXPECT_EQ(problems_of(both(128, 128)), "");
  EXPECT_EQ(problems_of(both(128, 129)),
            "test:1: /media: 257 density layers in all; expected at most 256 over all media");
}

TEST(Refusals, ShortenLongTexts) {
  const std::string message =
      problems_of(with_one_medium(R"("sun": {"elevation_deg": ")" + std::string(500, 'x') + "\"}"));
  EXPECT_EQ(message, "test:1: /sun/elevation_deg: \"" + std::string(80, 'x') +
                         "...\" is not a number; expected a number, -90 to 90 degrees");
}

TEST(Refusals, AnUnknownMethodHidesNoMisspeltKey) {
  EXPECT_EQ(problems_of(with_one_medium(R"("render": {"method": "x", "steps": 0, "stesp": 1})")),
            "test:1: /render/method: \"x\" is not a method; expected one of orders, still\n"
            "test:1: /render/stesp: unknown key; did you mean \"steps\"?");
}

}  // namespace
}  // namespace airlight::test
