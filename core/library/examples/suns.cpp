// Prints the zenith's radiance, and the processor's time for each sky.
#include <airlight/airlight.h>

#include <cmath>
#include <cstdio>
#include <ctime>

int main() {
  try {
    airlight::Session session;
    airlight::Scene scene = session.load("earth-noon");
    scene.option("projection", "latlong").option("size", "64x32");
    session.render(scene);  // opens the device and bakes the tables
    const std::clock_t start = std::clock();
    for (int elevation = 1; elevation <= 64; ++elevation) {
      scene.set("/sun/elevation_deg", std::to_string(elevation));
      const airlight::Image sky = session.render(scene);
      const float* zenith = sky.at(0, 0);
      std::printf("%2d degrees: zenith %.4f %.4f %.4f\n", elevation, zenith[0], zenith[1], zenith[2]);
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::fprintf(stderr, "%.1f ms of the processor a sky\n", 1e3 * seconds / 64);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
