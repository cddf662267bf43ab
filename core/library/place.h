#pragma once
// Place on Earth and date, which say where sun, moon and stars stand.

#include <optional>
#include <string>
#include <vector>

#include "core/library/scene_changes.h"
#include "core/sequence/sun_position.h"

namespace airlight {

// Both throw InputError; `command`: "render".
sequence::Place place_of(const PlaceOptions& options);
std::optional<sequence::Air> air_of(const PlaceOptions& options, const std::string& command);

// Refuses --refraction where the scene's own air bends light: the sun would be lifted twice.
void require_one_refraction(const PlaceOptions& options, const Scene& scene, const std::string& command);

// What a date adds to a preset whose `sky_of_date` is true: the moon, the stars and the smooth light of the night,
// where it has none. `typed`: the option, for messages.
std::vector<Override> sky_of_date(const std::string& typed);

// Takes out of a moment's preset what the moment cannot show: a moon far below the horizon that the camera sees, and
// with the sun up the smooth light of the night, where its date has added it. `typed` of sky_of_date() begins with
// "--date " for that.
void leave_out_unseen(Preset& preset);

// Takes a night sky of the preset's own out of a scene by day, where it is less than 1e-4 of the darkest sky: not where
// the air is thin, the camera high, lamps are bright or clouds hide the day. Stars stay.
void leave_out_outshone(Scene& scene);

// Sun, moon and stars of one picture, of which leave_out_unseen() takes out what its camera does not see; empty where
// no option concerns them. Throws InputError.
std::vector<Override> sun_overrides(const PlaceOptions& options, const SceneChanges& changes,
                                    const std::string& command);

}  // namespace airlight
