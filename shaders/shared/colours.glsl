// Light of three channels in the picture's colours. The includer's push constants have those of the channels: red, green
// and blue.
vec3 in_colours(vec3 light) { return light.r * red + light.g * green + light.b * blue; }
