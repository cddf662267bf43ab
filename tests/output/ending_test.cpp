#include "core/output/ending.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "tests/output/files.h"

namespace airlight {
namespace {

using test::Folder;
using testing::KilledBySignal;

// A program that writes a file a while after its start, and then goes on.
pid_t start_writer(const std::string& file) {
  const pid_t process = ::fork();
  if (process == 0) {
    ::execlp("sh", "sh", "-c", "sleep 0.05; : > \"$0\"; exec sleep 60", file.c_str(), nullptr);
    ::_exit(127);
  }
  return process;
}

// The process number of a program that was just started is not yet known to the handler, which another thread runs.
TEST(FilesOfAnotherDeathTest, ASignalWhileTheProgramIsStartedLeavesNoFile) {
  const Folder folder;
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    const std::string file = (folder / "drawn").string();
    EXPECT_EXIT(
        {
          ::signal(SIGHUP, SIG_DFL);  // nohup ignores it
          ::signal(SIGINT, SIG_DFL);
          end_in_good_order_on_signals();
          std::thread([] { ::pause(); }).detach();  // takes the signal
          FilesOfAnother drawn({file});
          drawn.started_by([&] {
            const pid_t writer = start_writer(file);
            ::kill(::getpid(), signal_number);
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            return writer;
          });
          ::pause();
        },
        KilledBySignal(signal_number), "no file was written");
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // a writer that lives would write now
    EXPECT_EQ(folder.names(), std::set<std::string>{});
  }
}

TEST(FilesOfAnotherDeathTest, ASignalAfterTheStartEndsTheProgramAndLeavesNoFile) {
  const Folder folder;
  const std::string file = (folder / "drawn").string();
  EXPECT_EXIT(
      {
        ::signal(SIGINT, SIG_DFL);
        end_in_good_order_on_signals();
        FilesOfAnother drawn({file});
        drawn.started_by([&] { return start_writer(file); });
        while (::access(file.c_str(), F_OK) != 0) {
          std::this_thread::yield();
        }
        ::raise(SIGINT);
      },
      KilledBySignal(SIGINT), "stopped by SIGINT");
  EXPECT_EQ(folder.names(), std::set<std::string>{});
}

// A handler that still waited for the program would never end.
TEST(FilesOfAnotherDeathTest, ASignalAfterAStartThatFailedEndsTheProcess) {
  const Folder folder;
  EXPECT_EXIT(
      {
        ::signal(SIGINT, SIG_DFL);
        end_in_good_order_on_signals();
        FilesOfAnother drawn({folder / "a"});
        EXPECT_THROW(drawn.started_by([]() -> pid_t { throw 1; }), int);
        ::alarm(5);
        ::raise(SIGINT);
      },
      KilledBySignal(SIGINT), "stopped by SIGINT");
}

TEST(FilesOfAnother, FilesThatExistAreRenamed) {
  const Folder folder;
  FilesOfAnother drawn({folder / "a", folder / "b"});
  EXPECT_EQ(drawn.started_by([] { return pid_t{0}; }), 0);
  test::put(folder / "a", "x");
  test::put(folder / "b", "x");
  EXPECT_TRUE(drawn.rename(0, folder / "c"));
  EXPECT_FALSE(drawn.rename(0, folder / "c"));
}

}  // namespace
}  // namespace airlight
