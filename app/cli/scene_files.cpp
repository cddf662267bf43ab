#include "app/cli/scene_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/foreign/foreign_picture.h"
#include "core/methods/method.h"
#include "core/scene/resolve.h"
#include "core/srgb.h"
#include "core/terrain/terrain.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMostPixels = 4096;  // a side: with its maxima 90 MB of heights, near what one buffer may hold

// Tells a file as it is on the disk from another one of its name, which is read again.
std::string identity_of(const std::string& file) {
  std::error_code ignored;
  const auto size = fs::file_size(file, ignored);
  const auto time = fs::last_write_time(file, ignored).time_since_epoch().count();
  return file + " " + std::to_string(size) + " " + std::to_string(time);
}

foreign::Picture picture_for(const std::string& file, const std::string& key) {
  try {
    foreign::Picture picture = foreign::read_picture(file);
    const int least = key == "height_map" ? 2 : 1;
    if (picture.deep) {
      throw InputError(file + ": is a deep picture; expected a flat one");
    }
    if (std::min(picture.width, picture.height) < least || std::max(picture.width, picture.height) > kMostPixels) {
      throw InputError(file + ": is " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
                       "; expected " + std::to_string(least) + " to " + std::to_string(kMostPixels) +
                       " pixels a side: resize it");
    }
    return picture;
  } catch (const InputError& error) {
    throw InputError("/planet/terrain/" + key + ": " + error.what());
  }
}

void require_finite(const std::vector<float>& values, const std::string& file, const std::string& key) {
  const auto bad = std::count_if(values.begin(), values.end(), [](float x) { return !std::isfinite(x); });
  if (bad > 0) {
    throw InputError("/planet/terrain/" + key + ": " + file + ": " + std::to_string(bad) +
                     " values are not finite; expected a height or a reflectance everywhere: fill the holes");
  }
}

void read_heights(TerrainFiles& files, const std::string& file) {
  const foreign::Picture picture = picture_for(file, "height_map");
  files.columns = picture.width;
  files.rows = picture.height;
  files.heights = picture.channels.front().values;
  require_finite(files.heights, file, "height_map");
  // Heights are no light: what was taken for sRGB by the file's format is taken back.
  if (picture.srgb) {
    std::transform(files.heights.begin(), files.heights.end(), files.heights.begin(), srgb_encoded<float>);
  }
}

void read_colours(TerrainFiles& files, const std::string& file) {
  const foreign::Picture picture = picture_for(file, "albedo_map");
  files.colour_columns = picture.width;
  files.colour_rows = picture.height;
  const foreign::Channel* red = picture.find("R");
  const foreign::Channel* green = picture.find("G");
  const foreign::Channel* blue = picture.find("B");
  const foreign::Channel* grey = &picture.channels.front();
  const bool coloured = red != nullptr && green != nullptr && blue != nullptr;
  for (std::size_t i = 0; i < grey->values.size(); ++i) {
    for (const foreign::Channel* channel : {red, green, blue}) {
      files.colours.push_back(coloured ? channel->values[i] : grey->values[i]);
    }
  }
  require_finite(files.colours, file, "albedo_map");
}

// The last one read is kept: the frames of a sequence share it.
std::shared_ptr<const TerrainFiles> files_of(const Terrain& terrain) {
  static std::mutex mutex;
  static std::shared_ptr<const TerrainFiles> last;
  if (terrain.height_map.empty() && terrain.albedo_map.empty()) {
    return nullptr;
  }
  std::string identity;
  for (const std::string& file : {terrain.height_map, terrain.albedo_map}) {
    identity += file.empty() ? " none" : " " + identity_of(file);
  }
  const std::lock_guard lock(mutex);
  if (last == nullptr || last->identity != identity) {
    auto files = std::make_shared<TerrainFiles>();
    files->identity = identity;
    if (!terrain.height_map.empty()) {
      read_heights(*files, terrain.height_map);
    }
    if (!terrain.albedo_map.empty()) {
      read_colours(*files, terrain.albedo_map);
    }
    last = files;
  }
  return last;
}

}  // namespace

Scene judged(const Preset& preset) {
  Scene scene = resolve(preset, method_infos());
  if (scene.terrain) {
    try {
      scene.terrain->files = files_of(*scene.terrain);
      terrain_of(scene);
    } catch (const InputError& error) {
      throw InputError(preset.source + ": " + error.what());
    }
  }
  return scene;
}

}  // namespace airlight::cli
