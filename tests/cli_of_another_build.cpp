// test_cli of a build that takes that of another: the same tests, told to start this build's tool.

#include <unistd.h>

#include <cstdio>
#include <cstdlib>

int main(int /*argc*/, char** argv) {
  ::setenv("AIRLIGHT_TOOL_UNDER_TEST", AIRLIGHT_BINARY, 1);
  ::execv(AIRLIGHT_DRIVER, argv);
  std::perror(AIRLIGHT_DRIVER);
  return 1;
}
