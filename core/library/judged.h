#pragma once
// Turns a preset into a scene, with the contents of the files that it names.

#include <functional>
#include <string>

#include "core/foreign/foreign_picture.h"
#include "core/scene/preset.h"

namespace airlight {

// Reads a picture as foreign::read_picture() does.
using PictureReader = std::function<foreign::Picture(const std::string& file, const foreign::Accept& accept)>;

// Throws InputError with all problems of the preset; else for a file that is missing, no picture, too large or not
// finite; else for a camera inside the terrain. `like`: a scene whose contents are taken over where they are the same,
// as those of the frame before; null: there is none.
Scene judged(const Preset& preset, const PictureReader& read, const Scene* like);

}  // namespace airlight
