#include "core/output/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <span>

#include "core/output/ending.h"
#include "tests/output/files.h"
#include "tests/without_root.h"

namespace airlight {
namespace {

using test::contents_of;
using test::Folder;
using test::message_of;
using testing::ExitedWithCode;
using testing::KilledBySignal;

std::string writing_refusal(const std::filesystem::path& file) {
  return message_of<InputError>([&] { require_writable(file); });
}

TEST(WriteFile, NewFileHasTheContentsAndNothingIsLeftBeside) {
  const Folder folder;
  write_file(folder / "a.bin", test::text_bytes("hello"));
  EXPECT_EQ(contents_of(folder / "a.bin"), "hello");
  EXPECT_EQ(folder.names(), std::set<std::string>{"a.bin"});
}

TEST(WriteFile, ReplacesAnOlderFileAndKeepsItsPermissions) {
  const Folder folder;
  test::put(folder / "a.bin", "older and longer");
  ASSERT_EQ(::chmod((folder / "a.bin").c_str(), 0640), 0);
  write_file(folder / "a.bin", test::text_bytes("new"));
  EXPECT_EQ(contents_of(folder / "a.bin"), "new");
  struct stat status = {};
  ASSERT_EQ(::stat((folder / "a.bin").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST(WriteFile, FollowsASymbolicLink) {
  const Folder folder;
  test::put(folder / "real.bin", "old");
  std::filesystem::create_symlink("real.bin", folder / "link.bin");
  write_file(folder / "link.bin", test::text_bytes("new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.bin"));
  EXPECT_EQ(contents_of(folder / "real.bin"), "new");
}

TEST(WriteFile, LongestNameOfTheFileSystem) {
  const Folder folder;
  const std::string name(255, 'n');
  write_file(folder / name, test::text_bytes("x"));
  EXPECT_EQ(folder.names(), std::set<std::string>{name});
}

TEST(WriteFile, AFullDeviceIsAnErrorWithItsReason) {
  const std::string message = message_of<RunError>([] { write_file("/dev/full", test::text_bytes("x")); });
  EXPECT_NE(message.find("/dev/full: cannot write: No space left on device; free some space"), std::string::npos)
      << message;
}

TEST(WriteFile, NullDeviceIsWrittenInPlace) {
  write_file("/dev/null", test::text_bytes("x"));
  struct stat status = {};
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(WriteFile, MissingFolderIsAnError) {
  const Folder folder;
  const std::string message =
      message_of<RunError>([&] { write_file(folder / "none" / "a.bin", test::text_bytes("x")); });
  EXPECT_NE(message.find("cannot create: No such file or directory"), std::string::npos) << message;
}

// A write that fails half way, as on a full disk: the process may not write files above 4096 bytes.
void limit_file_size(void (*on_signal)(int)) {
  ::signal(SIGXFSZ, on_signal);
  const rlimit limit{4096, 4096};
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

TEST(WriteFileDeathTest, AFailedWriteLeavesTheOlderFileAndNoTemporary) {
  const Folder folder;
  test::put(folder / "a.bin", "old");
  EXPECT_EXIT(
      {
        limit_file_size(SIG_IGN);
        const std::string big(100000, 'x');
        const std::string message = message_of<RunError>([&] { write_file(folder / "a.bin", test::text_bytes(big)); });
        std::exit(message.find("a.bin: cannot write: File too large") != std::string::npos ? 0 : 1);
      },
      ExitedWithCode(0), "");
  EXPECT_EQ(contents_of(folder / "a.bin"), "old");
  EXPECT_EQ(folder.names(), std::set<std::string>{"a.bin"});
}

TEST(WriteFileDeathTest, ASignalInTheMiddleLeavesNoTemporary) {
  const Folder folder;
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    static int raised = 0;
    raised = signal_number;
    EXPECT_EXIT(
        {
          ::signal(SIGHUP, SIG_DFL);  // nohup ignores it
          ::signal(SIGINT, SIG_DFL);
          end_in_good_order_on_signals();
          limit_file_size([](int) { ::raise(raised); });
          write_file(folder / "a.bin", test::text_bytes(std::string(100000, 'x')));
        },
        KilledBySignal(signal_number), "");
    EXPECT_EQ(folder.names(), std::set<std::string>{});
  }
}

// In a sticky folder a user may create files, but not replace another user's.
TEST(WriteFileDeathTest, AFailedReplacementIsAnErrorAndLeavesNoTemporary) {
  if (::getuid() != 0) {
    GTEST_SKIP() << "needs two users, and only root may become another one";
  }
  const Folder folder;
  test::put(folder / "a.bin", "old");
  ASSERT_EQ(::chmod((folder / "a.bin").c_str(), 0666), 0);
  ASSERT_EQ(::chmod(folder.path().c_str(), 01777), 0);
  EXPECT_EXIT(
      {
        if (::setuid(65534) != 0) std::exit(3);
        const std::string message =
            message_of<RunError>([&] { write_file(folder / "a.bin", test::text_bytes("new")); });
        std::exit(message.find("a.bin: cannot replace: Operation not permitted") != std::string::npos ? 0 : 1);
      },
      ExitedWithCode(0), "");
  EXPECT_EQ(contents_of(folder / "a.bin"), "old");
  EXPECT_EQ(folder.names(), std::set<std::string>{"a.bin"});
}

TEST(RequireWritable, AcceptsANewFileAnOlderOneAndADevice) {
  const Folder folder;
  require_writable(folder / "new.exr");
  test::put(folder / "old.exr", "x");
  require_writable(folder / "old.exr");
  require_writable("/dev/null");
  require_writable("in-this-folder.exr");
  EXPECT_EQ(folder.names(), std::set<std::string>{"old.exr"});
}

TEST(RequireWritable, NamesTheProblemAndTheRemedy) {
  const Folder folder;
  test::put(folder / "file", "x");
  const std::string root = folder.path().string();
  EXPECT_EQ(writing_refusal(""), "output file: the name is empty; give one such as sky.exr");
  EXPECT_EQ(writing_refusal(root), root + ": is a directory; name a file in it, such as " + root + "/sky.exr");
  EXPECT_EQ(
      writing_refusal(root + "/none/a.exr"),
      root + "/none/a.exr: the directory " + root + "/none does not exist; create it with: mkdir -p " + root + "/none");
  EXPECT_NE(writing_refusal(root + "/none/").find("names a directory, not a file"), std::string::npos);
  EXPECT_NE(writing_refusal(root + "/file/a.exr").find(root + "/file is a file, not a directory"), std::string::npos);
}

TEST(RequireWritable, RefusesAFolderOrFileWithoutRights) {
  const Folder folder;
  const std::filesystem::path closed = folder / "closed";
  std::filesystem::create_directory(closed);
  test::put(folder / "old.exr", "x");
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
  ASSERT_EQ(::chmod(closed.c_str(), 0555), 0);
  ASSERT_EQ(::chmod((folder / "old.exr").c_str(), 0444), 0);
  const std::string in_closed = test::without_root([&] { return writing_refusal(closed / "a.exr"); });
  EXPECT_NE(in_closed.find("cannot be written (Permission denied); choose a folder of your own"), std::string::npos)
      << in_closed;
  const std::string old = test::without_root([&] { return writing_refusal(folder / "old.exr"); });
  EXPECT_NE(old.find("old.exr: cannot be written (Permission denied)"), std::string::npos) << old;
}

}  // namespace
}  // namespace airlight
