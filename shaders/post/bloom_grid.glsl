// The bloom's own grid, whose texels span a fixed angle: the glow is as wide at 270 lines as at 2160. Each texel is the
// mean of what it covers of the picture. A picture coarser than the grid is copied.

vec2 grid_scale(uvec2 picture_size, uvec2 grid_size) { return vec2(picture_size) / vec2(grid_size); }

vec4 grid_mean(vec3 sum, vec2 scale) { return vec4(sum / (scale.x * scale.y), 1.0); }
