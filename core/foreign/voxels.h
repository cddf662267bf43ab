#pragma once
// A grid of an OpenVDB file as an even block of values, read by OpenImageIO in the module.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace airlight::foreign {

struct Voxels {
  std::array<std::int32_t, 3> count{};  // of the box of active voxels, along the file's x, y and z
  std::array<double, 3> size{};         // of a voxel, in the unit of the file's transform
  std::array<double, 3> corner{};       // of the box, its lowest coordinates, likewise
  std::vector<float> values;            // in the voxels' middles: x fastest, then y, then z
};

// Throws InputError: the file is missing, no regular file, no OpenVDB file, damaged or cut short, without a grid of
// that name, or the grid is no fog volume, is turned or sheared, has no active voxel or more than `most` in its box.
// RunError where the module cannot be loaded or its OpenImageIO reads no OpenVDB files. A process of its own reads the
// file, with bounded memory and time, so that a damaged file ends that process alone.
Voxels read_voxels(const std::string& file, const std::string& grid, std::size_t most);

// The module's entry. Never throws: `problem` is one line, empty on success.
inline constexpr const char* kVoxelsEntry = "airlight_read_voxels";
using VoxelsFunction = void (*)(const std::string& file, const std::string& grid, std::size_t most, Voxels& voxels,
                                std::string& problem);

}  // namespace airlight::foreign
