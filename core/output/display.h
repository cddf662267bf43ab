#pragma once
// Scene-linear radiance to display colours, through OpenColorIO.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/radiance_image.h"
#include "core/output/quantize.h"

namespace airlight {

struct DisplaySettings {
  std::string config;   // path of an OCIO config; empty: $OCIO, or the one built in
  std::string display;  // empty: the config's default
  std::string view;     // empty: the display's default
  QuantizeOptions pixels;
  // Transforms every pixel by OpenColorIO itself. Otherwise an 8-bit picture is interpolated between transformed
  // colours wherever that stays within half a code (about 5 times cheaper); 16 bits are always exact.
  bool exact = false;
};

// Light to be added to rows of a picture before the display transform.
struct AddedLight {
  const float* rgba = nullptr;  // as many pixels as the rows have; null: none
  float intensity = 0.0F;
};

// The config, read and with its names checked. It is made before rendering, so that a wrong name costs no render.
class DisplayTransform {
 public:
  // Throws InputError: config missing or broken, unknown display or view (with the choices and the nearest).
  explicit DisplayTransform(const DisplaySettings& settings);
  ~DisplayTransform();
  DisplayTransform(DisplayTransform&&) noexcept;
  DisplayTransform& operator=(DisplayTransform&&) noexcept;

  const std::string& display() const;
  const std::string& view() const;
  const std::string& config() const;          // the path, or "the built-in config"
  const std::string& warning() const;         // assumption made about the config; usually empty
  std::optional<ColourCode> colours() const;  // meaning of its pixels, where known

  // (image + intensity * light) * exposure, transformed. Alpha passes unchanged.
  PixelImage apply(const RadianceImage& image, const AddedLight& light, float exposure) const;

 private:
  friend class DisplayRows;
  struct State;
  std::unique_ptr<State> state_;
};

// The display transform of a picture that comes row by row. The pixels equal those of DisplayTransform::apply() on the
// whole picture, however the rows are divided.
class DisplayRows {
 public:
  // Takes finished rows, from the top.
  using Sink = std::function<void(const PixelImage& rows)>;

  // The transform must outlive it.
  DisplayRows(const DisplayTransform& transform, int width, int height, Sink sink);
  ~DisplayRows();
  DisplayRows(const DisplayRows&) = delete;
  DisplayRows& operator=(const DisplayRows&) = delete;

  // Adds the next rows. With the picture's last row the sink gets all that remains.
  void add(const RadianceImage& rows, const AddedLight& light, float exposure);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace airlight
