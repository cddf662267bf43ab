#pragma once
// A scene ready to be rendered: what its method, its media, its wavelengths and its things come to, found once by
// ready() (core/methods/ready.h) and handed down from there. Nothing below asks the scene again. A stage never changes,
// and a copy costs a pointer.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/air/air.h"
#include "core/air/scene_block.h"
#include "core/night/night.h"
#include "core/scene/scene.h"
#include "core/stage/wavelengths.h"
#include "core/things/things.h"

namespace airlight {

struct SkyMethod;

inline constexpr std::array<Rgb, 3> kAsTheyAre{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

// Three channels of a picture: red, green and blue, or three wavelengths, whose radiance is relative to the sun's and
// times the irradiance that the preset gives.
struct Part {
  Scene scene;  // in these channels
  Air air;
  Things things;
  // What a channel adds to the picture's red, green and blue; 0 for one that only fills the part up. `shares`: the same
  // of a transmittance, relative to sunlight above the air.
  std::array<Rgb, 3> colours = kAsTheyAre;
  std::array<Rgb, 3> shares = kAsTheyAre;
  // Of what the part adds to a plan; empty where it is the only one (Plan::begin_scene).
  std::string suffix = {};
  std::string channels = {};
};

class Stage {
 public:
  const Scene& scene() const;
  const SkyMethod& method() const;

  // The scene's own three channels. Of a scene with spectra they stand for 615, 541 and 449 nm: good for decisions, but
  // its picture is the sum of other parts.
  const Part& whole() const;

  // The parts whose sum is the picture. With spectra each is three wavelengths.
  std::span<const Part> parts() const;

  // The same scene in each further light: its sun is that light. The picture is the sum over this stage and these.
  // Their airs, things and wavelengths are this stage's.
  std::span<const Stage> others() const;

  // Null: the scene has no night sky.
  const Night* night() const;

  // Of what the light adds to a plan (Plan::begin_light); empty: the sun.
  const std::string& light() const;

  // Whether the parts have spectra's wavelengths: then a sum may be a colour with a negative channel, and basis() says
  // which wavelengths they are.
  bool in_colours() const { return scene().spectra.has_value(); }
  const ColourBasis& basis() const;

  // The colour of sunlight above the air, for an irradiance of 1: what a listed direction's transmittance is relative
  // to.
  Rgb sunlight() const { return in_colours() ? basis().sun : Rgb{1.0, 1.0, 1.0}; }

  // Media that scatter in any part, bit i for medium i.
  std::uint32_t scattering_media() const;

 private:
  friend struct StageMaker;
  struct Content;
  explicit Stage(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
  std::shared_ptr<const Content> content_;
};

// How the parts are rendered, all alike, and the air that this takes.
struct PartSettings {
  RenderSettings render;
  AirOptions air;
};

// What a stage is made of. For ready() alone.
struct StageMaker {
  const SkyMethod& method;
  Part whole;
  std::function<PartSettings(const Part& whole)> of_parts;
  std::optional<Nodes> listed;  // wavelengths; absent: the scene's own
  const Stage* like = nullptr;  // taken over is what equals something of it
  // Makes the stages of the scene's further lights, once they are asked for.
  std::function<std::vector<Stage>(const Stage&)> others = {};
  std::string light = {};
  // Makes the night sky of an air's channels where these are wavelengths.
  std::function<Night(const Air&)> night = {};

  Stage make() const;

  // The stage's airs and things.
  static std::vector<Air> airs_of(const Stage& stage);
  static Things::Others things_of(const Stage& stage);
};

// One of these airs, the same matter by other options, or an air made anew.
Air air_like(const std::vector<Air>& known, const Scene& scene, const AirOptions& options);

// What has been made since the program began, for tests that hold it down.
struct MadeSoFar {
  unsigned int stages = 0;
  unsigned int airs = 0;  // anew, with their quadratures
};
MadeSoFar made_so_far();

}  // namespace airlight
