// test_cli of a build that uses another build's test_cli: the same tests, started with this build's tool.

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

int main(int /*argc*/, char** argv) {
  ::setenv("AIRLIGHT_TOOL_UNDER_TEST", AIRLIGHT_BINARY, 1);
  ::execv(AIRLIGHT_DRIVER, argv);
  std::perror(AIRLIGHT_DRIVER);
  return 1;
}
