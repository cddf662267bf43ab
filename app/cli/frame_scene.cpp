#include "app/cli/frame_scene.h"

#include <utility>

#include "app/cli/scene_files.h"
#include "core/base/error.h"
#include "core/library/place.h"
#include "core/methods/ready.h"
#include "core/render/metering.h"

namespace airlight::cli {
namespace {

PresetValue value_of(const std::vector<double>& values) {
  PresetValue value;
  if (values.size() == 1) {
    value.data = values.front();
    return value;
  }
  PresetArray array(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    array[i].data = values[i];
  }
  value.data = std::move(array);
  return value;
}

}  // namespace

Scene frame_scene(const Preset& preset, const sequence::Frame& frame, const Scene& like) {
  const std::string place = "frame " + std::to_string(frame.number);
  Preset with = preset;
  for (const auto& [pointer, values] : frame.keys) {
    PresetValue value = value_of(values);
    value.source = place;
    put_value(with, pointer, std::move(value), place);
  }
  leave_out_unseen(with);
  Scene scene = judged(with, &like);
  leave_out_outshone(scene);
  return scene;
}

sequence::Frame frame_numbered(const sequence::FrameSource& source, int number, const std::string& place) {
  const std::size_t frames = sequence::frame_count(source);
  const long first = sequence::frame_number(source, 0);
  const long last = sequence::frame_number(source, frames - 1);
  if (number < first || number > last) {
    throw InputError(place + ": there is no frame " + std::to_string(number) + "; they are numbered " +
                     std::to_string(first) + " to " + std::to_string(last));
  }
  return sequence::frame_at(source, static_cast<std::size_t>(number - first));
}

bool locks_frame(const Scene& scene) {
  return scene.display.metering == Metering::frame && !scene.display.exposure;
}

std::optional<double> held_exposure(const DeviceOnDemand& device, const Stage& stage,
                                    const std::function<Scene()>& frame) {
  const Scene& scene = stage.scene();
  if (scene.display.exposure || scene.display.metering == Metering::picture) {
    return std::nullopt;
  }
  return metered_exposure(device, ready(locks_frame(scene) ? frame() : by_day(scene), stage));
}

}  // namespace airlight::cli
