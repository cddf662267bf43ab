#pragma once
// One frame of a sequence as a scene, and an exposure that holds for several frames.

#include <functional>
#include <string>

#include "core/render/render.h"
#include "core/scene/preset.h"
#include "core/sequence/frame_list.h"

namespace airlight::cli {

// The scene of the preset with the frame's keys put in; the contents of files are those of `like`, where it names the
// same. Throws InputError that names the frame.
Scene frame_scene(const Preset& preset, const sequence::Frame& frame, const Scene& like);

// The frame of that number. Throws InputError where there is none: "PLACE: there is no frame 99; ...".
sequence::Frame frame_numbered(const sequence::FrameSource& source, int number, const std::string& place);

// Whether the scene's exposure is that of one frame.
bool locks_frame(const Scene& scene);

// The exposure that the scene asks to be metered on a day or on a frame, as a factor. It depends only on the preset and
// that frame, not on earlier renders. `frame`: finds that frame. None where the scene states its exposure, or each
// picture is metered on its own.
std::optional<double> held_exposure(const DeviceOnDemand& device, const Stage& stage,
                                    const std::function<Scene()>& frame);

}  // namespace airlight::cli
