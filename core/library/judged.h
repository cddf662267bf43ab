#pragma once
// Turns a preset into a scene, with the contents of the files that it names.

#include <functional>
#include <string>

#include "core/foreign/foreign_picture.h"
#include "core/foreign/voxels.h"
#include "core/scene/preset.h"

namespace airlight {

// Reads a picture as foreign::read_picture() does.
using PictureReader = std::function<foreign::Picture(const std::string& file, const foreign::Accept& accept)>;

// Reads a grid of a file of OpenVDB as foreign::read_voxels() does.
using VoxelsReader = std::function<foreign::Voxels(const std::string& file, const std::string& grid, std::size_t most)>;

struct FileReaders {
  PictureReader picture;
  VoxelsReader voxels;
};

// Throws InputError with all problems of the preset; else for a file that is missing, no picture, too large or not
// finite; for a cloud outside the air; else for a camera inside the terrain. `like`: a scene whose contents are taken
// over where they are the same, as those of the frame before; null: there is none.
Scene judged(const Preset& preset, const FileReaders& read, const Scene* like);

}  // namespace airlight
