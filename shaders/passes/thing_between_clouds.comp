#version 460
#extension GL_GOOGLE_include_directive : require
// thing_between.comp with surfaces under a cloud.
#define AIRLIGHT_CLOUDS
#include "shared/thing_between.glsl"
