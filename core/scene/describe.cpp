// describe: a scene as people read it, one value a line with its unit.

#include <algorithm>

#include "core/scene/angle.h"
#include "core/scene/json_format.h"
#include "core/scene/photometry.h"
#include "core/scene/preset.h"
#include "core/scene/render_settings.h"
#include "core/scene/resolve.h"
#include "core/scene/rules.h"
#include "core/scene/thing_kinds.h"

namespace airlight {
namespace {

class Lines {
 public:
  Lines& heading(std::string_view name) {
    text_ += std::string(name) + "\n";
    return *this;
  }
  Lines& line(std::string_view name, std::string_view value) {
    constexpr std::size_t kValueColumn = 28;
    std::string row = "  " + std::string(name);
    row.resize(std::max(row.size() + 1, kValueColumn), ' ');
    text_ += row + std::string(value) + "\n";
    return *this;
  }
  Lines& number(std::string_view name, double value, std::string_view unit = {}) {
    return line(name, with_unit(format_number(value), unit));
  }
  Lines& angle(std::string_view name, double radians) { return number(name, degrees_from_radians(radians), "degrees"); }
  Lines& spectrum(std::string_view name, const Spectrum& value, std::string_view unit = {}) {
    return line(
        name, with_unit(format_number(value[0]) + " " + format_number(value[1]) + " " + format_number(value[2]), unit));
  }
  const std::string& str() const { return text_; }

  static std::string with_unit(std::string text, std::string_view unit) {
    return unit.empty() ? text : text + " " + std::string(unit);
  }

 private:
  std::string text_;
};

std::string density_text(const Density& density) {
  const auto km = [](double value) { return format_number(value) + " km"; };
  switch (density.profile) {
    case DensityProfile::exponential:
      return "exponential, scale height " + km(density.scale_height);
    case DensityProfile::tent:
      return "tent, center " + km(density.center) + ", half width " + km(density.half_width);
    case DensityProfile::lorentzian:
      return "lorentzian, center " + km(density.center) + ", half width " + km(density.half_width) + ", scale height " +
             km(density.scale_height);
    case DensityProfile::constant:
      return "constant below " + km(density.below);
    case DensityProfile::height_fog:
      return "height fog, base " + km(density.below) + ", scale height " + km(density.scale_height);
    case DensityProfile::layers: {
      std::string text = "layers";
      for (const DensityLayer& layer : density.layers) {
        text += (text == "layers" ? " " : ", ") + km(layer.altitude) + ": " + format_number(layer.density);
      }
      return text;
    }
  }
  return {};
}

// The curve as the preset writes it, cut where it is long.
std::string curve_text(const Curve& curve) {
  constexpr std::size_t kLongest = 100;
  const std::string& text = curve.json;
  if (text.size() > kLongest) {
    return std::to_string(curve.values.size()) + " samples, " + format_number(curve.wavelengths.front()) + " to " +
           format_number(curve.wavelengths.back()) + " nm";
  }
  return text.empty() ? format_number(curve.value) : text;
}

std::string irradiance_text(const Scene& scene) {
  const Spectrum& e = scene.sun.irradiance;
  const std::string text = scene.spectra ? format_number(scene.spectra->irradiance)
                                         : format_number(e[0]) + " " + format_number(e[1]) + " " + format_number(e[2]);
  return Lines::with_unit(text, irradiance_unit(scene.sun.unit));
}

std::string phase_text(const Medium& medium, const MediumSpectra* curves) {
  const std::string name(kPhaseNames.at(static_cast<std::size_t>(medium.phase)));
  const PhaseTable& table = medium.phase_table;
  switch (medium.phase) {
    case PhaseFunction::rayleigh: {
      const bool curved = curves != nullptr && (!curves->depolarization.json.empty());
      const bool depolarizes = curved || medium.depolarization != Spectrum{};
      return name + (!depolarizes ? ""
                     : curved     ? ", depolarization " + curve_text(curves->depolarization)
                                  : ", depolarization " + format_number(medium.depolarization[1]));
    }
    case PhaseFunction::isotropic:
      return name;
    case PhaseFunction::table:
      if (medium.effective_radius > 0.0) {
        return "drops, effective radius " + format_number(medium.effective_radius) + " um";
      }
      return name + ", " + std::to_string(table.angles_deg.size()) + " angles" +
             (table.wavelengths_nm.empty() ? ""
                                           : ", " + std::to_string(table.rows.size()) + " wavelengths from " +
                                                 format_number(table.wavelengths_nm.front()) + " to " +
                                                 format_number(table.wavelengths_nm.back()) + " nm");
    default:
      return name + ", g " + format_number(medium.phase_g);
  }
}

void describe_medium(Lines& lines, const Medium& medium, const MediumSpectra* curves) {
  lines.heading("medium " + medium.name);
  if (curves != nullptr) {
    lines.line("scattering", Lines::with_unit(curve_text(curves->scattering), "per km"))
        .line("absorption", Lines::with_unit(curve_text(curves->absorption), "per km"));
  } else {
    lines.spectrum("scattering", medium.scattering, "per km").spectrum("absorption", medium.absorption, "per km");
  }
  lines.line("density", density_text(medium.density)).line("phase", phase_text(medium, curves));
}

void describe_albedo(Lines& lines, const Spectrum& albedo, const Curve* curve) {
  if (curve != nullptr) {
    lines.line("albedo", curve_text(*curve));
  } else {
    lines.spectrum("albedo", albedo);
  }
}

void describe_terrain(Lines& lines, const Terrain& terrain, const Curve* albedo) {
  lines.heading("terrain");
  if (terrain.ridge) {
    lines.line("ridge",
               "seed " + format_number(terrain.ridge->seed) + ", " + format_number(terrain.ridge->height) + " km high");
  } else {
    lines.line("height map", terrain.height_map)
        .number("value 0", terrain.lowest, "km")
        .number("value 1", terrain.highest, "km");
  }
  lines.number("width", terrain.width, "km")
      .angle("bearing", terrain.bearing)
      .number("distance", terrain.distance, "km")
      .angle("turn", terrain.turn);
  describe_albedo(lines, terrain.albedo, albedo);
  if (!terrain.albedo_map.empty()) {
    lines.line("albedo map", terrain.albedo_map);
  }
}

void describe_ground(Lines& lines, const GroundMap& ground, const Camera& camera) {
  if (!ground.albedo_map.empty()) {
    lines.line("albedo map", ground.albedo_map);
  }
  if (ground.ocean) {
    lines.number("wind over the ocean", ground.ocean->wind, "m/s");
    if (!ground.ocean->mask_map.empty()) {
      lines.line("map of water", ground.ocean->mask_map);
    }
  }
  lines.angle("camera's latitude", camera.latitude).angle("camera's longitude", camera.longitude);
}

void describe_sphere(Lines& lines, const Sphere& sphere, const Curve* albedo) {
  constexpr double kMetres = 1e3;  // a km
  lines.heading("sphere, " + std::string(kMaterialNames.at(static_cast<std::size_t>(sphere.material))))
      .angle("azimuth", sphere.azimuth)
      .angle("elevation", sphere.elevation)
      .number("distance", sphere.distance * kMetres, "m")
      .number("radius", sphere.radius * kMetres, "m");
  describe_albedo(lines, sphere.albedo, albedo);
  if (sphere.material == SphereMaterial::translucent) {
    lines.number("scatter strength", sphere.scatter_strength);
  }
}

void describe_cloud(Lines& lines, const Cloud& cloud) {
  constexpr double kMetres = 1e3;  // a km
  lines.heading("cloud, " + std::string(kCloudNames.at(static_cast<std::size_t>(cloud.kind))));
  if (cloud.kind == CloudKind::volume) {
    lines.line("file", cloud.file).line("repeat", cloud.repeats ? "true" : "false");
    if (cloud.voxels) {
      lines.line("grid", cloud.voxels->grid)
          .number("metres per unit", cloud.voxels->unit * kMetres, "m")
          .number("extinction of value 1", cloud.voxels->extinction, "per km")
          .number("base", cloud.base, "km")
          .number("top", cloud.top, "km");
    }
  } else {
    lines.number("cover", cloud.cover)
        .number("base", cloud.base, "km")
        .number("top", cloud.top, "km")
        .number("cell", cloud.cell, "km")
        .number("period", cloud.period, "km")
        .number("detail", cloud.detail * kMetres, "m")
        .number("water", cloud.water, "g/m3")
        .number("shear", cloud.shear, "km")
        .angle("wind to", cloud.wind)
        .number("seed", cloud.seed);
  }
  if (is_moved(cloud)) {
    lines.number("wind to the east", cloud.drift[0], "m/s").number("wind to the north", cloud.drift[1], "m/s");
  }
  lines.number("effective radius", cloud.effective_radius, "um")
      .number("east", cloud.east, "km")
      .number("north", cloud.north, "km")
      .number("single scattering albedo", cloud.single_scattering_albedo)
      .line("phase",
            cloud.phase == CloudPhase::drops ? "drops" : "henyey-greenstein, g " + format_number(cloud.phase_g));
}

void describe_moon(Lines& lines, const Moon& moon) {
  lines.heading("moon")
      .angle("elevation", moon.elevation)
      .angle("azimuth", moon.azimuth)
      .angle("phase", moon.lit.phase)
      .angle("bright limb", moon.lit.bright_limb)
      .number("distance", moon.distance, "km")
      .spectrum("irradiance", moon.irradiance);
}

void describe_camera(Lines& lines, const Camera& camera, const ImageSize& image) {
  lines.heading("camera")
      .number("altitude", camera.altitude, "km")
      .angle("azimuth", camera.azimuth)
      .angle("pitch", camera.pitch)
      .angle("roll", camera.roll)
      .line("projection", kProjectionNames.at(static_cast<std::size_t>(camera.projection)));
  if (camera.projection == Projection::cube) {
    lines.line("cube layout", kCubeLayoutNames.at(static_cast<std::size_t>(camera.cube_layout)));
  }
  if (!is_map(camera.projection)) {
    lines.angle("vertical field of view", camera.vertical_fov);
  }
  if (camera.polariser) {
    lines.angle("polarising filter's axis", *camera.polariser);
  }
  lines.line("image", std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels");
}

void describe_render(Lines& lines, const RenderSettings& render) {
  lines.heading("render").line("method", render.method).line("polarisation", render.polarisation ? "true" : "false");
  for (const auto& [key, value] : render.parameters) {
    const std::string text = json_text(value);
    lines.line(key, text.empty() ? "absent" : text);
  }
}

}  // namespace

std::string describe(const Scene& scene) {
  Lines lines;
  if (!scene.name.empty()) {
    lines.heading(scene.name + (scene.description.empty() ? "" : ": " + scene.description));
  }
  lines.heading("planet")
      .number("radius", scene.planet.ground_radius, "km")
      .number("atmosphere height", scene.planet.atmosphere_height, "km");
  if (scene.spectra) {
    lines.line("ground albedo", curve_text(scene.spectra->ground_albedo));
  } else {
    lines.spectrum("ground albedo", scene.planet.ground_albedo);
  }
  if (const auto& refraction = scene.planet.refraction) {
    lines.line("refraction", "n - 1 = " + format_number(refraction->n_minus_1) + " at the ground, " +
                                 (refraction->medium.empty()
                                      ? "scale height " + format_number(refraction->density.scale_height) + " km"
                                      : "as the density of " + refraction->medium));
  }
  if (scene.ground) {
    describe_ground(lines, *scene.ground, scene.camera);
  }
  if (scene.terrain) {
    describe_terrain(lines, *scene.terrain, scene.spectra ? &scene.spectra->terrain_albedo : nullptr);
  }
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    describe_sphere(lines, scene.spheres[i], scene.spectra ? &scene.spectra->spheres[i] : nullptr);
  }
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    describe_medium(lines, scene.media[i], scene.spectra ? &scene.spectra->media[i] : nullptr);
  }
  for (const Cloud& cloud : scene.clouds) {
    describe_cloud(lines, cloud);
  }
  lines.heading("sun")
      .angle("elevation", scene.sun.elevation)
      .angle("azimuth", scene.sun.azimuth)
      .line("irradiance", irradiance_text(scene))
      .line("disc", scene.sun.disc.visible ? "visible" : "hidden")
      .angle("disc angular radius", scene.sun.disc.angular_radius)
      .number("disc limb darkening", scene.sun.disc.limb_darkening)
      .number("disc radiance scale", scene.sun.disc.radiance_scale);
  if (scene.sun.disc.cover) {
    lines.number("share not covered by the moon", scene.sun.uncovered);
  }
  if (scene.moon) {
    describe_moon(lines, *scene.moon);
  }
  if (scene.night_sky) {
    lines.heading("night sky")
        .number("airglow", scene.night_sky->airglow)
        .number("zodiacal light", scene.night_sky->zodiacal)
        .number("starlight", scene.night_sky->starlight)
        .number("light of lamps", scene.night_sky->light_pollution, "cd/m2");
  }
  if (scene.stars) {
    lines.heading("stars").number("magnitude limit", scene.stars->magnitude_limit);
  }
  if (scene.night_sky || scene.stars) {
    lines.number("Julian date", scene.camera.julian_date);
  }
  describe_camera(lines, scene.camera, scene.image);
  describe_render(lines, scene.render);
  if (scene.spectra) {
    const int count = scene.spectra->wavelengths;
    lines.heading("spectra")
        .line("sunlight", scene.spectra->sun.json.empty() ? "ASTM G-173" : curve_text(scene.spectra->sun))
        .line("wavelengths", count == 0 ? "auto" : std::to_string(count))
        .line("white", kWhiteNames.at(static_cast<std::size_t>(scene.spectra->white)));
  }
  lines.heading("bloom")
      .line("enabled", scene.bloom.in_exr    ? "yes, with a layer in the EXR"
                       : scene.bloom.enabled ? "yes"
                                             : "no")
      .line("model", kBloomModelNames.at(static_cast<std::size_t>(scene.bloom.model)))
      .number("threshold", scene.bloom.threshold)
      .number("intensity", scene.bloom.intensity)
      .number("levels", scene.bloom.levels);
  lines.heading("display")
      .line("exposure", scene.display.exposure ? format_number(*scene.display.exposure) : metering_text(scene.display))
      .number("compensation", scene.display.compensation, "stops")
      .number("by night", scene.display.night, "stops")
      .line("display", scene.display.display.empty() ? "the config's default" : scene.display.display)
      .line("view", scene.display.view.empty() ? "the config's default" : scene.display.view)
      .line("tone curve", kToneCurveNames.at(static_cast<std::size_t>(scene.display.tonemap)))
      .line("colours of the night", scene.display.rods ? "by the eye's rods" : "as they are");
  if (scene.sequence) {
    lines.heading("sequence");
    for (const KeyFrame& frame : scene.sequence->frames) {
      lines.line("frame " + std::to_string(frame.at), std::to_string(frame.values.size()) + " keys");
    }
  }
  return lines.str();
}

}  // namespace airlight
