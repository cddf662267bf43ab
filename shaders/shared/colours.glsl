// Light of three channels in the picture's colours. The includer's push constants have red, green and blue, the colours
// of the channels.
vec3 in_colours(vec3 light) { return light.r * red + light.g * green + light.b * blue; }
