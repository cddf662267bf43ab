// Linked into every test program. Kept files of the tests, and of the programs that they start, go below the build
// folder, one for all, and not into the user's home. AIRLIGHT_CACHE, if set, has precedence.

#include <cstdlib>

namespace {

const int set = ::setenv("AIRLIGHT_CACHE", AIRLIGHT_CACHE_FOLDER, 0);

}  // namespace
