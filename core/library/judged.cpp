#include "core/library/judged.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/srgb.h"
#include "core/library/cloud_voxels.h"
#include "core/library/file_identity.h"
#include "core/methods/method.h"
#include "core/scene/json_format.h"
#include "core/scene/resolve.h"
#include "core/spectra/reflectance.h"
#include "core/things/ground.h"
#include "core/things/terrain.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;

constexpr int kMostPixels = 4096;  // on a side: with its maxima 90 MB of heights, near what one buffer may hold

constexpr int kMostMapPixels = 16384;  // across a whole planet

// `key`: the preset's key, for messages. `planet`: the picture must be twice as wide as high.
foreign::Picture picture_for(const PictureReader& read, const std::string& file, const std::string& key, bool planet) {
  try {
    const int least = key.ends_with("height_map") || planet ? 2 : 1;
    const int most = planet ? kMostMapPixels : kMostPixels;
    return read(file, [&](const foreign::Picture& picture) {
      if (picture.deep) {
        throw InputError(file + ": is a deep picture; expected a flat one");
      }
      if (std::min(picture.width, picture.height) < least || std::max(picture.width, picture.height) > most) {
        throw InputError(file + ": is " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
                         "; expected " + std::to_string(least) + " to " + std::to_string(most) +
                         " pixels a side: resize it");
      }
      if (planet && picture.width != 2 * picture.height) {
        throw InputError(file + ": is " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
                         "; expected twice as wide as high, the whole planet equirectangular: resize it");
      }
    });
  } catch (const InputError& error) {
    throw InputError(key + ": " + error.what());
  }
}

// `values`: as many of each pixel of the picture, in its order.
void require_finite(const std::vector<float>& values, const foreign::Picture& picture, const std::string& key) {
  const auto is_bad = [](float x) { return !std::isfinite(x); };
  const auto bad = std::ranges::count_if(values, is_bad);
  if (bad > 0) {
    const std::int64_t pixels = std::int64_t{picture.width} * picture.height;
    const auto at = (std::ranges::find_if(values, is_bad) - values.begin()) / (std::ssize(values) / pixels);
    throw InputError(key + ": " + picture.file + ": " + std::to_string(bad) + " values are not finite, the first at (" +
                     std::to_string(at % picture.width) + ", " + std::to_string(at / picture.width) +
                     "); expected a height or a reflectance everywhere: fill the holes");
  }
}

void require_reflectances(const std::vector<float>& values, const foreign::Picture& picture, const std::string& key) {
  require_finite(values, picture, key);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const float bad = *least < 0.0F ? *least : *most;
  if (bad < 0.0F || bad > 1.0F) {
    throw InputError(key + ": " + picture.file + ": holds the value " + format_number(static_cast<double>(bad)) +
                     "; expected 0 to 1, what part of the light is sent back: scale the picture");
  }
}

void read_heights(const PictureReader& read, TerrainFiles& files, const std::string& file) {
  const std::string key = "/planet/terrain/height_map";
  const foreign::Picture picture = picture_for(read, file, key, false);
  files.columns = picture.width;
  files.rows = picture.height;
  files.heights = picture.channels.front().values;
  require_finite(files.heights, picture, key);
  // Heights are no light, so the decoding of a file whose format counts as sRGB is undone.
  if (picture.srgb) {
    std::transform(files.heights.begin(), files.heights.end(), files.heights.begin(), srgb_encoded<float>);
  }
}

// R, G and B of each pixel, or the first channel for all three.
std::vector<float> colours_of(const foreign::Picture& picture) {
  const foreign::Channel* red = picture.find("R");
  const foreign::Channel* green = picture.find("G");
  const foreign::Channel* blue = picture.find("B");
  const foreign::Channel* grey = &picture.channels.front();
  const bool coloured = red != nullptr && green != nullptr && blue != nullptr;
  std::vector<float> colours;
  colours.reserve(3 * grey->values.size());
  for (std::size_t i = 0; i < grey->values.size(); ++i) {
    for (const foreign::Channel* channel : {red, green, blue}) {
      colours.push_back(coloured ? channel->values[i] : grey->values[i]);
    }
  }
  return colours;
}

void read_colours(const PictureReader& read, TerrainFiles& files, const std::string& file) {
  const std::string key = "/planet/terrain/albedo_map";
  const foreign::Picture picture = picture_for(read, file, key, false);
  files.colour_columns = picture.width;
  files.colour_rows = picture.height;
  files.colours = colours_of(picture);
  require_finite(files.colours, picture, key);
}

void read_planet(const PictureReader& read, GroundFiles& files, const std::string& file) {
  const std::string key = "/planet/albedo_map";
  const foreign::Picture picture = picture_for(read, file, key, true);
  files.colour_rows = picture.height;
  files.colours = colours_of(picture);
  require_reflectances(files.colours, picture, key);
}

void read_water(const PictureReader& read, GroundFiles& files, const std::string& file) {
  const std::string key = "/planet/ocean/mask_map";
  const foreign::Picture picture = picture_for(read, file, key, true);
  files.water_rows = picture.height;
  files.water = picture.channels.front().values;
  require_reflectances(files.water, picture, key);
  if (picture.srgb) {
    std::transform(files.water.begin(), files.water.end(), files.water.begin(), srgb_encoded<float>);
  }
}

// The identities of these files, in their order.
std::string identities_of(std::initializer_list<std::string> files) {
  std::string identity;
  for (const std::string& file : files) {
    identity += file.empty() ? " none" : " " + identity_of(file);
  }
  return identity;
}

// The files of `like`, if they are the same, or else as `fill` fills them in.
template <class Files, class Read>
std::shared_ptr<const Files> taken_over(const std::shared_ptr<const Files>& like, const std::string& identity,
                                        const Read& fill) {
  if (like != nullptr && like->identity == identity) {
    return like;
  }
  auto files = std::make_shared<Files>();
  files->identity = identity;
  fill(*files);
  return files;
}

std::shared_ptr<const TerrainFiles> files_of(const PictureReader& read, const Terrain& terrain,
                                             const std::shared_ptr<const TerrainFiles>& like) {
  if (terrain.height_map.empty() && terrain.albedo_map.empty()) {
    return nullptr;
  }
  return taken_over(like, identities_of({terrain.height_map, terrain.albedo_map}), [&](TerrainFiles& files) {
    if (!terrain.height_map.empty()) {
      read_heights(read, files, terrain.height_map);
    }
    if (!terrain.albedo_map.empty()) {
      read_colours(read, files, terrain.albedo_map);
    }
  });
}

std::shared_ptr<const GroundFiles> files_of(const PictureReader& read, const GroundMap& ground,
                                            const std::shared_ptr<const GroundFiles>& like) {
  const std::string mask = ground.ocean ? ground.ocean->mask_map : std::string();
  if (ground.albedo_map.empty() && mask.empty()) {
    return nullptr;
  }
  return taken_over(like, identities_of({ground.albedo_map, mask}), [&](GroundFiles& files) {
    if (!ground.albedo_map.empty()) {
      read_planet(read, files, ground.albedo_map);
    }
    if (!mask.empty()) {
      read_water(read, files, mask);
    }
  });
}

void fill_terrain(const PictureReader& read, Scene& scene, const Terrain* like) {
  Terrain& terrain = *scene.terrain;
  terrain.files = files_of(read, terrain, like == nullptr ? nullptr : like->files);
  if (terrain.ridge) {
    const bool same = like != nullptr && like->ridge == terrain.ridge;
    terrain.ridge_heights = same ? like->ridge_heights : ridge_heights_of(*terrain.ridge);
  }
  const auto heights = std::make_shared<const physics::HostTerrain>(placed_heights(terrain));
  refuse_sunken(terrain, *heights);
  refuse_buried_camera(scene.camera.altitude, heights);
}

}  // namespace

Scene judged(const Preset& preset, const FileReaders& read, const Scene* like) {
  Scene scene = resolve(preset, method_infos());
  try {
    if (scene.terrain) {
      fill_terrain(read.picture, scene, like != nullptr && like->terrain ? &*like->terrain : nullptr);
    }
    if (scene.ground) {
      scene.ground->files =
          files_of(read.picture, *scene.ground, like != nullptr && like->ground ? like->ground->files : nullptr);
      if (scene.ground->files && !scene.ground->files->colours.empty()) {
        scene.planet.ground_albedo = mean_albedo(*scene.ground->files);
        if (scene.spectra) {
          scene.planet.ground_albedo.curve =
              reflectance_of(scene.planet.ground_albedo, scene.spectra->sun, scene.spectra->white);
        }
      }
    }
    fill_voxels(read.voxels, scene, like);
  } catch (const InputError& error) {
    throw InputError(preset.source + ": " + error.what());
  }
  refuse_misfits(preset, scene, method_infos());
  return scene;
}

}  // namespace airlight
