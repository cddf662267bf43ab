#include "core/scene/resolve.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>

#include "core/scene/air_limits.h"
#include "core/scene/angle.h"
#include "core/scene/curve_reader.h"
#include "core/scene/density_column.h"
#include "core/scene/ground_reader.h"
#include "core/scene/json_format.h"
#include "core/scene/json_text.h"
#include "core/scene/key_frame_reader.h"
#include "core/scene/phase_reader.h"
#include "core/scene/printable.h"
#include "core/scene/problems.h"
#include "core/scene/render_settings.h"
#include "core/scene/section.h"
#include "core/scene/sphere_reader.h"
#include "core/scene/terrain_reader.h"
#include "core/text.h"

namespace airlight {
namespace {

Planet read_planet(const Section& root, CurveReader& curves, SceneSpectra& spectra) {
  const Section planet = root.child("planet");
  planet.refuse_unknown_keys();
  return {.ground_radius = planet.number("radius_km"),
          .atmosphere_height = planet.number("atmosphere_height_km"),
          .ground_albedo = curves.read(planet, "ground_albedo", spectra.ground_albedo)};
}

// One [altitude, density] pair after the one before it.
void read_layer(const Site& layers, std::size_t index, std::vector<DensityLayer>& out) {
  const PresetValue& value = std::get<PresetArray>(layers.value.data)[index];
  const std::string pointer = pointer_below(layers.pointer, std::to_string(index));
  const auto* pair = std::get_if<PresetArray>(&value.data);
  if (pair == nullptr || pair->size() != 2) {
    layers.problems.add(value, pointer, quoted(value) + " is not a layer; expected [altitude_km, density]");
    return;
  }
  const Rule altitude{.key = {}, .range = kLayerAltitude, .unit = "km"};
  DensityLayer layer;
  read_number({layers.problems, (*pair)[0], pointer_below(pointer, "0"), altitude}, layer.altitude);
  read_number({layers.problems, (*pair)[1], pointer_below(pointer, "1"), layers.rule}, layer.density);
  if (!out.empty() && layer.altitude <= out.back().altitude) {
    layers.problems.add((*pair)[0], pointer_below(pointer, "0"),
                        format_number(layer.altitude) + " is not above the layer before it (" +
                            format_number(out.back().altitude) + " km); expected ascending altitudes");
  }
  out.push_back(layer);
}

std::vector<DensityLayer> read_layers(const Section& density) {
  const PresetValue* value = density.value_of("layers");
  if (value == nullptr) {
    return {};
  }
  const Site site = density.site("layers", *value);
  const auto* array = std::get_if<PresetArray>(&value->data);
  if (array == nullptr || array->empty()) {
    site.complain((array == nullptr ? quoted(*value) + " is not an array" : "empty") + "; expected " +
                  expectation(site.rule));
    return {};
  }
  std::vector<DensityLayer> layers;
  for (std::size_t i = 0; i < array->size(); ++i) {
    read_layer(site, i, layers);
  }
  return layers;
}

Density read_density(const Section& medium) {
  Section section = medium.child("density");
  section.refuse_unknown_keys();
  const auto profile = section.choice("profile");
  Density density;
  if (!profile) {
    return density;
  }
  density.profile = static_cast<DensityProfile>(*profile);
  section.choose(kProfileNames[*profile]);
  switch (density.profile) {
    case DensityProfile::exponential:
      density.scale_height = section.number("scale_height_km");
      break;
    case DensityProfile::tent:
      density.center = section.number("center_km");
      density.half_width = section.number("half_width_km");
      break;
    case DensityProfile::lorentzian:
      density.scale_height = section.number("scale_height_km");
      density.center = section.number("center_km");
      density.half_width = section.number("half_width_km");
      break;
    case DensityProfile::constant:
      density.below = section.number("below_km");
      break;
    case DensityProfile::layers:
      density.layers = read_layers(section);
      break;
    case DensityProfile::height_fog:
      density.scale_height = section.number("scale_height_km");
      density.below = section.number("base_km");
      break;
  }
  return density;
}

Medium read_medium(const Section& section, double top, CurveReader& curves, SceneSpectra& spectra) {
  section.refuse_unknown_keys();
  Medium medium;
  medium.name = section.text("name");
  medium.density = read_density(section);
  MediumSpectra& own = spectra.media.emplace_back();
  medium.scattering = curves.read(section, "scattering_per_km", own.scattering);
  medium.absorption = curves.read(section, "absorption_per_km", density_column(medium.density, top), own.absorption);
  read_phase(section.child("phase"), medium, own, curves);
  return medium;
}

// Told by its quantity; asked only where every number of it is within its range.
void refuse_opaque(const PresetArray& array, const std::vector<Medium>& media, const std::vector<MediumSpectra>& curves,
                   double top, Problems& problems) {
  for (std::size_t i = 0; i < media.size(); ++i) {
    double depth = optical_depth_of(media[i], top);
    for (const WaveBand& band : fine_bands()) {
      const double here =
          mean_over(curves[i].scattering, band.low, band.high) + mean_over(curves[i].absorption, band.low, band.high);
      depth = std::max(depth, here * column_km(media[i].density, top));
    }
    if (depth > kMostOpticalDepth) {
      problems.add(array[i], "/media/" + std::to_string(i),
                   "its vertical optical depth is " + rounded(depth, 3) + "; expected at most " +
                       format_number(kMostOpticalDepth) + ": lower its coefficients, its density or its height");
    }
  }
}

std::vector<Medium> read_media(const Section& root, const Planet& planet, CurveReader& curves, SceneSpectra& spectra) {
  const PresetValue* value = root.find("media");
  if (value == nullptr) {
    root.problems().add(root.context(), "/media",
                        "missing; expected an array of 1 to 8 media: write \"media\": [...] or build on a preset that "
                        "has it, e.g. \"extends\": \"earth\"");
    return {};
  }
  const auto* array = std::get_if<PresetArray>(&value->data);
  const Rule& rule = root.rule("media");
  if (array == nullptr || !rule.range.contains(static_cast<double>(array->size()))) {
    root.complain("media", *value, quoted(*value) + " is no list of media; expected " + expectation(rule));
    return {};
  }
  std::vector<Medium> media;
  std::map<std::string, std::size_t, std::less<>> seen;
  std::size_t layer_count = 0;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const Section section = root.element("media", *array, i);
    media.push_back(read_medium(section, planet.atmosphere_height, curves, spectra));
    const std::string& name = media.back().name;
    const auto [first, is_new] = seen.emplace(name, i);
    if (!name.empty() && !is_new) {
      section.complain("name", *section.find("name"),
                       quoted_text(name) + " is taken by /media/" + std::to_string(first->second) +
                           "; expected a name of its own for each medium");
    }
    layer_count += media.back().density.layers.size();
  }
  if (layer_count > static_cast<std::size_t>(kMaxDensityLayers)) {
    root.complain("media", *value,
                  std::to_string(layer_count) + " density layers in all; expected at most " +
                      std::to_string(kMaxDensityLayers) + " over all media");
  }
  if (!root.problems().any()) {
    refuse_opaque(*array, media, spectra.media, planet.atmosphere_height, root.problems());
  }
  return media;
}

Sun read_sun(const Section& root, CurveReader& curves, SceneSpectra& spectra) {
  const Section section = root.child("sun");
  section.refuse_unknown_keys();
  const Section disc = section.child("disc");
  disc.refuse_unknown_keys();
  Sun sun;
  sun.elevation = radians_from_degrees(section.number("elevation_deg"));
  sun.azimuth = radians_from_degrees(section.number("azimuth_deg"));
  Curve irradiance;
  sun.irradiance = curves.read(section, "irradiance", irradiance);
  spectra.irradiance = sun.irradiance[0];
  spectra.sun = curves.read_shape(section, "spectrum");
  sun.unit = static_cast<SunUnit>(section.choice("unit").value_or(0));
  sun.disc = {.visible = disc.boolean("visible"),
              .angular_radius = radians_from_degrees(disc.number("angular_radius_deg")),
              .limb_darkening = disc.number("limb_darkening"),
              .radiance_scale = disc.number("radiance_scale")};
  return sun;
}

std::string_view name_of_map(Projection projection) {
  switch (projection) {
    case Projection::cube:
      return "a cube map";
    case Projection::octahedral:
      return "an octahedral map";
    default:
      return "an equirectangular picture";
  }
}

// A map is the whole sphere in its upright frame; a tilt would have to be thrown away.
void refuse_tilt(const Section& camera, std::string_view key, Projection projection) {
  const PresetValue* value = camera.find(key);
  const auto* degrees = value == nullptr ? nullptr : std::get_if<double>(&value->data);
  if (degrees != nullptr && *degrees != 0.0) {
    camera.complain(key, *value,
                    format_number(*degrees) + " is not 0; " + std::string(name_of_map(projection)) +
                        " cannot be tilted: set it to 0");
  }
}

Camera read_camera(const Section& root) {
  Section section = root.child("camera");
  section.refuse_unknown_keys();
  Camera camera;
  camera.altitude = section.number("altitude_km");
  camera.latitude = radians_from_degrees(section.number("latitude_deg"));
  camera.longitude = radians_from_degrees(section.number("longitude_deg"));
  camera.azimuth = radians_from_degrees(section.number("azimuth_deg"));
  camera.pitch = radians_from_degrees(section.number("pitch_deg"));
  camera.roll = radians_from_degrees(section.number("roll_deg"));
  const auto projection = section.choice("projection");
  if (!projection) {
    return camera;
  }
  camera.projection = static_cast<Projection>(*projection);
  section.choose(kProjectionNames[*projection]);
  const double field_of_view = radians_from_degrees(section.number("vertical_fov_deg"));
  if (camera.projection == Projection::cube) {
    camera.cube_layout = static_cast<CubeLayout>(section.choice("cube_layout").value_or(0));
  }
  if (is_map(camera.projection)) {
    refuse_tilt(section, "pitch_deg", camera.projection);
    refuse_tilt(section, "roll_deg", camera.projection);
  } else {
    camera.vertical_fov = field_of_view;
  }
  return camera;
}

// Empty where the size suits the projection, else what it should be, with the nearest that suits.
std::string wanted_size(const Camera& camera, const ImageSize& image) {
  if (!is_cut(camera.projection)) {
    return {};
  }
  ImageSize cells{1, 1};
  std::string what = "an octahedral map is square";
  if (camera.projection == Projection::cube) {
    const std::array<ImageSize, 3> layouts = {{{1, 6}, {6, 1}, {3, 4}}};
    cells = layouts.at(static_cast<std::size_t>(camera.cube_layout));
    what = "a cube's " + std::string(kCubeLayoutNames.at(static_cast<std::size_t>(camera.cube_layout))) + " is " +
           std::to_string(cells.width) + " x " + std::to_string(cells.height) + " square faces";
  }
  const int side = std::max(1, std::min(image.width / cells.width, image.height / cells.height));
  if (image.width == side * cells.width && image.height == side * cells.height) {
    return {};
  }
  return what + ": give for example " + std::to_string(side * cells.width) + "x" + std::to_string(side * cells.height);
}

ImageSize read_image(const Section& root, const Camera& camera) {
  const Section section = root.child("image");
  section.refuse_unknown_keys();
  const ImageSize image{.width = section.integer("width"), .height = section.integer("height")};
  if (const std::string wanted = wanted_size(camera, image); !wanted.empty()) {
    const PresetValue* place = section.find("width") != nullptr ? section.find("width") : section.find("height");
    root.problems().add(place != nullptr ? *place : root.context(), "/image",
                        std::to_string(image.width) + "x" + std::to_string(image.height) + " does not fit; " + wanted);
  }
  return image;
}

Bloom read_bloom(const Section& root, const Camera& camera) {
  const Section section = root.child("bloom");
  section.refuse_unknown_keys();
  Bloom bloom;
  bloom.enabled = section.boolean("enabled");
  bloom.in_exr = bloom.enabled && section.find("enabled") != nullptr;
  if (is_cut(camera.projection)) {
    if (bloom.in_exr) {
      section.complain("enabled", *section.find("enabled"),
                       "true is not possible for " + std::string(name_of_map(camera.projection)) +
                           ", where the glow would stop at the edges; set it to false");
    }
    bloom.enabled = false;
    bloom.in_exr = false;
  }
  bloom.model = static_cast<BloomModel>(section.choice("model").value_or(0));
  bloom.threshold = section.number("threshold");
  bloom.intensity = section.number("intensity");
  bloom.levels = section.integer("levels");
  return bloom;
}

// "auto", "day" or "lock:FRAME"; false where the value is none of them.
bool read_metering(const PresetValue& value, Display& display) {
  constexpr std::string_view kLock = "lock:";
  const auto* word = std::get_if<std::string>(&value.data);
  if (word == nullptr) {
    return false;
  }
  if (word->starts_with(kLock)) {
    const char* const end = word->data() + word->size();
    const auto parsed = std::from_chars(word->data() + kLock.size(), end, display.metered_frame);
    display.metering = Metering::frame;
    return parsed.ec == std::errc() && parsed.ptr == end && display.metered_frame >= 0;
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
  display.compensation = section.number("compensation_ev");
  display.display = section.text("display");
  display.view = section.text("view");
  display.tonemap = static_cast<ToneCurve>(section.choice("tonemap").value_or(0));
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
  // Loading a file takes the key out once it has been followed.
  if (const PresetValue* extends = root.find("extends")) {
    const bool is_text = std::holds_alternative<std::string>(extends->data);
    root.complain("extends", *extends,
                  quoted(*extends) + (is_text ? " comes too late; `extends` is followed in a preset's file only"
                                              : " is not a string; expected a file name or that of a built-in preset"));
  }
}

// What says how curves become colours; without curves it says nothing.
void read_colours(const Section& root, bool has_curves, SceneSpectra& spectra) {
  for (const char* key : {"image", "render"}) {
    const PresetValue* value = root.find(key);
    if (value != nullptr && !std::holds_alternative<PresetObject>(value->data)) {
      return;  // reported where the section is read
    }
  }
  const Section image = root.child("image");
  const Section render = root.child("render");
  spectra.white = static_cast<White>(image.choice("white").value_or(0));
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

// What stands for the curves where three channels are looked at.
void fill_channels(Scene& scene) {
  const SceneSpectra& spectra = *scene.spectra;
  const Nodes nodes = nodes_for(3);
  const Rgb sun = sun_colour(band_colours(spectra.sun, spectra.white));
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t k = 2 - c;
    for (std::size_t i = 0; i < scene.media.size(); ++i) {
      scene.media[i].scattering[c] = at_node(spectra.media[i].scattering, nodes, k);
      scene.media[i].absorption[c] = at_node(spectra.media[i].absorption, nodes, k);
      scene.media[i].depolarization[c] = at_node(spectra.media[i].depolarization, nodes, k);
      scene.media[i].phase_wavelengths[c] = nodes.nm[k];
    }
    scene.planet.ground_albedo[c] = at_node(spectra.ground_albedo, nodes, k);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
      scene.spheres[i].albedo[c] = at_node(spectra.spheres[i], nodes, k);
    }
    scene.sun.irradiance[c] *= sun[c];
  }
}

// The methods that know a thing, where the scene's does not; else nothing.
std::string who_knows(const Scene& scene, bool MethodInfo::*knows, std::span<const MethodInfo> methods) {
  std::string names;
  for (const MethodInfo& method : methods) {
    if (method.name == scene.render.method && method.*knows) {
      return {};
    }
    names += method.*knows ? (names.empty() ? "" : ", ") + std::string(method.name) : "";
  }
  return names;
}

// What spheres do not go with: a method that knows none, terrain.
void refuse_spheres_beside(const Section& root, const Scene& scene, std::span<const MethodInfo> methods) {
  const Section section = root.child("scene");
  const PresetValue& spheres = *section.find("spheres");
  if (const std::string names = who_knows(scene, &MethodInfo::knows_spheres, methods); !names.empty()) {
    section.complain("spheres", spheres,
                     "the method " + json_string(scene.render.method) + " knows no spheres; choose " + names +
                         " with render.method or --method, or remove the spheres");
  }
  if (scene.terrain) {
    section.complain("spheres", spheres,
                     "there is planet.terrain beside them, and neither would see the other; remove one of the two");
  }
}

// What terrain does not go with: a method that knows none, curves over the wavelength.
void refuse_terrain_beside(const Section& root, const Scene& scene, bool curves, std::span<const MethodInfo> methods) {
  if (curves) {
    const Section planet = root.child("planet");
    planet.complain(
        "terrain", *planet.find("terrain"),
        "is lit in three channels alone, and this preset has curves over the wavelength; give media, ground "
        "and sun by three channels, or remove the terrain");
  }
  if (const std::string names = who_knows(scene, &MethodInfo::knows_terrain, methods); !names.empty()) {
    const Section planet = root.child("planet");
    planet.complain("terrain", *planet.find("terrain"),
                    "the method " + json_string(scene.render.method) + " knows no terrain; choose " + names +
                        " with render.method or --method, or remove the terrain");
  }
}

// What a ground by maps does not go with: a method that knows none, curves over the wavelength, terrain, spheres.
void refuse_ground_map_beside(const Section& root, const Scene& scene, bool curves,
                              std::span<const MethodInfo> methods) {
  const Section planet = root.child("planet");
  const char* key = planet.find("albedo_map") != nullptr ? "albedo_map" : "ocean";
  const auto complain = [&](const std::string& what) { planet.complain(key, *planet.find(key), what); };
  if (curves) {
    complain(
        "is lit in three channels alone, and this preset has curves over the wavelength; give media, ground and sun by "
        "three channels, or remove it");
  }
  if (const std::string names = who_knows(scene, &MethodInfo::knows_ground_maps, methods); !names.empty()) {
    complain("the method " + json_string(scene.render.method) + " knows one albedo alone; choose " + names +
             " with render.method or --method, or remove it");
  }
  if (scene.terrain || !scene.spheres.empty()) {
    complain(std::string("there ") + (scene.terrain ? "is planet.terrain" : "are scene.spheres") +
             " beside it, and neither would see the other; remove one of the two");
  }
}

// Everything but the key frames.
Scene read_scene(const Section& root, std::span<const MethodInfo> methods) {
  check_root(root);
  Scene scene;
  scene.name = root.text("name");
  scene.description = root.text("description");
  CurveReader curves;
  SceneSpectra spectra;
  scene.planet = read_planet(root, curves, spectra);
  scene.terrain = read_terrain(root, scene.planet);
  scene.ground = read_ground_map(root);
  scene.spheres = read_spheres(root, curves, spectra.spheres);
  scene.media = read_media(root, scene.planet, curves, spectra);
  scene.sun = read_sun(root, curves, spectra);
  scene.camera = read_camera(root);
  scene.image = read_image(root, scene.camera);
  scene.render = read_render_settings(root, methods);
  read_colours(root, curves.any(), spectra);
  curves.refuse_channels();
  if (curves.any() && !root.problems().any()) {
    scene.spectra = std::move(spectra);
    fill_channels(scene);
  }
  if (scene.terrain) {
    refuse_terrain_beside(root, scene, curves.any(), methods);
  }
  if (scene.ground) {
    refuse_ground_map_beside(root, scene, curves.any(), methods);
  }
  if (!scene.spheres.empty()) {
    refuse_spheres_beside(root, scene, methods);
  }
  scene.bloom = read_bloom(root, scene.camera);
  scene.display = read_display(root);
  return scene;
}

// Each key frame's values in the preset: what is wrong then is wrong with them.
void check_key_frames(const Preset& preset, std::span<const MethodInfo> methods, Problems& problems) {
  for_each_key_frame(
      preset, [&](const Preset& frame) { read_scene(Section(problems, &frame.root, frame.root, "", ""), methods); });
}

}  // namespace

Scene resolve(const Preset& preset, std::span<const MethodInfo> methods) {
  Problems problems;
  const Section root(problems, &preset.root, preset.root, "", "");
  Scene scene = read_scene(root, methods);
  scene.sequence = read_key_frames(root, methods);
  if (scene.sequence && !problems.any()) {
    check_key_frames(preset, methods, problems);
  }
  problems.throw_if_any();
  return scene;
}

}  // namespace airlight
