#include <cstdio>

#include "core/methods/path_trace/checkpoint.h"
#include "core/methods/path_trace/walk.h"
#include "core/scene/density_profiles.h"
#include "core/scene/thing_kinds.h"
#include "core/things/bodies.h"
#include "core/things/ground.h"
#include "core/things/terrain.h"

namespace airlight {
namespace {

// To be raised whenever the same seed gives other samples.
constexpr int kSampler = 1;
constexpr int kSamplerOnBentRays = 2;  // among things and clouds

// Collects `POINTER value` lines. 17 digits restore a double exactly.
class Lines {
 public:
  void add(const std::string& pointer, double value) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    text_ += pointer + " " + digits + "\n";
  }
  void add(const std::string& pointer, const Spectrum& value) {
    for (std::size_t c = 0; c < value.size(); ++c) {
      add(pointer + "/" + std::to_string(c), value[c]);
    }
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_table(Lines& lines, const std::string& at, const Medium& medium) {
  const PhaseTable& table = medium.phase_table;
  if (table.rows.empty()) {
    return;
  }
  lines.add(at + "/wavelengths (nm)", medium.phase_wavelengths);
  for (std::size_t k = 0; k < table.angles_deg.size(); ++k) {
    const std::string angle = std::to_string(k);
    lines.add(at + "/angles_deg/" + angle, table.angles_deg[k]);
    for (std::size_t c = 0; c < Spectrum{}.size(); ++c) {
      lines.add(at + "/values/" + angle + "/" + std::to_string(c),
                phase_at(table, medium.phase_wavelengths[c], table.angles_deg[k]));
    }
  }
}

void add_medium(Lines& lines, const std::string& at, const Medium& medium) {
  lines.add(at + "/scattering_per_km", medium.scattering);
  lines.add(at + "/absorption_per_km", medium.absorption);
  const Density& density = medium.density;
  lines.add(at + "/density/profile", static_cast<int>(density.profile));
  for (const DensityNumber& number : kDensityNumbers) {
    lines.add(at + "/density/" + number.key, density.*number.value);
  }
  for (std::size_t k = 0; k < density.layers.size(); ++k) {
    lines.add(at + "/density/layers/" + std::to_string(k) + "/0", density.layers[k].altitude);
    lines.add(at + "/density/layers/" + std::to_string(k) + "/1", density.layers[k].density);
  }
  lines.add(at + "/phase/function", static_cast<int>(medium.phase));
  lines.add(at + "/phase/g", medium.phase_g);
  lines.add(at + "/phase/depolarization", medium.depolarization);
  add_table(lines, at + "/phase", medium);
}

void add_matter(Lines& lines, const std::string& at, const Scene& scene) {
  lines.add(at + "/planet/ground_albedo", scene.planet.ground_albedo);
  lines.add(at + "/media/-", static_cast<double>(scene.media.size()));
  for (std::size_t i = 0; i < scene.media.size(); ++i) {
    add_medium(lines, at + "/media/" + std::to_string(i), scene.media[i]);
  }
}

void add_things(Lines& lines, const std::string& at, const Scene& scene) {
  if (scene.terrain) {
    lines.add(at + terrain_key(*scene.terrain), 1.0);
  }
  if (scene.ground) {
    lines.add(at + ground_key(scene), 1.0);
  }
  for (std::size_t i = 0; i < scene.clouds.size(); ++i) {
    const Cloud& cloud = scene.clouds[i];
    const std::string here = at + "/clouds/" + std::to_string(i);
    lines.add(here + " " + cloud_key(cloud), 1.0);
    lines.add(here + "/single_scattering_albedo", cloud.single_scattering_albedo);
    lines.add(here + "/phase", static_cast<int>(cloud.phase));
    lines.add(here + "/phase/g", cloud.phase_g);
  }
  tell_bodies(scene, [&](const std::string& key, double value) { lines.add(at + key, value); });
}

// The groups of three wavelengths, with their colours, whose sum is the picture.
void add_wavelengths(Lines& lines, const Stage& stage) {
  lines.add("wavelengths", static_cast<double>(stage.basis().nodes.nm.size()));
  for (std::size_t g = 0; g < stage.parts().size(); ++g) {
    const Part& part = stage.parts()[g];
    const std::string at = "group " + std::to_string(g) + " ";
    add_matter(lines, at, part.scene);
    add_things(lines, at, part.scene);
    for (std::size_t c = 0; c < 3; ++c) {
      lines.add(at + "colour " + std::to_string(c), part.colours[c]);
    }
  }
}

void add_camera(Lines& lines, const Scene& scene) {
  lines.add("/camera/altitude_km", scene.camera.altitude);
  lines.add("/camera/projection", static_cast<int>(scene.camera.projection));
  if (scene.camera.projection == Projection::cube) {
    lines.add("/camera/cube_layout", static_cast<int>(scene.camera.cube_layout));
  }
  lines.add("/camera/azimuth (rad)", scene.camera.azimuth);
  lines.add("/camera/pitch (rad)", scene.camera.pitch);
  lines.add("/camera/roll (rad)", scene.camera.roll);
  lines.add("/camera/vertical_fov (rad)", scene.camera.vertical_fov);
  lines.add("/image/width", scene.image.width);
  lines.add("/image/height", scene.image.height);
}

}  // namespace

std::string checkpoint_identity(const Stage& stage, const View& view) {
  const Scene& scene = stage.scene();
  Lines lines;
  lines.add("sampler", scene.planet.refraction && stand_at_true_distance(scene) ? kSamplerOnBentRays : kSampler);
  lines.add("batch", kBatch);
  lines.add("/render/seed", scene.render.get<int>("seed"));
  lines.add("/render/max_orders", scene.render.get<int>("max_orders"));
  lines.add("/render/polarisation", scene.render.polarisation ? 1.0 : 0.0);
  lines.add("/planet/radius_km", scene.planet.ground_radius);
  lines.add("/planet/atmosphere_height_km", scene.planet.atmosphere_height);
  if (stage.in_colours()) {
    add_wavelengths(lines, stage);
  } else {
    add_matter(lines, "", scene);
  }
  add_things(lines, "", scene);
  if (scene.ground) {
    lines.add("latitude (rad)", scene.camera.latitude);
    lines.add("longitude (rad)", scene.camera.longitude);
  }
  lines.add("/sun/elevation (rad)", scene.sun.elevation);
  lines.add("/sun/azimuth (rad)", scene.sun.azimuth);
  if (scene.camera.polariser) {
    lines.add("/camera/polariser/angle_deg (rad)", *scene.camera.polariser);
  }
  if (view.directions.empty() || scene.camera.polariser) {
    add_camera(lines, scene);
  }
  if (view.directions.empty()) {
    return lines.text();
  }
  lines.add("/camera/altitude_km", scene.camera.altitude);
  if (view.wall) {
    lines.add("wall (km)", *view.wall);
  }
  for (std::size_t k = 0; k < view.directions.size(); ++k) {
    lines.add("direction " + std::to_string(k) + " elevation (rad)", view.directions[k].elevation);
    lines.add("direction " + std::to_string(k) + " azimuth (rad)", view.directions[k].azimuth);
  }
  return lines.text();
}

}  // namespace airlight
