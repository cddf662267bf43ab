// to_json: a scene as a preset of format 1.

#include <cmath>

#include "core/base/text.h"
#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/scene/preset.h"
#include "core/scene/render_settings.h"
#include "core/scene/rules.h"

namespace airlight {
namespace {

// Objects within objects, one key a line.
class JsonObject {
 public:
  explicit JsonObject(int depth = 1) : depth_(depth) {}

  JsonObject& add(std::string_view key, const std::string& json) {
    text_ += (text_.empty() ? "" : ",") + indent(depth_) + json_string(key) + ": " + json;
    return *this;
  }
  JsonObject& number(std::string_view key, double value) { return add(key, format_number(value)); }
  JsonObject& degrees(std::string_view key, double radians) { return number(key, degrees_from_radians(radians)); }
  JsonObject& text(std::string_view key, std::string_view value) { return add(key, json_string(value)); }
  JsonObject& boolean(std::string_view key, bool value) { return add(key, value ? "true" : "false"); }
  JsonObject& spectrum(std::string_view key, const Spectrum& value) {
    return add(key, json_list({value.begin(), value.end()}));
  }
  // Writes the curve where the scene has one.
  JsonObject& spectrum(std::string_view key, const Spectrum& value, const Curve* curve) {
    return curve == nullptr ? spectrum(key, value) : add(key, curve_json(*curve));
  }
  static std::string curve_json(const Curve& curve) {
    return curve.json.empty() ? format_number(curve.value) : curve.json;
  }
  std::string str() const { return "{" + text_ + indent(depth_ - 1) + "}"; }

  static std::string indent(int depth) { return "\n" + std::string(2 * static_cast<std::size_t>(depth), ' '); }

 private:
  int depth_;
  std::string text_;
};

template <class Enum, std::size_t N>
std::string_view name_of(Enum value, const std::array<std::string_view, N>& names) {
  return names.at(static_cast<std::size_t>(value));
}

std::string density_json(const Density& density) {
  JsonObject object(4);
  object.text("profile", name_of(density.profile, kProfileNames));
  const bool has_center = density.profile == DensityProfile::tent || density.profile == DensityProfile::lorentzian;
  if (has_center) {
    object.number("center_km", density.center).number("half_width_km", density.half_width);
  }
  if (density.profile == DensityProfile::exponential || density.profile == DensityProfile::lorentzian ||
      density.profile == DensityProfile::height_fog) {
    object.number("scale_height_km", density.scale_height);
  }
  if (density.profile == DensityProfile::height_fog) {
    object.number("base_km", density.below);
  }
  if (density.profile == DensityProfile::constant) {
    object.number("below_km", density.below);
  }
  if (density.profile == DensityProfile::layers) {
    object.add("layers", "[" + joined_of(density.layers, [](const DensityLayer& layer) {
                           return json_list({layer.altitude, layer.density});
                         }) + "]");
  }
  return object.str();
}

// Absent parts are not written, so that EXRs from before and after the keys existed have the same preset.
std::string phase_json(const Medium& medium, const MediumSpectra* curves) {
  JsonObject object(4);
  if (medium.effective_radius > 0.0) {
    return object.text("function", kPhaseNames[kDropsPhase])
        .number("g", medium.phase_g)
        .number("effective_radius_um", medium.effective_radius)
        .str();
  }
  object.text("function", name_of(medium.phase, kPhaseNames)).number("g", medium.phase_g);
  const Curve none;
  const Curve& depolarization = curves != nullptr ? curves->depolarization : none;
  if (medium.depolarization != Spectrum{} || !(depolarization.json.empty() && depolarization.value == 0.0)) {
    object.spectrum("depolarization", medium.depolarization, curves != nullptr ? &depolarization : nullptr);
  }
  const PhaseTable& table = medium.phase_table;
  if (medium.phase != PhaseFunction::table) {
    return object.str();
  }
  object.add("angles_deg", json_list(table.angles_deg));
  if (table.wavelengths_nm.empty()) {
    return object.add("values", json_list(table.rows.front())).str();
  }
  return object.add("wavelengths_nm", json_list(table.wavelengths_nm))
      .add("values", "[" + joined_of(table.rows, json_list) + "]")
      .str();
}

// The number of metres that is read back as these km, to the last bit.
double metres(double km) {
  constexpr double kMetres = 1e3;
  const double near = km * kMetres;
  for (const double m : {near, std::nextafter(near, 0.0), std::nextafter(near, 1e30)}) {
    if (m / kMetres == km) {
      return m;
    }
  }
  return near;
}

std::string cloud_phase_json(const Cloud& cloud) {
  JsonObject object(4);
  object.text("function", name_of(cloud.phase, kCloudPhaseNames));
  if (cloud.phase == CloudPhase::henyey_greenstein) {
    object.number("g", cloud.phase_g);
  }
  return object.str();
}

void add_voxels(JsonObject& object, const CloudVoxels& voxels) {
  object.text("grid", voxels.grid)
      .text("up", name_of(voxels.up, kUpNames))
      .number("metres_per_unit", metres(voxels.unit))
      .number("extinction_per_km", voxels.extinction);
  if (voxels.base) {
    object.number("base_km", *voxels.base);
  }
}

std::string cloud_json(const Cloud& cloud) {
  JsonObject object(3);
  object.text("type", name_of(cloud.kind, kCloudNames));
  if (cloud.kind == CloudKind::volume) {
    object.text("file", cloud.file).boolean("repeat", cloud.repeats);
    if (cloud.voxels) {
      add_voxels(object, *cloud.voxels);
      object.number("effective_radius_um", cloud.effective_radius);
    }
  } else {
    object.number("cover", cloud.cover)
        .number("base_km", cloud.base)
        .number("top_km", cloud.top)
        .number("cell_km", cloud.cell)
        .number("period_km", cloud.period)
        .number("detail_m", metres(cloud.detail))
        .number("water_g_per_m3", cloud.water)
        .number("shear_km", cloud.shear)
        .degrees("wind_to_deg", cloud.wind)
        .number("seed", cloud.seed)
        .number("effective_radius_um", cloud.effective_radius);
  }
  object.number("east_km", cloud.east).number("north_km", cloud.north);
  if (is_moved(cloud)) {
    object.add("wind_m_s", json_list({cloud.drift[0], cloud.drift[1]}));
  }
  return object.number("single_scattering_albedo", cloud.single_scattering_albedo)
      .add("phase", cloud_phase_json(cloud))
      .str();
}

std::string clouds_json(const std::vector<Cloud>& clouds) {
  std::string text;
  for (const Cloud& cloud : clouds) {
    text += (text.empty() ? "" : ",") + JsonObject::indent(2) + cloud_json(cloud);
  }
  return "[" + text + JsonObject::indent(1) + "]";
}

std::string media_json(const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    const Medium& medium = scene.media[i];
    const MediumSpectra* curves = scene.spectra ? &scene.spectra->media[i] : nullptr;
    JsonObject object(3);
    object.text("name", medium.name)
        .spectrum("scattering_per_km", medium.scattering, curves != nullptr ? &curves->scattering : nullptr)
        .spectrum("absorption_per_km", medium.absorption, curves != nullptr ? &curves->absorption : nullptr)
        .add("density", density_json(medium.density))
        .add("phase", phase_json(medium, curves));
    text += (text.empty() ? "" : ",") + JsonObject::indent(2) + object.str();
  }
  return "[" + text + JsonObject::indent(1) + "]";
}

// The sun's default spectrum has no text of its own.
std::string sun_curve_json(const Curve& curve) {
  return curve.json.empty() ? "{\"named\": \"solar\"}" : curve.json;
}

std::string terrain_json(const Terrain& terrain, const Curve* albedo) {
  JsonObject object(3);
  if (terrain.ridge) {
    object.add("ridge",
               JsonObject(4).number("seed", terrain.ridge->seed).number("height_km", terrain.ridge->height).str());
  } else {
    object.text("height_map", terrain.height_map)
        .number("lowest_km", terrain.lowest)
        .number("highest_km", terrain.highest);
  }
  object.number("width_km", terrain.width)
      .degrees("bearing_deg", terrain.bearing)
      .number("distance_km", terrain.distance)
      .degrees("turn_deg", terrain.turn)
      .spectrum("albedo", terrain.albedo, albedo);
  if (!terrain.albedo_map.empty()) {
    object.text("albedo_map", terrain.albedo_map);
  }
  return object.str();
}

// "grey-18" and "chrome" are written as the material and albedo that they stand for.
std::string spheres_json(const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& sphere = scene.spheres[i];
    JsonObject object(4);
    object.degrees("azimuth_deg", sphere.azimuth)
        .degrees("elevation_deg", sphere.elevation)
        .number("distance_m", metres(sphere.distance))
        .number("radius_m", metres(sphere.radius))
        .text("material", name_of(sphere.material, kMaterialNames))
        .spectrum("albedo", sphere.albedo, scene.spectra ? &scene.spectra->spheres[i] : nullptr);
    if (sphere.material == SphereMaterial::translucent) {
      object.number("scatter_strength", sphere.scatter_strength);
    }
    text += (text.empty() ? "" : ",") + JsonObject::indent(3) + object.str();
  }
  return JsonObject(2).add("spheres", "[" + text + JsonObject::indent(2) + "]").str();
}

std::string ocean_json(const Ocean& ocean) {
  JsonObject object(3);
  object.number("wind_m_per_s", ocean.wind);
  if (!ocean.mask_map.empty()) {
    object.text("mask_map", ocean.mask_map);
  }
  return object.str();
}

std::string planet_json(const Scene& scene) {
  JsonObject object(2);
  object.number("radius_km", scene.planet.ground_radius)
      .number("atmosphere_height_km", scene.planet.atmosphere_height)
      .spectrum("ground_albedo", scene.planet.ground_albedo, scene.spectra ? &scene.spectra->ground_albedo : nullptr);
  if (const auto& refraction = scene.planet.refraction) {
    JsonObject bent(3);
    bent.number("n_minus_1", refraction->n_minus_1);
    if (refraction->medium.empty()) {
      bent.number("scale_height_km", refraction->density.scale_height);
    } else {
      bent.text("medium", refraction->medium);
    }
    object.add("refraction", bent.str());
  }
  if (scene.ground && !scene.ground->albedo_map.empty()) {
    object.text("albedo_map", scene.ground->albedo_map);
  }
  if (scene.ground && scene.ground->ocean) {
    object.add("ocean", ocean_json(*scene.ground->ocean));
  }
  if (scene.terrain) {
    object.add("terrain", terrain_json(*scene.terrain, scene.spectra ? &scene.spectra->terrain_albedo : nullptr));
  }
  return object.str();
}

// The default unit is not written, so that EXRs from before and after the key existed have the same preset.
std::string sun_json(const Scene& scene) {
  const Sun& sun = scene.sun;
  JsonObject object(2);
  object.degrees("elevation_deg", sun.elevation).degrees("azimuth_deg", sun.azimuth);
  if (scene.spectra) {
    object.number("irradiance", scene.spectra->irradiance).add("spectrum", sun_curve_json(scene.spectra->sun));
  } else {
    object.spectrum("irradiance", sun.irradiance);
  }
  if (sun.unit != SunUnit::relative) {
    object.text("unit", name_of(sun.unit, kSunUnitNames));
  }
  return object
      .add("disc", JsonObject(3)
                       .boolean("visible", sun.disc.visible)
                       .degrees("angular_radius_deg", sun.disc.angular_radius)
                       .number("limb_darkening", sun.disc.limb_darkening)
                       .number("radiance_scale", sun.disc.radiance_scale)
                       .str())
      .str();
}

std::string moon_json(const Moon& moon) {
  return JsonObject(2)
      .degrees("elevation_deg", moon.elevation)
      .degrees("azimuth_deg", moon.azimuth)
      .degrees("phase_deg", moon.lit.phase)
      .number("distance_km", moon.distance)
      .degrees("bright_limb_deg", moon.lit.bright_limb)
      .str();
}

std::string night_sky_json(const NightSky& sky) {
  return JsonObject(2)
      .number("airglow", sky.airglow)
      .number("zodiacal", sky.zodiacal)
      .number("starlight", sky.starlight)
      .number("light_pollution_cd_per_m2", sky.light_pollution)
      .text("lamps", name_of(sky.lamps, kLampNames))
      .str();
}

std::string camera_json(const Camera& camera) {
  JsonObject object(2);
  object.number("altitude_km", camera.altitude);
  if (camera.latitude != 0.0 || camera.longitude != 0.0) {
    object.degrees("latitude_deg", camera.latitude).degrees("longitude_deg", camera.longitude);
  }
  if (camera.julian_date != Camera{}.julian_date) {
    object.number("julian_date", camera.julian_date);
  }
  object.degrees("azimuth_deg", camera.azimuth)
      .degrees("pitch_deg", camera.pitch)
      .degrees("roll_deg", camera.roll)
      .text("projection", name_of(camera.projection, kProjectionNames));
  if (camera.projection == Projection::cube) {
    object.text("cube_layout", name_of(camera.cube_layout, kCubeLayoutNames));
  }
  if (!is_map(camera.projection)) {
    object.degrees("vertical_fov_deg", camera.vertical_fov);
  }
  if (camera.polariser) {
    object.add("polariser", JsonObject(3).degrees("angle_deg", *camera.polariser).str());
  }
  return object.str();
}

std::string render_json(const Scene& scene) {
  const RenderSettings& render = scene.render;
  JsonObject object(2);
  object.text("method", render.method).boolean("polarisation", render.polarisation);
  if (scene.spectra && scene.spectra->wavelengths != 0) {
    object.number("wavelengths", scene.spectra->wavelengths);
  }
  for (const auto& [key, value] : render.parameters) {
    if (!std::holds_alternative<std::monostate>(value)) {
      object.add(key, json_text(value));
    }
  }
  return object.str();
}

// Bloom that is on by default is not written: written, it would ask for a layer in the EXR.
std::string bloom_json(const Bloom& bloom) {
  JsonObject object(2);
  if (!bloom.enabled || bloom.in_exr) {
    object.boolean("enabled", bloom.enabled);
  }
  return object.text("model", name_of(bloom.model, kBloomModelNames))
      .number("threshold", bloom.threshold)
      .number("intensity", bloom.intensity)
      .number("levels", bloom.levels)
      .str();
}

std::string display_json(const Display& display) {
  JsonObject object(2);
  object.add("exposure", display.exposure ? format_number(*display.exposure) : json_string(metering_text(display)))
      .number("compensation_ev", display.compensation)
      .text("display", display.display)
      .text("view", display.view)
      .text("tonemap", name_of(display.tonemap, kToneCurveNames));
  if (display.night != 0.0) {
    object.number("night_ev", display.night);
  }
  if (display.rods) {
    object.boolean("rods", true);
  }
  return object.str();
}

std::string image_json(const Scene& scene) {
  JsonObject object(2);
  object.number("width", scene.image.width).number("height", scene.image.height);
  if (scene.spectra && scene.spectra->white != White::sun) {
    object.text("white", name_of(scene.spectra->white, kWhiteNames));
  }
  return object.str();
}

std::string values_json(const std::vector<double>& values) {
  return values.size() == 1 ? format_number(values[0]) : json_list(values);
}

std::string sequence_json(const KeyFrames& sequence) {
  std::string frames;
  for (const KeyFrame& frame : sequence.frames) {
    std::string keys = "{\"at\": " + std::to_string(frame.at);
    for (const auto& [pointer, values] : frame.values) {
      keys += ", " + json_string(pointer) + ": " + values_json(values);
    }
    frames += (frames.empty() ? "" : ",") + JsonObject::indent(3) + keys + "}";
  }
  return JsonObject(2)
      .add("frames", "[" + frames + JsonObject::indent(2) + "]")
      .text("interpolation", kInterpolationNames.front())
      .str();
}

}  // namespace

std::string metering_text(const Display& display) {
  switch (display.metering) {
    case Metering::picture:
      break;
    case Metering::day:
      return "day";
    case Metering::frame:
      return "lock:" + std::to_string(display.metered_frame);
  }
  return "auto";
}

std::string to_json(const Scene& scene) {
  JsonObject object(1);
  object.number("airlight", 1)
      .text("name", scene.name)
      .text("description", scene.description)
      .add("planet", planet_json(scene));
  if (!scene.spheres.empty()) {
    object.add("scene", spheres_json(scene));
  }
  object.add("media", media_json(scene));
  if (!scene.clouds.empty()) {
    object.add("clouds", clouds_json(scene.clouds));
  }
  object.add("sun", sun_json(scene));
  if (scene.moon) {
    object.add("moon", moon_json(*scene.moon));
  }
  if (scene.night_sky) {
    object.add("night_sky", night_sky_json(*scene.night_sky));
  }
  if (scene.stars) {
    object.add("stars", JsonObject(2).number("magnitude_limit", scene.stars->magnitude_limit).str());
  }
  object.add("camera", camera_json(scene.camera))
      .add("image", image_json(scene))
      .add("render", render_json(scene))
      .add("bloom", bloom_json(scene.bloom))
      .add("display", display_json(scene.display));
  if (scene.sequence) {
    object.add("sequence", sequence_json(*scene.sequence));
  }
  return object.str() + "\n";
}

}  // namespace airlight
