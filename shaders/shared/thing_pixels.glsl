// The pixels of a pass over things. Those of several rays may be a pass of their own: it first lists them block by block.
// In one pass every lane would wait for the rays of an edge.
// The includer defines:
//   uint width, height;
//   ViewRay ray_of_pixel(uvec2 pixel);
//   void render(ViewRay view, ThingPixel rays);  the pixel `here`

layout(constant_id = 38) const uint kThingPixels = kThingPixelsAll;

layout(local_size_x = 8, local_size_y = 8) in;

const uint kThreads = 64u;
const uint kBlock = 32u;  // pixels across a block, of one workgroup
shared uint listed;
shared uint list[kBlock * kBlock];

bool in_picture(uvec2 pixel) { return pixel.x < width && pixel.y < height; }

uvec2 block_pixel(uint k) { return gl_WorkGroupID.xy * kBlock + uvec2(k % kBlock, k / kBlock); }

void list_edges() {
  if (gl_LocalInvocationIndex == 0u) {
    listed = 0u;
  }
  barrier();
  for (uint k = gl_LocalInvocationIndex; k < kBlock * kBlock; k += kThreads) {
    uvec2 pixel = block_pixel(k);
    if (in_picture(pixel) && thing_pixel(pixel, ray_of_pixel(pixel)).count > 1u) {
      list[atomicAdd(listed, 1u)] = k;
    }
  }
  barrier();
}

void main() {
  if (kThingPixels == kThingPixelsEdges) {
    list_edges();
    for (uint i = gl_LocalInvocationIndex; i < listed; i += kThreads) {
      here = block_pixel(list[i]);
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
