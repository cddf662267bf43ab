#include "core/output/replace_files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>

#include "tests/output/files.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;
using test::contents_of;
using test::Folder;
using test::message_of;
using Names = std::set<std::string>;

TEST(ReplaceFiles, ReplacesAllAndKeepsPermissionsLinksAndSources) {
  const Folder folder;
  fs::create_directory(folder / "sub");
  test::put(folder / "new1", "first");
  test::put(folder / "new2", "second");
  test::put(folder / "old1", "an older one, longer");
  test::put(folder / "sub/old2", "old");
  fs::create_symlink("sub/old2", folder / "link");
  ASSERT_EQ(::chmod((folder / "old1").c_str(), 0640), 0);
  replace_files({{folder / "new1", folder / "old1"}, {folder / "new2", folder / "link"}});
  EXPECT_EQ(contents_of(folder / "old1"), "first");
  EXPECT_EQ(contents_of(folder / "sub/old2"), "second");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(fs::status(folder / "old1").permissions(), fs::perms(0640));
  EXPECT_EQ(contents_of(folder / "new1"), "first");
  EXPECT_EQ(folder.names(), (Names{"link", "new1", "new2", "old1", "sub"}));
}

TEST(ReplaceFiles, NothingWhereASourceIsMissing) {
  const Folder folder;
  test::put(folder / "new", "new");
  test::put(folder / "old1", "old1");
  test::put(folder / "old2", "old2");
  const std::vector<Replacement> both = {{folder / "new", folder / "old1"}, {folder / "gone", folder / "old2"}};
  const std::string message = message_of<RunError>([&] { replace_files(both); });
  EXPECT_NE(message.find("gone: cannot open: No such file"), std::string::npos) << message;
  EXPECT_NE(message.find("nothing was replaced"), std::string::npos) << message;
  EXPECT_EQ(contents_of(folder / "old1"), "old1");
  EXPECT_EQ(folder.names(), (Names{"new", "old1", "old2"}));
}

// Ends the process with 7 if a limit on the file's size, standing for a full disk, stops the second copy.
[[noreturn]] void replace_under_a_limit(const Folder& folder) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1000, 1000};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  const std::vector<Replacement> both = {{folder / "small", folder / "old1"}, {folder / "large", folder / "old2"}};
  const std::string message = message_of<RunError>([&] { replace_files(both); });
  std::_Exit(message.find("cannot write") != std::string::npos ? 7 : 1);  // no search for leaks among other threads
}

TEST(ReplaceFiles, NothingWhereTheDiskIsFull) {
  const Folder folder;
  test::put(folder / "small", "new");
  test::put(folder / "large", std::string(5000, 'x'));
  test::put(folder / "old1", "old1");
  test::put(folder / "old2", "old2");
  EXPECT_EXIT(replace_under_a_limit(folder), testing::ExitedWithCode(7), "");
  EXPECT_EQ(contents_of(folder / "old1"), "old1");
  EXPECT_EQ(contents_of(folder / "old2"), "old2");
  EXPECT_EQ(folder.names(), (Names{"large", "old1", "old2", "small"}));
}

// The source is a pipe, which shows when it is being read and then keeps the copy waiting for the signal.
TEST(ReplaceFiles, ASignalDuringTheCopiesEndsWithNothingReplaced) {
  const Folder folder;
  test::put(folder / "new", "new");
  test::put(folder / "old1", "old1");
  test::put(folder / "old2", "old2");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    replace_files({{folder / "pipe", folder / "old1"}, {folder / "new", folder / "old2"}});
    ::_exit(0);
  }
  {
    std::ofstream pipe(folder / "pipe");  // opens when the child has opened it to read
    ASSERT_EQ(::kill(child, SIGTERM), 0);
    pipe << "through the pipe";
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGTERM);
  EXPECT_EQ(contents_of(folder / "old1"), "old1");
  EXPECT_EQ(contents_of(folder / "old2"), "old2");
  EXPECT_EQ(folder.names(), (Names{"new", "old1", "old2", "pipe"}));
}

}  // namespace
}  // namespace airlight
