#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/base/text.h"
#include "core/scene/cloud_file.h"
#include "core/scene/cloud_layer.h"
#include "core/scene/curve_reader.h"
#include "core/scene/json_format.h"
#include "core/scene/printable.h"
#include "core/scene/readers.h"

namespace airlight {
namespace {

constexpr double kMetresInKm = 1e3;  // a km
constexpr double kIcePeak = 0.75;    // asymmetry of cirrus

// Keys that only a file of OpenVDB takes.
constexpr std::array<std::string_view, 6> kVoxelKeys = {
    "grid", "up", "metres_per_unit", "extinction_per_km", "base_km", "effective_radius_um"};

void refuse_voxel_keys(const Section& section, const std::string& name) {
  for (const std::string_view key : kVoxelKeys) {
    if (const PresetValue* value = section.find(key); value != nullptr) {
      section.complain(
          key, *value,
          "a key of files of OpenVDB, and the name " + quoted_text(name) + " does not end in .vdb; remove it");
    }
  }
}

void read_volume(const Section& section, Cloud& cloud) {
  const std::string name = cloud.file;
  const PresetValue* value = section.find("file");
  if (value == nullptr) {
    return;
  }
  if (name.empty()) {
    section.complain("file", *value, quoted(*value) + " is no file; expected the name of one");
    return;
  }
  const std::filesystem::path file = file_beside(*value, name);
  cloud.file = std::filesystem::absolute(file).lexically_normal().string();
  if (lower(file.extension().string()) == ".vdb") {
    // Its contents, base and top are filled in by judged() (core/library), with the other files that no text reader
    // knows.
    section.fill(cloud.voxels.emplace());
    cloud.effective_radius = section.number("effective_radius_um");
    return;
  }
  refuse_voxel_keys(section, name);
  auto contents = std::make_shared<CloudFile>();
  if (const std::string problem = read_cloud_file(file, *contents); !problem.empty()) {
    section.complain("file", *value, problem);
    return;
  }
  cloud.base = contents->lowest - 0.5 * contents->dz;
  cloud.top = contents->lowest + contents->dz * (contents->nz - 0.5);
  cloud.effective_radius = contents->effective_radius;
  cloud.contents = std::move(contents);
}

// The key by which a message names the field; its default where the preset says nothing.
void blame_cloud(const Section& section, std::string_view key, const std::string& message) {
  const PresetValue* value = section.find(key);
  section.complain(key, value == nullptr ? section.context() : *value, message);
}

void check_field(const Section& section, const Cloud& cloud) {
  if (!(cloud.top > cloud.base)) {
    blame_cloud(section, "top_km",
                format_number(cloud.top) + " km is not above base_km, " + format_number(cloud.base) +
                    " km; lower the base or raise the top");
    return;
  }
  if (cloud.period < 2.0 * cloud.cell) {
    blame_cloud(section, "period_km",
                format_number(cloud.period) + " km is less than two cells of " + format_number(cloud.cell) +
                    " km; make the period longer or cell_km smaller");
  }
  const double across = std::ceil(cloud.period / cloud.detail) + 1.0;  // the corners of cells, which tables have
  const double up = std::ceil((cloud.top - cloud.base) / cloud.detail) + 1.0;
  if (across * across * up > static_cast<double>(kMostCloudCells)) {
    blame_cloud(section, "detail_m",
                format_number(cloud.detail * kMetresInKm) + " m makes a grid of " + format_number(across) + " x " +
                    format_number(across) + " x " + format_number(up) + " points; expected at most " +
                    std::to_string(kMostCloudCells) + ": make the cells larger or the period shorter");
  }
}

void read_cloud_phase(const Section& cloud_section, Cloud& cloud) {
  Section section = cloud_section.child("phase");
  section.refuse_unknown_keys();
  const auto function = section.choice("function");
  if (!function) {
    return;
  }
  const bool silent = section.find("function") == nullptr;
  if (silent && cloud.kind == CloudKind::cirrus) {
    cloud.phase = CloudPhase::henyey_greenstein;
    cloud.phase_g = kIcePeak;
    return;
  }
  section.choose(kCloudPhaseNames[*function]);
  cloud.phase = static_cast<CloudPhase>(*function);
  if (cloud.phase == CloudPhase::henyey_greenstein) {
    cloud.phase_g = section.number("g");
  }
}

// Mie's theory for larger spheres takes long, and falling rain is no cloud.
void check_drops(const Section& section, const Cloud& cloud) {
  constexpr double kMostDropRadius = 40.0;
  if (cloud.phase == CloudPhase::drops && cloud.effective_radius > kMostDropRadius) {
    const std::string_view key = cloud.kind == CloudKind::volume && !cloud.voxels ? "file" : "effective_radius_um";
    blame_cloud(section, key,
                "an effective radius of " + format_number(cloud.effective_radius) +
                    " um is above 40 um, the most of the phase function \"drops\"; choose \"henyey-greenstein\"");
  }
}

Cloud read_cloud(Section section, const Planet& planet) {
  section.refuse_unknown_keys();
  Cloud cloud;
  const auto kind = section.choice("type");
  if (!kind) {
    return cloud;
  }
  section.choose(kCloudNames[*kind]);
  const std::size_t before = section.problems().count();
  section.fill(cloud);
  const bool is_file = cloud.kind == CloudKind::volume;
  if (is_file) {
    read_volume(section, cloud);
  } else if (section.problems().count() == before) {  // else defaults stand for what is wrong
    check_field(section, cloud);
  }
  const bool sound = section.problems().count() == before;
  read_cloud_phase(section, cloud);
  check_drops(section, cloud);
  if (sound && !cloud.voxels && (cloud.base < 0.0 || cloud.top > planet.atmosphere_height)) {
    blame_cloud(section, is_file ? "file" : "top_km",
                "the cloud reaches from " + format_number(cloud.base) + " to " + format_number(cloud.top) +
                    " km; expected within the air, 0 to planet.atmosphere_height_km, " +
                    format_number(planet.atmosphere_height));
  }
  return cloud;
}

// A name that no medium has: "cloud layer", "cloud layer 2", ...
std::string free_name(const std::vector<Medium>& media) {
  std::string name = "cloud layer";
  const auto is_taken = [&] { return std::ranges::find(media, name, &Medium::name) != media.end(); };
  for (int number = 2; is_taken(); ++number) {
    name = "cloud layer " + std::to_string(number);
  }
  return name;
}

bool is_layer(const PresetValue& cloud) {
  const auto* type = member_as<std::string>(&cloud, "type");
  return type != nullptr && *type == kCloudNames[kCloudLayer];
}

void add_layer(Section section, const Planet& planet, std::vector<Medium>& media) {
  section.refuse_unknown_keys();
  section.choose(kCloudNames[kCloudLayer]);
  Cloud matter;
  matter.single_scattering_albedo = section.number("single_scattering_albedo");
  matter.effective_radius = section.number("effective_radius_um");
  read_cloud_phase(section, matter);
  check_drops(section, matter);
  if (section.problems().any()) {
    matter.phase = CloudPhase::henyey_greenstein;  // no table of drops that are refused
  }
  Medium medium = read_cloud_layer(section, planet, matter);
  medium.name = free_name(media);
  medium.scattering.curve = constant_curve(medium.scattering[0]);
  medium.absorption.curve = constant_curve(medium.absorption[0]);
  media.push_back(std::move(medium));
}

// Of both, media and clouds, there are at most 8, and of layers of density 256.
void check_counts(const Section& root, const PresetValue& value, std::size_t clouds, std::size_t before,
                  const std::vector<Medium>& media) {
  if (clouds + before > static_cast<std::size_t>(kMaxMedia)) {
    root.complain("clouds", value,
                  std::to_string(clouds) + " clouds beside " + std::to_string(before) +
                      " media; expected at most 8 of both: remove some");
  }
  std::size_t layers = 0;
  for (const Medium& medium : media) {
    layers += medium.density.layers.size();
  }
  if (layers > static_cast<std::size_t>(kMaxDensityLayers)) {
    root.complain("clouds", value,
                  std::to_string(layers) + " density layers of media and clouds in all; expected at most " +
                      std::to_string(kMaxDensityLayers) + ": remove some");
  }
}

}  // namespace

std::vector<Cloud> read_clouds(const Section& root, const Planet& planet, std::vector<Medium>& media) {
  const PresetValue* value = root.find("clouds");
  if (value == nullptr) {
    return {};
  }
  const PresetArray* array = root.list("clouds", *value, "clouds");
  if (array == nullptr) {
    return {};
  }
  const std::size_t before = media.size();
  std::vector<Cloud> clouds;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const Section section = root.element("clouds", *array, i);
    if (is_layer((*array)[i])) {
      add_layer(section, planet, media);
    } else {
      clouds.push_back(read_cloud(section, planet));
      clouds.back().index = i;
    }
  }
  check_counts(root, *value, array->size(), before, media);
  return clouds;
}

}  // namespace airlight
