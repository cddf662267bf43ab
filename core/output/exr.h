#pragma once
// Scene-linear EXR files. Equal pictures give equal bytes: no date, owner or host is written.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/radiance_image.h"
#include "core/output/provenance.h"
#include "core/output/working_space.h"

namespace airlight {

// One channel of the picture, read in place; `first` is the sample of the top left pixel.
struct ExrChannel {
  std::string name;  // "R", or "LAYER.R"
  const float* first = nullptr;
  std::size_t stride = 4;   // floats from a pixel to the next; rows follow without a gap
  bool full_float = false;  // 32 bits in a file of halves too
};

// R, G, B and perhaps A of a picture, under a layer's name; empty for the beauty. The picture must outlive them.
void add_channels(std::vector<ExrChannel>& channels, std::string_view layer, const RadianceImage& image,
                  bool with_alpha = false);

// Description of a sequence's frame, under OpenEXR's standard names; unknown members are absent.
struct FrameAttributes {
  std::string label;                         // for `comments`: "frame 12, 2026-06-21T05:00:00+02:00"
  std::optional<int> number;                 // imageCounter
  std::optional<std::string> capture_date;   // capDate: "2026:06:21 05:00:00", on the place's clocks
  std::optional<float> utc_offset;           // s; UTC is the clocks' time plus this
  std::optional<float> latitude, longitude;  // degrees, north and east positive
  std::optional<float> altitude;             // m above the sea
  std::optional<int> frames_a_second;        // framesPerSecond, and timeCode by the number
};

struct ExrOptions {
  bool half = true;                                  // else 32-bit float
  WorkingSpace space = WorkingSpace::linear_rec709;  // space of the given channels
  bool latlong = false;                              // an equirectangular picture: tagged as an environment map
  bool cube = false;                                 // OpenEXR's stack of six faces: tagged likewise
  std::optional<float> white_luminance;              // cd/m2 of radiance (1, 1, 1)
  std::optional<std::array<float, 16>> world_to_camera;
  std::string comments;
  std::optional<FrameAttributes> frame;
  // Writes an ACES image container, SMPTE ST 2065-4: half, uncompressed, red, green and blue in ACES2065-1, perhaps
  // with alpha, and nothing else.
  bool aces_container = false;
  std::optional<Provenance> provenance;
  std::map<std::string, std::string> strings;  // further attributes
  std::map<std::string, float> numbers;
  std::map<std::string, std::array<float, 3>> vectors;
};

// Number of samples that the file could not hold, or that were faulty; alpha is not counted.
struct ExrCounts {
  std::size_t samples = 0;
  std::size_t clamped = 0;      // above 65504 (infinity too), stored as 65504; half only
  std::size_t underflowed = 0;  // not zero but below 2^-14, where a half loses its digits; half only
  std::size_t negative = 0;
  std::size_t nan = 0;
};

struct ExrFile {
  std::vector<std::byte> bytes;
  ExrCounts counts;
};

// Takes bytes at a position, usually the end, once the beginning.
using ExrSink = std::function<void(std::uint64_t position, std::span<const std::byte> bytes)>;

// An EXR whose rows are given from the top, some at a time. The bytes equal those of encode_exr() on all rows. Throws
// RunError, and whatever the sink throws.
class ExrRows {
 public:
  // `channels`: names and formats; their samples are not read. `options`: as for encode_exr().
  ExrRows(const ExrSink& sink, int width, int height, std::span<const ExrChannel> channels, const ExrOptions& options);
  ~ExrRows();
  ExrRows(const ExrRows&) = delete;
  ExrRows& operator=(const ExrRows&) = delete;

  // Adds the next rows; `channels` in the order given, `first` the sample at the left of the first of these rows.
  void add(int rows, std::span<const ExrChannel> channels);

  // To be called after the last row. `numbers`, `vectors`: those attributes of ExrOptions that are known only now.
  ExrCounts finish(const std::map<std::string, float>& numbers = {},
                   const std::map<std::string, std::array<float, 3>>& vectors = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Lets OpenEXR read by all cores, at most 16, from now on.
void start_exr_threads();

// The whole file in memory, for write_file().
ExrFile encode_exr(int width, int height, std::span<const ExrChannel> channels, const ExrOptions& options);

ExrCounts write_exr(const std::filesystem::path& file, int width, int height, std::span<const ExrChannel> channels,
                    const ExrOptions& options);

// For worldToCamera: 16 numbers by rows, for row vectors (p_camera = p_world * M, as OpenEXR's M44f). World: the
// preset's frame, km, origin on the ground below the camera. Camera space: x right, y up, looking down -z.
// The three axes are orthonormal directions in the world; right x up = -forward.
using Axis = std::array<double, 3>;
std::array<float, 16> world_to_camera(const Axis& right, const Axis& up, const Axis& forward, double altitude);

}  // namespace airlight
