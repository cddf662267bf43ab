// The pixels of a pass over things. Those of several rays may be a pass of their own: it first lists them block by block.
// In one pass every lane would wait for the rays of an edge.
// The includer defines:
//   uint width, height;
//   ViewRay ray_of_pixel(uvec2 pixel);
//   void render(ViewRay view, ThingPixel rays);  the pixel `here`

layout(constant_id = 38) const uint kThingPixels = kThingPixelsAll;

layout(local_size_x = 8, local_size_y = 8) in;

// A block of pixels is one of threads, so that no thread has more than one of them to render: a software device ends the
// loops of a shader after 65536 turns.
const uint kBlock = 8u;
shared uint listed;
shared uint list[kBlock * kBlock];

bool in_picture(uvec2 pixel) { return pixel.x < width && pixel.y < height; }

void list_edges() {
  if (gl_LocalInvocationIndex == 0u) {
    listed = 0u;
  }
  barrier();
  uvec2 pixel = gl_GlobalInvocationID.xy;
  if (in_picture(pixel) && thing_pixel(pixel, ray_of_pixel(pixel)).count > 1u) {
    list[atomicAdd(listed, 1u)] = gl_LocalInvocationIndex;
  }
  barrier();
}

void main() {
  if (kThingPixels == kThingPixelsEdges) {
    list_edges();
    if (gl_LocalInvocationIndex < listed) {
      uint k = list[gl_LocalInvocationIndex];
      here = gl_WorkGroupID.xy * kBlock + uvec2(k % kBlock, k / kBlock);
      ViewRay view = ray_of_pixel(here);
      render(view, thing_pixel(here, view));
    }
    return;
  }
  here = gl_GlobalInvocationID.xy;
  if (!in_picture(here)) {
    return;
  }
  ViewRay view = ray_of_pixel(here);
  ThingPixel rays = thing_pixel(here, view);
  if (kThingPixels == kThingPixelsAll || rays.count == 1u) {
    render(view, rays);
  }
}
