// One sky in memory: radiance in a few directions of a map of the whole sphere.
#include <airlight/airlight.h>

#include <cstdio>

int main() {
  try {
    airlight::Session session;
    airlight::Scene scene = session.load("earth-noon");
    scene.option("projection", "latlong").option("size", "64x32").option("sun-elevation", "4");
    const airlight::Image sky = session.render(scene);
    for (int y : {2, 8, 15}) {
      std::printf("row %2d: %.4f %.4f %.4f\n", y, sky.at(32, y)[0], sky.at(32, y)[1], sky.at(32, y)[2]);
    }
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
