#pragma once
// What the files of a picture hold: the scene-linear EXR, and the PNG for people.

#include <array>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/picture_options.h"
#include "core/output/display.h"
#include "core/output/exr.h"
#include "core/output/png.h"
#include "core/render/lighting.h"
#include "core/render/render.h"

namespace airlight::cli {

// The EXR's attribute with the exposure of its PNG.
inline constexpr const char* kExposureKey = "airlight:exposure";

// The quality that was chosen for the picture, and its error.
struct ChoiceNote {
  std::string quality;
  double error = 0.0;  // bound on the mean relative error
};

struct PictureContext {
  const Scene& scene;
  const Rendering& rendering;
  Provenance provenance;
  std::optional<ChoiceNote> choice = {};
  std::vector<std::string> left_out = {};  // by that choice; empty where the rendering names them
  std::string exr_hash = {};               // for a sequence's frame, see app/sequence/job.h; empty: none is written
  std::string png_hash = {};
  WorkingSpace space = WorkingSpace::linear_rec709;  // of the EXR's colours
  std::optional<FrameAttributes> frame = {};         // of a sequence
  bool lit = false;                                  // a Lighting will be known when the EXR is finished
};

// The channels of an EXR of this context: the beauty and further channels, read from its rendering, which must outlive
// them. In another space than linear Rec.709 all light is converted, and the transmittance as the colour of white seen
// through the air.
class PictureChannels {
 public:
  explicit PictureChannels(const PictureContext& context);
  PictureChannels(const PictureChannels&) = delete;
  PictureChannels& operator=(const PictureChannels&) = delete;

  const std::vector<ExrChannel>& list() const { return channels_; }

 private:
  void add_colours(std::string_view layer, const RadianceImage& image, bool with_alpha = false);
  void add_layer(const Layer& layer);
  std::vector<float> converted_planes(const std::vector<float>& rgb) const;

  WorkingSpace space_;
  std::deque<RadianceImage> images_;  // converted
  std::deque<std::vector<float>> planes_;
  std::vector<ExrChannel> channels_;
};

// Whether the picture is an environment map as OpenEXR's latlong is: equirectangular, twice as wide as high.
bool is_latlong(const Scene& scene);
// A warning for an equirectangular picture that is no latlong; else empty.
std::string latlong_warning(const Scene& scene);

ExrOptions exr_options(const PictureContext& context, bool half);

// What an EXR's header says of the light around the camera.
struct ExrLight {
  std::map<std::string, float> numbers;
  std::map<std::string, std::array<float, 3>> vectors;
};
ExrLight exr_light(const Lighting& lighting, const PictureContext& context);

// The colour in the space of the pictures.
Vector3 in_space(const Vector3& rgb, WorkingSpace space);

// A PNG whose rows come in bands.
class PicturePng {
 public:
  // `context`: its scene's image is the whole one; its rendering may hold the first rows only. `transform`, which must
  // outlive this: none for the two views above.
  PicturePng(PngRows::Sink sink, const PictureContext& context, const std::optional<DisplayTransform>& transform,
             int bits);
  ~PicturePng();
  PicturePng(const PicturePng&) = delete;
  PicturePng& operator=(const PicturePng&) = delete;

  void add(const Rendering& rows);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// NaN is magenta, infinity yellow, negative blue, finite light grey, zero black. A pixel of several kinds has the
// colour of the first of them.
RadianceImage diagnostic_picture(const RadianceImage& radiance);

// The meaning of the colours, for the message with such a picture.
std::string diagnostic_legend();

}  // namespace airlight::cli
