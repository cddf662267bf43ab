#pragma once
// `sequence --radiance-matrix FILE.mtx`: the sky over many hours as Radiance's daylight programs take it, a row a patch
// and a column a moment.
//
// Rows are the patches of core/render/sky_patches.h, the ground first. Each value is the patch's mean radiance in
// Radiance's colours (app/render/radiance_files.h). The discs' light lies in the four patches around them
// (SkyPatches::around()), so that a level surface gets what sun and moon give it. Moments with the sun below -18
// degrees are 0 where nothing else lights the scene.

#include <string>

#include "app/sequence/job.h"

namespace airlight::cli {

struct MatrixOrder {
  std::string file;
  int factor = 1;  // Reinhart's, 1 to 4
};

// Throws InputError: not a .mtx, no times (a sweep or key frames), more than kMostMatrixValues, no place to write.
inline constexpr std::size_t kMostMatrixValues = 100'000'000;
void check_matrix(const MatrixOrder& order, const SequenceJob& job);

// Writes the file once all columns are there. Returns a signal that ended it before, 0: none. Throws RunError.
int write_matrix(const MatrixOrder& order, const SequenceJob& job);

}  // namespace airlight::cli
