// The pixels of a pass over things. Those of several rays are listed block by block and rendered by themselves: beside
// the others every lane would wait for the rays of an edge.
// The includer defines:
//   uint width, height;
//   ViewRay ray_of_pixel(uvec2 pixel);
//   void render(ViewRay view, ThingPixel rays);  the pixel `here`

layout(local_size_x = 8, local_size_y = 8) in;

// A block of pixels is one of threads, so that no thread has more than one of the list to render: a software device ends
// the loops of a shader after 65536 turns.
const uint kBlock = 8u;
shared uint listed;
shared uint list[kBlock * kBlock];

bool in_picture(uvec2 pixel) { return pixel.x < width && pixel.y < height; }

// Two turns of one loop, so that the code of a pixel stands once: pipelines are made in half the time.
void main() {
  uint lane = gl_LocalInvocationIndex;
  here = gl_GlobalInvocationID.xy;
  if (lane == 0u) {
    listed = 0u;
  }
  barrier();
  bool mine = in_picture(here);
  for (uint turn = 0u; turn < 2u; turn++) {
    if (mine) {
      ViewRay view = ray_of_pixel(here);
      ThingPixel rays = thing_pixel(here, view);
      if (turn == 0u && rays.count > 1u) {
        list[atomicAdd(listed, 1u)] = lane;
      } else {
        render(view, rays);
      }
    }
    barrier();
    if (listed == 0u) {
      break;
    }
    mine = lane < listed;
    uint k = list[min(lane, listed - 1u)];
    here = gl_WorkGroupID.xy * kBlock + uvec2(k % kBlock, k / kBlock);
  }
}
