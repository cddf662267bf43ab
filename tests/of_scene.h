#pragma once
// Doors for a test that has a scene and wants one thing of it: each makes the scene ready anew.

#include <memory>
#include <string>
#include <vector>

#include "core/methods/analytic_sky.h"
#include "core/methods/known_failures.h"
#include "core/methods/march_steps.h"
#include "core/methods/ready.h"
#include "core/render/bands.h"
#include "core/render/lighting.h"
#include "core/render/metering.h"
#include "core/render/render.h"
#include "core/render/spans.h"
#include "core/render/spectrum.h"
#include "core/render/tile_sizes.h"

namespace airlight {

inline Part part_of(const Scene& scene) {
  return ready(scene).whole();
}
inline Air air_of(const Scene& scene) {
  return part_of(scene).air;
}
inline physics::Physics make_physics(const Scene& scene) {
  return formulas_of(air_of(scene), scene);
}
inline std::shared_ptr<const physics::HostTerrain> terrain_of(const Scene& scene) {
  return part_of(scene).things.terrain();
}
inline std::shared_ptr<const physics::HostTerrain> shadowed_terrain(const Scene& scene) {
  return part_of(scene).things.shadowed_terrain();
}
inline std::shared_ptr<const physics::HostGround> ground_of(const Scene& scene) {
  return part_of(scene).things.ground();
}

inline Rendering render(const DeviceOnDemand& device, const Scene& scene, const RenderRequest& request) {
  return render(device, ready(scene), request);
}
inline Rendering render_bands(const DeviceOnDemand& device, const Scene& scene, const BandsRequest& request) {
  return render_bands(device, ready(scene), request);
}
inline HostPicture traced(const Scene& scene, const View& view, const HostOptions& options = {}) {
  const Stage stage = ready(scene);
  return stage.method().render_on_host(stage, view, options);
}
inline Plan plan_for(const Scene& scene, const RenderRequest& request) {
  return plan_for(ready(scene), request);
}
inline ProbeResults probe(const DeviceOnDemand& device, const Scene& scene, const std::vector<Direction>& directions) {
  return probe(device, ready(scene), directions);
}
inline std::vector<float> probe_picture(const DeviceOnDemand& device, const Scene& scene,
                                        const std::vector<Direction>& directions) {
  return probe_picture(device, ready(scene), directions);
}
inline SpectralProbes probe_spectrum(const DeviceOnDemand& device, const Scene& scene,
                                     const std::vector<Direction>& directions, const Nodes& nodes) {
  return probe_spectrum(device, ready(scene), directions, nodes);
}
inline std::vector<TableDump> bake_tables(const DeviceOnDemand& device, const Scene& scene) {
  return bake_tables(device, ready(scene));
}
inline SunLight sun_light(const DeviceOnDemand& device, const Scene& scene) {
  return sun_light(device, ready(scene));
}
inline Lighting lighting_of(const DeviceOnDemand& device, const Scene& scene, const HostOptions& host) {
  return lighting_of(device, ready(scene), host);
}
inline double metered_exposure(const DeviceOnDemand& device, const Scene& scene) {
  return metered_exposure(device, ready(scene));
}
inline std::vector<AirTo> air_to(Executor& executor, const Scene& scene, std::span<const Span> spans,
                                 const SpanWay& way = {}, std::vector<PassTiming>* passes = nullptr) {
  return air_to(executor, ready(scene), spans, way, passes);
}
inline std::vector<AirTo> air_to_all(Executor& executor, const Scene& scene, std::span<const float> distances,
                                     const SpanWay& way = {}) {
  return air_to_all(executor, ready(scene), distances, way);
}

}  // namespace airlight
