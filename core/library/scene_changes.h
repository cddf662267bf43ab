#pragma once
// The options that change a scene, by the names that the command line and Python share. Each one becomes an override of
// the preset, so that one validator checks everything.

#include <optional>
#include <string>
#include <vector>

#include "core/scene/preset.h"
#include "core/scene/scene.h"

namespace airlight {

// A key of the preset, changed by an option.
struct Override {
  std::string assignment;                   // "POINTER=JSON"
  std::string typed;                        // the option as typed, for messages: "--view filmic"
  std::vector<std::string> only_with = {};  // applied if the preset has one of these sections; empty: always
  std::string adds = {};                    // a section: applied if `sky_of_date` is true and the preset has none
};

// By its date, time and place the sun's angles (core/library/place.h).
struct PlaceOptions {
  std::optional<std::string> date;
  std::optional<std::string> time;  // for one picture
  std::optional<std::string> zone;
  std::optional<double> latitude;
  std::optional<double> longitude;
  std::optional<double> altitude;
  bool refraction = false;
  std::optional<double> pressure;
  std::optional<double> temperature;
};

struct SceneChanges {
  std::vector<std::string> set;  // "POINTER=JSON"
  std::optional<double> sun_elevation;
  std::optional<double> sun_azimuth;
  std::optional<double> altitude;
  std::optional<double> azimuth;
  std::optional<double> pitch;
  std::optional<double> field_of_view;
  std::optional<std::string> projection;
  std::optional<std::string> size;
  std::optional<std::string> method;
  bool as_keywords = false;  // messages say "sun_elevation=4", not "--sun-elevation 4"
};

// "1920x1080"; none where the text is not two whole numbers.
std::optional<ImageSize> size_from(const std::string& text);

// Applies the changes to the preset, then `further`, then `set`; the preset is not yet judged. Another projection drops
// what only the preset's own could have: its field of view, and for a map its tilt. Unless a size is given the picture
// gets a suitable size. Throws InputError.
void apply_changes(Preset& preset, const SceneChanges& changes, const std::vector<Override>& further = {});

// The options that set_option() takes, without dashes before them: "sun-elevation".
std::vector<std::string> change_names();

// Sets an option by its name, '-' or '_' between words. Throws InputError: unknown name, with the nearest; no number.
void set_option(SceneChanges& changes, std::vector<Override>& further, PlaceOptions& place, const std::string& name,
                const std::string& value);

}  // namespace airlight
