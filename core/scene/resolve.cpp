#include "core/scene/resolve.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/scene/angle.h"
#include "core/scene/json_text.h"
#include "core/scene/readers.h"
#include "core/scene/render_settings.h"

namespace airlight {
namespace {

Planet read_planet(const Section& planet) {
  planet.refuse_unknown_keys();
  Planet read;
  planet.fill(read);
  return read;
}

Sun read_sun(const Section& root, SceneSpectra& spectra) {
  const Section section = root.child("sun");
  section.refuse_unknown_keys();
  const Section disc = section.child("disc");
  disc.refuse_unknown_keys();
  Sun sun;
  section.fill(sun);
  disc.fill(sun.disc);
  sun.irradiance = root.curves().read(section, "irradiance");
  spectra.irradiance = sun.irradiance[0];
  spectra.sun = root.curves().read_shape(section, "spectrum");
  return sun;
}

// "auto", "day" or "lock:FRAME"; false where the value is none of them.
bool read_metering(const PresetValue& value, Display& display) {
  constexpr std::string_view kLock = "lock:";
  const auto* word = std::get_if<std::string>(&value.data);
  if (word == nullptr) {
    return false;
  }
  if (word->starts_with(kLock)) {
    display.metered_frame = number_from<int>(word->substr(kLock.size())).value_or(-1);
    display.metering = Metering::frame;
    return display.metered_frame >= 0;
  }
  display.metering = *word == "day" ? Metering::day : Metering::picture;
  return *word == "auto" || *word == "day";
}

Display read_display(const Section& root) {
  const Section section = root.child("display");
  section.refuse_unknown_keys();
  Display display;
  if (const PresetValue* exposure = section.find("exposure");
      exposure != nullptr && !read_metering(*exposure, display)) {
    read_number(section.site("exposure", *exposure), display.exposure.emplace());
  }
  section.fill(display);
  if (const PresetValue* rods = section.find("rods"); rods != nullptr && display.rods && display.view == "gpu") {
    section.complain("rods", *rods, "the view \"gpu\" does not know the eye's rods; take another view, or false");
  }
  return display;
}

void check_root(const Section& root) {
  root.refuse_unknown_keys();
  if (const PresetValue* version = root.value_of("airlight")) {
    const auto* number = std::get_if<double>(&version->data);
    if (number == nullptr || *number != 1.0) {
      root.complain("airlight", *version,
                    quoted(*version) + " is no format that this program reads; expected 1, the format's version");
    }
  }
  root.text("$schema");
  root.boolean("sky_of_date");  // read where a date is given
  // Loading a file removes the key once it has been followed.
  if (const PresetValue* extends = root.find("extends")) {
    const bool is_text = std::holds_alternative<std::string>(extends->data);
    root.complain("extends", *extends,
                  quoted(*extends) + (is_text ? " comes too late; `extends` is followed in a preset's file only"
                                              : " is not a string; expected a file name or that of a built-in preset"));
  }
}

// The keys that determine how curves become colours; without curves they have no effect.
void read_colours(const Section& root, bool has_curves, SceneSpectra& spectra) {
  for (const char* key : {"image", "render"}) {
    const PresetValue* value = root.find(key);
    if (value != nullptr && !std::holds_alternative<PresetObject>(value->data)) {
      return;  // reported where the section is read
    }
  }
  const Section image = root.child("image");
  const Section render = root.child("render");
  image.fill(spectra);
  const PresetValue* count = render.find("wavelengths");
  const auto* word = count == nullptr ? nullptr : std::get_if<std::string>(&count->data);
  if (count != nullptr && (word == nullptr || *word != "auto")) {
    read_integer(render.site("wavelengths", *count), spectra.wavelengths);
  }
  if (has_curves) {
    return;
  }
  constexpr std::string_view kIdle =
      "means nothing in a scene of three channels; give a curve to a medium, the ground or the sun, or remove it";
  if (const PresetValue* white = image.find("white"); white != nullptr && !white->inherited) {
    image.complain("white", *white, kIdle);
  }
  if (count != nullptr && !count->inherited) {
    render.complain("wavelengths", *count, kIdle);
  }
}

// Three channels that stand for the curves where code reads channels.
void fill_channels(Scene& scene) {
  const SceneSpectra& spectra = *scene.spectra;
  const Nodes nodes = nodes_for(3);
  const Rgb sun = sun_colour(band_colours(spectra.sun, spectra.white));
  for_each_spectral_value(scene, [&](SpectralValue& value) {
    for (std::size_t c = 0; c < 3; ++c) {
      value[c] = at_node(value.curve, nodes, 2 - c);
    }
  });
  for (std::size_t c = 0; c < 3; ++c) {
    for (Medium& medium : scene.media) {
      medium.phase_wavelengths[c] = nodes.nm[2 - c];
    }
    scene.sun.irradiance[c] *= sun[c];
  }
}

// Everything but the key frames.
Scene read_scene(const Section& root, std::span<const MethodInfo> methods) {
  check_root(root);
  Scene scene;
  root.fill(scene);
  const CurveReader& curves = root.curves();
  SceneSpectra spectra;
  const Section planet = root.child("planet");
  scene.planet = read_planet(planet);
  scene.terrain = read_terrain(planet, scene.planet);
  scene.ground = read_ground_map(planet);
  scene.spheres = read_spheres(root);
  scene.media = read_media(root, scene.planet);
  scene.clouds = read_clouds(root, scene.planet, scene.media);
  scene.planet.refraction = read_refraction(planet, scene.planet, scene.media);
  scene.sun = read_sun(root, spectra);
  scene.moon = read_moon(root, scene);
  if (scene.moon) {
    cover_the_sun(scene.sun, *scene.moon);
  }
  scene.night_sky = read_night_sky(root);
  scene.stars = read_stars(root);
  scene.camera = read_camera(root);
  scene.image = read_image(root, scene.camera);
  scene.render = read_render_settings(root, methods);
  read_colours(root, curves.any(), spectra);
  curves.refuse_channels();
  if (curves.any() && !root.problems().any()) {
    scene.spectra = std::move(spectra);
    fill_channels(scene);
  } else {
    for_each_spectral_value(scene, [](SpectralValue& value) { value.curve = {}; });
  }
  if (scene.moon) {
    const SceneSpectra& by = scene.spectra ? *scene.spectra : spectra;
    scene.moon->irradiance = moon_irradiance(*scene.moon, scene.sun, band_colours(by.sun, by.white));
  }
  refuse_misfits(root, scene, methods);
  scene.bloom = read_bloom(root, scene.camera);
  scene.display = read_display(root);
  return scene;
}

// Where the frame has what stands at the preset's pointer: a key of its own, or a part of its value; `made`: or what it
// made on the way to its key.
std::optional<std::string> pointer_in_frame(const FrameValues& frame, const std::string& pointer, bool made) {
  for (const auto& [key, values] : frame.values) {
    const bool is_part = (pointer + "/").starts_with(key + "/");
    if (is_part || (made && (key + "/").starts_with(pointer + "/"))) {
      return pointer_below(frame.pointer, key) + (is_part ? pointer.substr(key.size()) : "");
    }
  }
  return std::nullopt;
}

// Checks each key frame's values in the preset. Where all is well without them, an error found then is an error in
// them.
void check_key_frames(const Preset& preset, const KeyFrames& sequence, std::span<const MethodInfo> methods,
                      Problems& problems) {
  const bool sound = !problems.any();
  for_each_key_frame(preset, sequence, [&](const Preset& frame, const FrameValues& values) {
    problems.tell_pointers([&](std::string_view given) {
      const std::string pointer(given);
      const std::optional<std::string> own = pointer_in_frame(values, pointer, sound);
      return own || !sound ? own : pointer;
    });
    CurveReader curves;
    read_scene(Section(problems, curves, &frame.root, frame.root, "", ""), methods);
  });
  problems.tell_pointers({});
}

}  // namespace

Scene resolve(const Preset& preset, std::span<const MethodInfo> methods) {
  Problems problems;
  CurveReader curves;
  const Section root(problems, curves, &preset.root, preset.root, "", "");
  Scene scene = read_scene(root, methods);
  scene.sequence = read_key_frames(root, methods);
  try {
    if (scene.sequence) {
      check_key_frames(preset, *scene.sequence, methods, problems);
    }
  } catch (const InputError&) {  // a frame's pointer leads nowhere, perhaps by another fault
    problems.throw_if_any();
    throw;
  }
  problems.throw_if_any();
  return scene;
}

}  // namespace airlight
