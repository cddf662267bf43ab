// Reads OpenVDB files through OpenImageIO, whose reader gives a grid as tiles of a volume. Compiled into the module
// alone.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

#include "core/base/text.h"
#include "core/foreign/voxels.h"

namespace airlight::foreign {
namespace {

std::unique_ptr<OIIO::ImageInput> open_grid(const std::string& file, const std::string& grid) {
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openvdb");
  if (!input) {
    OIIO::geterror();
    throw std::runtime_error("this OpenImageIO reads no OpenVDB files; install one that does (Debian's do)");
  }
  OIIO::ImageSpec spec;
  if (!input->open(file, spec)) {
    const std::string why = one_line(input->geterror());
    throw std::runtime_error("damaged or cut short: " + (why.empty() ? "OpenVDB's library cannot read it" : why));
  }
  for (int part = 0; input->seek_subimage(part, 0); ++part) {
    // A grid whose own metadata give no name gets the file's name for it and a full stop.
    const std::string name = input->spec().get_string_attribute("oiio:subimagename");
    if (name == grid || name == grid + ".") {
      return input;
    }
  }
  throw std::runtime_error("the grid cannot be read; write it as a grid of floats");
}

void require_fog(const OIIO::ImageSpec& spec) {
  const std::string kind = spec.get_string_attribute("openvdb:class");
  if (spec.nchannels != 1 || kind == "level set" || kind == "staggered") {
    throw std::runtime_error("the grid is a " + (spec.nchannels != 1 ? "grid of vectors" : kind) +
                             ", no fog volume; choose another or convert it");
  }
}

// Scale and place of the voxels.
void read_transform(const OIIO::ImageSpec& spec, Voxels& voxels) {
  std::array<double, 16> m{};
  std::array<float, 16> narrow{};
  if (!spec.getattribute("openvdb:indextoworld", OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE, OIIO::TypeDesc::MATRIX44),
                         m.data())) {
    if (!spec.getattribute("openvdb:indextoworld", OIIO::TypeMatrix, narrow.data())) {
      throw std::runtime_error("the grid has no linear transform; resample it on an even grid");
    }
    std::ranges::copy(narrow, m.begin());
  }
  const std::array<int, 3> first{spec.full_x, spec.full_y, spec.full_z};
  for (std::size_t i = 0; i < 3; ++i) {
    voxels.size.at(i) = m.at(5 * i);
    voxels.corner.at(i) = m.at(12 + i) + m.at(5 * i) * (first.at(i) - 0.5);
    for (std::size_t j = 0; j < 3; ++j) {
      const bool bad = i == j ? !(m.at(5 * i) > 0.0) : std::abs(m.at(4 * i + j)) > 1e-6 * std::abs(m.at(5 * i));
      if (bad) {
        throw std::runtime_error("the grid is turned, mirrored or sheared; resample it on an even grid");
      }
    }
  }
}

void require_bounded(const OIIO::ImageSpec& spec, std::size_t most, Voxels& voxels) {
  constexpr double kRim = 32.0;  // voxels that tiles reach beyond the box, with room
  voxels.count = {spec.full_width, spec.full_height, spec.full_depth};
  const auto [nx, ny, nz] = voxels.count;
  if (std::min({nx, ny, nz}) < 1) {
    throw std::runtime_error("the grid has no active voxels");
  }
  const auto by = std::to_string(nx) + " x " + std::to_string(ny) + " x " + std::to_string(nz);
  if (1.0 * nx * ny * nz > static_cast<double>(most)) {
    throw std::runtime_error("the grid has " + by + " voxels in its box; expected at most " + std::to_string(most) +
                             ": resample it with larger voxels");
  }
  const bool inside = spec.x <= spec.full_x && spec.y <= spec.full_y && spec.z <= spec.full_z &&
                      spec.x + spec.width >= spec.full_x + nx && spec.y + spec.height >= spec.full_y + ny &&
                      spec.z + spec.depth >= spec.full_z + nz;
  if (!inside || spec.width > nx + kRim || spec.height > ny + kRim || spec.depth > nz + kRim) {
    throw std::runtime_error("damaged or cut short: the box of the grid is not that of its voxels");
  }
}

void read_values(OIIO::ImageInput& input, Voxels& voxels) {
  const OIIO::ImageSpec spec = input.spec();
  const auto wide = static_cast<std::size_t>(spec.width);
  const auto high = static_cast<std::size_t>(spec.height);
  std::vector<float> all(wide * high * static_cast<std::size_t>(spec.depth));
  if (!input.read_image(input.current_subimage(), 0, 0, 1, OIIO::TypeFloat, all.data())) {
    throw std::runtime_error("damaged or cut short: " + one_line(input.geterror()));
  }
  const auto count = [&](std::size_t i) { return static_cast<std::size_t>(voxels.count.at(i)); };
  const auto skipped = [](int full, int stored) { return static_cast<std::size_t>(full - stored); };
  voxels.values.reserve(count(0) * count(1) * count(2));
  for (std::size_t k = 0; k < count(2); ++k) {
    for (std::size_t j = 0; j < count(1); ++j) {
      const std::size_t row = (k + skipped(spec.full_z, spec.z)) * high + j + skipped(spec.full_y, spec.y);
      const auto from = all.begin() + static_cast<std::ptrdiff_t>(row * wide + skipped(spec.full_x, spec.x));
      voxels.values.insert(voxels.values.end(), from, from + voxels.count[0]);
    }
  }
}

}  // namespace
}  // namespace airlight::foreign

extern "C" __attribute__((visibility("default"))) void airlight_read_voxels(const std::string& file,
                                                                            const std::string& grid, std::size_t most,
                                                                            airlight::foreign::Voxels& voxels,
                                                                            std::string& problem) {
  using namespace airlight::foreign;
  try {
    const auto input = open_grid(file, grid);
    require_fog(input->spec());
    require_bounded(input->spec(), most, voxels);
    read_transform(input->spec(), voxels);
    read_values(*input, voxels);
  } catch (const std::bad_alloc&) {
    problem = "takes more memory than a file of its size may";
  } catch (const std::exception& error) {
    problem = airlight::one_line(error.what());
  }
}
