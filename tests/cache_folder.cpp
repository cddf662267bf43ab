// Linked into every test program: what they keep goes below the build folder, for all of them together and for the
// programs that they start, and not into the home of who runs them. AIRLIGHT_CACHE, if set, wins.

#include <cstdlib>

namespace {

const int set = ::setenv("AIRLIGHT_CACHE", AIRLIGHT_CACHE_FOLDER, 0);

}  // namespace
