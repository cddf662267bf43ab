#pragma once
// A scene rendered from end to end on a device: tables, sky, disc, statistics, bloom, tone curve. Knows no files.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/gpu/executor.h"
#include "core/methods/method.h"
#include "core/post/post.h"
#include "core/render/layers.h"
#include "core/render/pixels.h"
#include "core/render/table_reads.h"
#include "core/scene/scene.h"
#include "core/spectra/colour.h"

namespace airlight {

// Opens the device on first use: a method on the host needs none.
using DeviceOnDemand = std::function<Executor&()>;

struct RenderRequest {
  bool bloom = false;                // compute bloom where the scene asks for it and anything exceeds the threshold
  bool bloom_picture = true;         // read bloom back at the picture's size; false: only the GPU tone curve sees it
  bool gpu_tone = false;             // also run the GPU tone curve
  bool tables = false;               // read the tables back
  LayerSet layers = LayerSet::none;  // for a method that has add_layer_passes
  // Wavelengths of a spectrum beside the picture, of a scene with spectra. The colours are then the spectrum's own if
  // it yields them to kTellsColours (core/render/spectrum.h); a fault at any wavelength is the result's fault.
  std::optional<Nodes> spectrum = {};
  HostOptions host = {};  // for a method on the host; `report` also hears of the device
};

struct Rendering : Pixels {
  double exposure = 1.0;
  Statistics picture;
  std::vector<NamedStatistics> tables_statistics;
  std::vector<TableDump> tables;
  std::vector<NamedStatistics> layer_statistics;
  std::vector<std::string> left_out;  // parts that this picture does not need, with the reason
  std::vector<std::string> undone;    // parts that it needs but that would not have ended
  std::vector<PassTiming> passes;
  std::vector<Milestone> host;

  // Empty, or one line that names the first of the tables, the layers and the picture with a NaN, an infinity or a
  // negative value, and its place.
  std::string fault() const;
  std::string picture_fault() const;  // the same without the layers
};

// The whole picture in memory. Throws RunError when the device fails. A poisoned result is returned, not thrown: see
// Rendering::fault().
Rendering render(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request);

// Opens the device where bloom or tone curve of a picture made on the host would need it, before hours of samples are
// spent on a machine that lacks one.
void open_for_post(const DeviceOnDemand& device, const Stage& stage, const RenderRequest& request);

// A plan with every pass that render() may run, of a spectrum those of its first wavelengths, and the tables' sizes;
// opens no device.
Plan plan_for(const Stage& stage, const RenderRequest& request);

struct ProbeResult {
  Direction direction;
  std::array<double, 3> radiance{};       // without the sun's disc
  std::array<double, 3> transmittance{};  // to the ground or to space
  // Of polarised light, by a method that tells them; q > 0 in the plane of direction and zenith, u > 0 leaning from
  // downward toward growing azimuth.
  std::optional<std::array<double, 3>> q{};
  std::optional<std::array<double, 3>> u{};
};

struct ProbeResults {
  std::vector<ProbeResult> directions;
  std::vector<std::string> undone;  // as Rendering::undone
};

// The same scene without a polarising filter.
Stage without_filter(const Stage& stage);

// What probe() asks of the method.
View probe_view(const Stage& stage, const std::vector<Direction>& directions);

// The scene's method in listed directions from the camera's place; before a polarising filter.
ProbeResults probe(const DeviceOnDemand& device, const Stage& stage, const std::vector<Direction>& directions);

// RGB of listed directions as in the scene's picture, behind its filter, without the sun's disc.
std::vector<float> probe_picture(const DeviceOnDemand& device, const Stage& stage,
                                 const std::vector<Direction>& directions);

// The tables alone.
std::vector<TableDump> bake_tables(const DeviceOnDemand& device, const Stage& stage);

}  // namespace airlight
