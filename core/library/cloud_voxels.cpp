#include "core/library/cloud_voxels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/library/file_identity.h"
#include "core/scene/cloud_file.h"
#include "core/scene/json_format.h"

namespace airlight {
namespace {

constexpr double kMostExtinction = 1e5;  // 1/km, as that of media

// The file's axes by the cloud's (east, north, up).
std::array<std::size_t, 3> axes_of(UpAxis up) {
  return up == UpAxis::y ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
}

void require_density(const foreign::Voxels& voxels, const CloudVoxels& how) {
  float most = 0.0F;
  for (std::size_t i = 0; i < voxels.values.size(); ++i) {
    const float value = voxels.values[i];
    if (!std::isfinite(value) || value < 0.0F) {
      const auto wide = static_cast<std::size_t>(voxels.count[0]);
      const auto high = static_cast<std::size_t>(voxels.count[1]);
      throw InputError("holds the value " + format_number(static_cast<double>(value)) + " at voxel " +
                       std::to_string(i % wide) + ", " + std::to_string(i / wide % high) + ", " +
                       std::to_string(i / wide / high) + " of its box; expected finite densities of at least 0");
    }
    most = std::max(most, value);
  }
  if (most == 0.0F) {
    throw InputError("holds no value above 0; expected a density");
  }
  if (static_cast<double>(most) * how.extinction > kMostExtinction) {
    throw InputError("its highest value, " + format_number(static_cast<double>(most)) + ", times extinction_per_km, " +
                     format_number(how.extinction) + ", is above 100000 per km; make extinction_per_km smaller");
  }
}

// Extinction in the order of a cloud's file. With y up the file's z points south.
std::vector<float> extinction_of(const foreign::Voxels& voxels, const CloudVoxels& how) {
  const auto [nx, ny, nz] = voxels.count;
  const bool turned = how.up == UpAxis::y;
  const auto scale = static_cast<float>(how.extinction);
  std::vector<float> out;
  out.reserve(voxels.values.size());
  for (int k = 0; k < (turned ? ny : nz); ++k) {
    for (int j = 0; j < (turned ? nz : ny); ++j) {
      const auto y = static_cast<std::size_t>(turned ? k : j);
      const auto z = static_cast<std::size_t>(turned ? nz - 1 - j : k);
      const float* row = &voxels.values[static_cast<std::size_t>(nx) * (y + static_cast<std::size_t>(ny) * z)];
      std::transform(row, row + nx, std::back_inserter(out), [&](float value) { return scale * value; });
    }
  }
  return out;
}

// FNV-1a over the numbers: two grids of the same numbers are one cloud.
std::string identity_of_numbers(const CloudFile& cloud) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](std::uint64_t bits) { hash = (hash ^ bits) * 0x100000001b3U; };
  for (const float value : cloud.extinction) {
    add(std::bit_cast<std::uint32_t>(value));
  }
  for (const double value : {cloud.dx, cloud.dy, cloud.dz}) {
    add(std::bit_cast<std::uint64_t>(value));
  }
  return "voxels " + std::to_string(cloud.nx) + "x" + std::to_string(cloud.ny) + "x" + std::to_string(cloud.nz) + ":" +
         std::to_string(hash);
}

// All of the voxels and keys that the contents depend on.
std::string origin_of(const Cloud& cloud) {
  const CloudVoxels& how = *cloud.voxels;
  return identity_of(cloud.file) + " " + how.grid + " " + std::to_string(static_cast<int>(how.up)) + " " +
         shortest(how.unit) + " " + shortest(how.extinction);
}

std::shared_ptr<const CloudFile> contents_of(const VoxelsReader& read, const Cloud& cloud) {
  const CloudVoxels& how = *cloud.voxels;
  const foreign::Voxels voxels = read(cloud.file, how.grid, kMostCloudCells);
  require_density(voxels, how);
  const auto [east, north, up] = axes_of(how.up);
  auto contents = std::make_shared<CloudFile>();
  contents->nx = voxels.count.at(east);
  contents->ny = voxels.count.at(north);
  contents->nz = voxels.count.at(up);
  contents->dx = voxels.size.at(east) * how.unit;
  contents->dy = voxels.size.at(north) * how.unit;
  contents->dz = voxels.size.at(up) * how.unit;
  contents->lowest = (voxels.corner.at(up) + 0.5 * voxels.size.at(up)) * how.unit;
  constexpr double kLeast = 1e-4;  // km, as of a text's points
  constexpr double kMost = 100.0;
  for (const double side : {contents->dx, contents->dy, contents->dz}) {
    if (!(side >= kLeast && side <= kMost)) {
      throw InputError("its voxels are " + rounded(side, 6) +
                       " km a side; expected 0.0001 to 100 km: set metres_per_unit");
    }
  }
  contents->extinction = extinction_of(voxels, how);
  contents->identity = identity_of_numbers(*contents);
  contents->origin = origin_of(cloud);
  return contents;
}

void place(Cloud& cloud, const Planet& planet) {
  const CloudFile& file = *cloud.contents;
  cloud.base = cloud.voxels->base.value_or(file.lowest - 0.5 * file.dz);
  cloud.top = cloud.base + file.dz * file.nz;
  if (!(cloud.base >= 0.0 && cloud.top <= planet.atmosphere_height)) {
    throw InputError("the cloud reaches from " + rounded(cloud.base, 6) + " to " + rounded(cloud.top, 6) +
                     " km; expected within the air, 0 to planet.atmosphere_height_km, " +
                     format_number(planet.atmosphere_height) + ": set base_km" +
                     (cloud.voxels->base ? " or metres_per_unit" : ", or metres_per_unit"));
  }
}

}  // namespace

void fill_voxels(const VoxelsReader& read, Scene& scene, const Scene* like) {
  for (Cloud& cloud : scene.clouds) {
    if (!cloud.voxels) {
      continue;
    }
    const std::string key = "/clouds/" + std::to_string(cloud.index) + "/file: ";
    try {
      const std::string origin = origin_of(cloud);
      const auto known = [&](const Cloud& other) { return other.contents && other.contents->origin == origin; };
      const Cloud* same = nullptr;
      if (like != nullptr) {
        const auto found = std::ranges::find_if(like->clouds, known);
        same = found == like->clouds.end() ? nullptr : &*found;
      }
      cloud.contents = same != nullptr ? same->contents : contents_of(read, cloud);
      place(cloud, scene.planet);
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(key + (what.starts_with(cloud.file) ? what : cloud.file + ": " + what));
    }
  }
}

}  // namespace airlight
