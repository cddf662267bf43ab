#pragma once
// A rendering as files in memory: the scene-linear EXR, and the PNG for people.

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/picture_options.h"
#include "core/output/display.h"
#include "core/output/exr.h"
#include "core/output/png.h"
#include "core/render/render.h"

namespace airlight::cli {

// The attribute of an EXR that says what its PNG was exposed by.
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
  std::vector<std::string> left_out = {};  // by that choice, unless the rendering says so itself
  std::string exr_hash = {};               // of a sequence's frame, see app/sequence/job.h; empty: none is written
  std::string png_hash = {};
  WorkingSpace space = WorkingSpace::linear_rec709;  // of the EXR's colours
  std::optional<FrameAttributes> frame = {};         // of a sequence
};

// The channels of an EXR of this context, read from its rendering, which must outlive them: the beauty and what stands
// beside it. In another space than linear Rec.709 all light is converted, and the transmittance as the colour of white
// seen through the air.
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
// For an equirectangular picture that is none; else empty.
std::string latlong_warning(const Scene& scene);

ExrOptions exr_options(const PictureContext& context, bool half);

ExrFile picture_exr(const PictureContext& context, bool half);

// A PNG whose rows come in bands: the same bytes as picture_png() makes of all of them.
class PicturePng {
 public:
  // `context`: its scene's image is the whole one, its rendering has perhaps the first rows alone. `transform`, which
  // must outlive it: none for the two views above.
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

std::vector<std::byte> picture_png(const PictureContext& context, const std::optional<DisplayTransform>& transform,
                                   int bits);

// Colours NaN magenta, infinity yellow, negative blue, finite light grey and zero black. In a pixel of several kinds
// the first of this list wins.
RadianceImage diagnostic_picture(const RadianceImage& radiance);

// What the colours mean, for the message that goes with such a picture.
std::string diagnostic_legend();

}  // namespace airlight::cli
