#pragma once
// Names of our EXR attributes, written by exr.cpp and read by provenance.cpp.

namespace airlight {

inline constexpr const char* kPresetKey = "airlight:preset";
inline constexpr const char* kMethodKey = "airlight:method";
inline constexpr const char* kVersionKey = "airlight:version";
inline constexpr const char* kDeviceKey = "airlight:device";
// The hash of a sequence's frame, in its PNG too: of everything that determines the file, see app/sequence/job.h.
inline constexpr const char* kHashKey = "airlight:hash";

}  // namespace airlight
