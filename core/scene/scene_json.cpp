// to_json: a scene as a preset of format 1.

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
  // All keys of the object `prefix` that rules keep in members of an Owner; of the rules for particular choices those
  // of `choice`.
  template <class Owner>
  JsonObject& members(std::string_view prefix, const Owner& owner, std::string_view choice = {}) {
    for (const Rule& rule : rules()) {
      const std::string_view key = held_key(rule, prefix, owner_id<Owner>(), choice);
      if (const std::string json = key.empty() ? "" : rule.member.json(rule, &owner); !json.empty()) {
        add(key, json);
      }
    }
    return *this;
  }
  JsonObject& number(std::string_view key, double value) { return add(key, format_number(value)); }
  JsonObject& degrees(std::string_view key, double radians) { return number(key, degrees_from_radians(radians)); }
  JsonObject& text(std::string_view key, std::string_view value) { return add(key, json_string(value)); }
  JsonObject& boolean(std::string_view key, bool value) { return add(key, value ? "true" : "false"); }
  JsonObject& spectrum(std::string_view key, const Spectrum& value) {
    return add(key, json_list({value.begin(), value.end()}));
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
  object.members("media[].density", density, name_of(density.profile, kProfileNames));
  if (density.profile == DensityProfile::layers) {
    object.add("layers", "[" + joined_of(density.layers, [](const DensityLayer& layer) {
                           return json_list({layer.altitude, layer.density});
                         }) + "]");
  }
  return object.str();
}

// Absent parts are not written, so that EXRs from before and after the keys existed have the same preset.
std::string phase_json(const Medium& medium) {
  JsonObject object(4);
  const bool drops = medium.effective_radius > 0.0;
  const std::string_view function = drops ? kPhaseNames[kDropsPhase] : name_of(medium.phase, kPhaseNames);
  object.text("function", function).members("media[].phase", medium, function);
  if (drops) {
    return object.str();
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

std::string cloud_phase_json(const Cloud& cloud) {
  JsonObject object(4);
  object.text("function", name_of(cloud.phase, kCloudPhaseNames));
  if (cloud.phase == CloudPhase::henyey_greenstein) {
    object.number("g", cloud.phase_g);
  }
  return object.str();
}

std::string cloud_json(const Cloud& cloud) {
  const std::string_view kind = name_of(cloud.kind, kCloudNames);
  JsonObject object(3);
  object.members("clouds[]", cloud, kind);
  if (cloud.voxels) {
    object.members("clouds[]", *cloud.voxels, kind).number("effective_radius_um", cloud.effective_radius);
  }
  return object.add("phase", cloud_phase_json(cloud)).str();
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
  for (const Medium& medium : scene.media) {
    JsonObject object(3);
    object.members("media[]", medium)
        .add("absorption_per_km", json_of(medium.absorption))
        .add("density", density_json(medium.density))
        .add("phase", phase_json(medium));
    text += (text.empty() ? "" : ",") + JsonObject::indent(2) + object.str();
  }
  return "[" + text + JsonObject::indent(1) + "]";
}

// The sun's default spectrum has no text of its own.
std::string sun_curve_json(const Curve& curve) {
  return curve.json.empty() ? "{\"named\": \"solar\"}" : curve.json;
}

std::string terrain_json(const Terrain& terrain) {
  JsonObject object(3);
  if (terrain.ridge) {
    object.add("ridge", JsonObject(4).members("planet.terrain.ridge", *terrain.ridge).str());
  }
  object.members("planet.terrain", terrain);
  return object.str();
}

// "grey-18" and "chrome" are written as the material and albedo that they stand for.
std::string spheres_json(const Scene& scene) {
  std::string text;
  for (const Sphere& sphere : scene.spheres) {
    JsonObject object(4);
    object.members("scene.spheres[]", sphere, name_of(sphere.material, kMaterialNames));
    text += (text.empty() ? "" : ",") + JsonObject::indent(3) + object.str();
  }
  return JsonObject(2).add("spheres", "[" + text + JsonObject::indent(2) + "]").str();
}

std::string planet_json(const Scene& scene) {
  JsonObject object(2);
  object.members("planet", scene.planet);
  if (const auto& refraction = scene.planet.refraction) {
    JsonObject bent(3);
    bent.members("planet.refraction", *refraction);
    if (refraction->medium.empty()) {
      bent.number("scale_height_km", refraction->density.scale_height);
    } else {
      bent.text("medium", refraction->medium);
    }
    object.add("refraction", bent.str());
  }
  if (scene.ground) {
    object.members("planet", *scene.ground);
  }
  if (scene.ground && scene.ground->ocean) {
    object.add("ocean", JsonObject(3).members("planet.ocean", *scene.ground->ocean).str());
  }
  if (scene.terrain) {
    object.add("terrain", terrain_json(*scene.terrain));
  }
  return object.str();
}

std::string sun_json(const Scene& scene) {
  JsonObject object(2);
  object.members("sun", scene.sun);
  if (scene.spectra) {
    object.number("irradiance", scene.spectra->irradiance).add("spectrum", sun_curve_json(scene.spectra->sun));
  } else {
    object.spectrum("irradiance", scene.sun.irradiance);
  }
  return object.add("disc", JsonObject(3).members("sun.disc", scene.sun.disc).str()).str();
}

std::string moon_json(const Moon& moon) {
  return JsonObject(2)
      .members("moon", moon)
      .degrees("phase_deg", moon.lit.phase)
      .degrees("bright_limb_deg", moon.lit.bright_limb)
      .str();
}

std::string camera_json(const Camera& camera) {
  JsonObject object(2);
  object.members("camera", camera, name_of(camera.projection, kProjectionNames));
  if (camera.polariser) {
    object.add("polariser", JsonObject(3).members("camera.polariser", camera).str());
  }
  return object.str();
}

std::string render_json(const Scene& scene) {
  const RenderSettings& render = scene.render;
  JsonObject object(2);
  object.text("method", render.method).members("render", render);
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
  object.members("bloom", bloom);
  return bloom.in_exr ? object.boolean("enabled", true).str() : object.str();
}

std::string display_json(const Display& display) {
  return JsonObject(2)
      .add("exposure", display.exposure ? format_number(*display.exposure) : json_string(metering_text(display)))
      .members("display", display)
      .str();
}

std::string image_json(const Scene& scene) {
  JsonObject object(2);
  object.members("image", scene.image);
  return scene.spectra ? object.members("image", *scene.spectra).str() : object.str();
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
  object.number("airlight", 1).members("", scene).add("planet", planet_json(scene));
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
    object.add("night_sky", JsonObject(2).members("night_sky", *scene.night_sky).str());
  }
  if (scene.stars) {
    object.add("stars", JsonObject(2).members("stars", *scene.stars).str());
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
