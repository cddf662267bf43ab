#pragma once
// Clouds of OpenVDB's files.

#include "core/library/judged.h"

namespace airlight {

// Reads the files of all clouds that have voxels, and places them. Throws InputError with the key: what `read` throws,
// a value that is negative or not finite, no value above 0, extinctions above 1e5 per km, a cloud outside the air.
// `like`: contents are taken over from it where they are the same; null: there is none.
void fill_voxels(const VoxelsReader& read, Scene& scene, const Scene* like);

}  // namespace airlight
