#pragma once
// Names of our EXR attributes, written by exr.cpp and read by provenance.cpp.

namespace airlight {

inline constexpr const char* kPresetKey = "airlight:preset";
inline constexpr const char* kMethodKey = "airlight:method";
inline constexpr const char* kVersionKey = "airlight:version";
inline constexpr const char* kDeviceKey = "airlight:device";
// The hash of a sequence's frame, in its PNG too: of everything that determines the file, see app/sequence/job.h.
inline constexpr const char* kHashKey = "airlight:hash";

// Where the sun stands and what it gives, for who uses a picture as light: toward the disc's centre as it is seen (x
// east, y up, z south); its irradiance above the air; where lighting was asked for, on a plane that faces it through
// the air, and the illuminance in lux of level ground by sun, moon and sky. Colours are in the file's space, in the
// unit of the preset's sun.
inline constexpr const char* kSunDirectionKey = "airlight:sun_direction";
inline constexpr const char* kSunAboveAirKey = "airlight:sun_irradiance_above_air";
inline constexpr const char* kSunIrradianceKey = "airlight:sun_irradiance";
inline constexpr const char* kIlluminanceKey = "airlight:illuminance";

}  // namespace airlight
