#pragma once
// Scenes rendered in memory by any method of the registry, under the validation layer.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/render/render.h"
#include "core/render/spans.h"
#include "tests/physics/scenes.h"

namespace airlight::test {

// One device for all tests of a process.
Executor& executor();

Rendering render_now(const Scene& scene, const RenderRequest& request = {});
std::vector<ProbeResult> probe_now(const Scene& scene, const std::vector<Direction>& directions);

// The scene with a method and its defaults; `cheap`: with small tables, few steps and few samples.
Scene with_method(Scene scene, const SkyMethod& method, bool cheap = false);

// Whether the method takes that parameter.
bool takes(const SkyMethod& method, std::string_view parameter);
bool on_device(const SkyMethod& method);

// An all-round picture of the size given, from an altitude in km.
Scene all_round(Scene scene, double altitude, int width, int height);

// Rays to things: of one pixel, or at one distance all over the picture; km.
Span span_at(int x, int y, double distance);
std::vector<Span> spans_at(const Scene& scene, double distance);

// Expects every value of picture and tables to be finite and not negative, by the rendering's own count and by the
// test's.
void expect_sound(const Rendering& rendering, const std::string& what);

double channel_of(const RadianceImage& image, int x, int y, std::size_t c);
double greatest(const RadianceImage& image);

// Solid angle of a pixel, by its projection.
double solid_angle(const Scene& scene, int x, int y);
// Sum of radiance x solid angle over a picture.
double flux(const Scene& scene, const RadianceImage& image, std::size_t c);

}  // namespace airlight::test
