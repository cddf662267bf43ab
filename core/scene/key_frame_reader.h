#pragma once
// `sequence` of a preset -> KeyFrames.

#include <functional>
#include <optional>
#include <span>

#include "core/scene/key_frames.h"
#include "core/scene/method_info.h"
#include "core/scene/preset.h"
#include "core/scene/section.h"

namespace airlight {

// Nothing where the preset has no `sequence`. What the keys hold is looked at as numbers alone here.
std::optional<KeyFrames> read_key_frames(const Section& root, std::span<const MethodInfo> methods);

// Calls `use` with the preset at each of its key frames, without `sequence`: that frame's keys put in, each value still
// with the line where it stands. Of a preset whose `sequence` read_key_frames() found good. Throws InputError for a
// pointer that leads nowhere.
void for_each_key_frame(const Preset& preset, const std::function<void(const Preset& frame)>& use);

}  // namespace airlight
