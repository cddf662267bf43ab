#pragma once
// What is asked of a scene's sky, and how: rays of a picture or listed directions, and ways up to things.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/radiance_image.h"
#include "core/physics/physics.h"
#include "core/scene/scene.h"

namespace airlight {

// A view direction by its angles in the preset's frame, radians; azimuth clockwise from north.
struct Direction {
  double elevation = 0.0;
  double azimuth = 0.0;
};

// The direction of a unit vector in that frame: x east, y up, -z north.
inline Direction angles_of(const physics::vec3& d) {
  return {std::atan2(d.y, std::hypot(d.x, d.z)), std::atan2(d.x, -d.z)};
}

// The rays to render: the camera's picture, or listed directions from the camera's place (without the sun's disc).
struct View {
  std::span<const Direction> directions;  // empty: the camera's picture
  // Renders listed directions as the camera's picture would, by the same tables; transmittance is not computed.
  bool as_picture = false;
  std::optional<Tile> tile = {};  // of the camera's picture: the part to render
  // Asks for Q and U beside the light: after the transmittance of each listed direction, or as layers. They are what
  // arrives at the lens.
  bool stokes = false;
  // Distance from the camera of a black wall, km, for listed directions of a method on the host. It hides what is
  // behind it and lights nothing.
  std::optional<double> wall = {};
  // Not empty: several plans render the picture, and its own tables are kept from one to the next under keys that begin
  // with this.
  std::string kept_as = {};
  // Renders lights too that others outshine (core/stage/lights.h), so that their tables are there to be written.
  bool all_lights = false;
};

// A ray of the camera's picture through the centre of a pixel, up to a distance in km.
struct Span {
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  float distance = 0.0F;
};

// Rays of the picture up to things, given in one of two ways.
struct Spans {
  std::span<const Span> list = {};
  // Whole rows of the picture: the distance of every pixel, infinite where there is nothing.
  std::span<const float> rows = {};
  std::uint32_t first_row = 0;

  std::size_t size() const { return list.size() + rows.size(); }
};

// The way to find the air up to things.
struct SpanWay {
  bool volume = false;       // true: from a table over directions and distances; false: by a march along each span
  std::string kept_as = {};  // where not empty, as View::kept_as
};

// Options of a host method. None of them changes the result of a given number of samples.
struct HostOptions {
  // Called a few times a second with the share done, 0 to 1. Returns false to stop early with the result so far. May be
  // empty.
  std::function<bool(double done)> report = {};
  // File with the state of a method that samples: read when it exists, written now and then and at the end. Empty:
  // none.
  std::string checkpoint = {};
  double checkpoint_interval_s = 60.0;
  unsigned int threads = 0;  // 0: as many as the machine has
};

struct HostPicture {
  RadianceImage radiance;               // for listed directions: width = their count, height 1
  RadianceImage transmittance;          // listed directions only
  RadianceImage standard_error;         // empty for a deterministic method
  std::uint64_t samples = 0;            // per pixel, for a method that samples
  std::vector<std::string> notes = {};  // what was left undone because it would not have ended
};

}  // namespace airlight
