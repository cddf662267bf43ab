// Modules kept on disk: found again unchanged, and never taken from a file that could be anything else.

#include "core/gpu/kept_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "tests/gpu/gpu_fixture.h"
#include "tests/without_root.h"

namespace airlight {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::uint32_t>;

Digest key_of(const std::string& text) {
  return sha256(std::as_bytes(std::span(text)));
}

Words words_of(std::uint32_t first, std::size_t count = 1000) {
  Words words(count);
  for (std::size_t i = 0; i < count; ++i) words[i] = first + static_cast<std::uint32_t>(i * i);
  return words;
}

std::vector<char> read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(const fs::path& file, const std::vector<char>& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

class KeptFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "airlight-modules-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    root_ = name;
  }
  void TearDown() override {
    ::chmod(folder().c_str(), 0700);
    fs::remove_all(root_);
  }

  fs::path folder() const { return root_ / "airlight" / "modules"; }
  fs::path file_of(const Digest& key) const { return folder() / (hexadecimal(key) + ".module"); }
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder()), fs::directory_iterator()));
  }
  std::uint64_t bytes() const {
    std::uint64_t sum = 0;
    for (const auto& entry : fs::directory_iterator(folder())) sum += entry.file_size();
    return sum;
  }

  fs::path root_;
};

TEST(Sha256, GivesThePublishedDigests) {
  // FIPS 180-2, appendix B; the third is a million times "a".
  EXPECT_EQ(hexadecimal(key_of("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hexadecimal(key_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(hexadecimal(key_of(std::string(1000000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_EQ(hexadecimal(key_of("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(KeptFilesTest, FindsWhatItKept) {
  const KeptFiles cache(folder(), ".module");
  EXPECT_TRUE(cache.find(key_of("a")).empty());
  EXPECT_FALSE(fs::exists(folder())) << "looking makes no folder";
  cache.keep(key_of("a"), words_of(1));
  cache.keep(key_of("b"), words_of(2));
  EXPECT_EQ(KeptFiles(folder(), ".module").find(key_of("a")), words_of(1));
  EXPECT_EQ(cache.find(key_of("b")), words_of(2));
  EXPECT_TRUE(cache.find(key_of("c")).empty());
  EXPECT_EQ(file_count(), 2U) << "nothing half written stays";

  struct stat status = {};
  ASSERT_EQ(::stat(folder().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0700U);
  ASSERT_EQ(::stat(file_of(key_of("a")).c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0600U);
}

TEST_F(KeptFilesTest, TakesNoDamagedFileAndReplacesIt) {
  const KeptFiles cache(folder(), ".module");
  const Digest key = key_of("a");
  cache.keep(key, words_of(1));
  const std::vector<char> whole = read_file(file_of(key));
  ASSERT_EQ(whole.size(), 80U + 4000U);
  for (std::size_t at = 0; at < whole.size();
       at += at < 96 ? 1 : 397) {  // every part of the header, then here and there
    std::vector<char> damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    write_file(file_of(key), damaged);
    EXPECT_TRUE(cache.find(key).empty()) << "byte " << at;
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{80}, std::size_t{84}, whole.size() - 4, whole.size() - 1}) {
    write_file(file_of(key), {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});
    EXPECT_TRUE(cache.find(key).empty()) << "cut to " << size;
  }
  std::vector<char> longer = whole;
  longer.resize(whole.size() + 4);
  write_file(file_of(key), longer);
  EXPECT_TRUE(cache.find(key).empty());
  cache.keep(key, words_of(3));
  EXPECT_EQ(cache.find(key), words_of(3));
}

TEST_F(KeptFilesTest, TakesNoFileOfAnotherModule) {
  const KeptFiles cache(folder(), ".module");
  cache.keep(key_of("a"), words_of(1));
  fs::copy_file(file_of(key_of("a")), file_of(key_of("b")));
  EXPECT_TRUE(cache.find(key_of("b")).empty());
}

TEST_F(KeptFilesTest, TakesNothingThatOthersCouldWrite) {
  const KeptFiles cache(folder(), ".module");
  const Digest key = key_of("a");
  cache.keep(key, words_of(1));
  for (const mode_t mode : {0620U, 0602U, 0666U}) {
    ::chmod(file_of(key).c_str(), mode);
    EXPECT_TRUE(cache.find(key).empty()) << mode;
  }
  ::chmod(file_of(key).c_str(), 0644);  // to be read by others is fine
  EXPECT_FALSE(cache.find(key).empty());
  for (const mode_t mode : {0770U, 0707U, 0777U}) {
    ::chmod(folder().c_str(), mode);
    EXPECT_TRUE(cache.find(key).empty()) << mode;
    cache.keep(key_of("b"), words_of(2));
  }
  ::chmod(folder().c_str(), 0700);
  EXPECT_EQ(file_count(), 1U) << "nothing is written there either";
}

TEST_F(KeptFilesTest, FollowsNoLinkAndWaitsForNoPipe) {
  const KeptFiles cache(folder(), ".module");
  cache.keep(key_of("a"), words_of(1));
  fs::rename(file_of(key_of("a")), root_ / "elsewhere");
  fs::create_symlink(root_ / "elsewhere", file_of(key_of("a")));
  EXPECT_TRUE(cache.find(key_of("a")).empty());
  ASSERT_EQ(::mkfifo(file_of(key_of("b")).c_str(), 0600), 0);
  EXPECT_TRUE(cache.find(key_of("b")).empty());
  cache.keep(key_of("b"), words_of(2));
  EXPECT_EQ(cache.find(key_of("b")), words_of(2));
}

TEST_F(KeptFilesTest, DoesWithoutAFolder) {
  for (const fs::path& nowhere :
       {fs::path(), fs::path("/proc/airlight/modules"), root_ / "a" / "b" / "c" / "d" / "e"}) {
    const KeptFiles cache(nowhere, ".module");
    cache.keep(key_of("a"), words_of(1));
    cache.trim();
    EXPECT_TRUE(cache.find(key_of("a")).empty()) << nowhere;
  }
  write_file(root_ / "file", {'x'});
  const KeptFiles cache(root_ / "file" / "modules", ".module");
  cache.keep(key_of("a"), words_of(1));
  EXPECT_TRUE(cache.find(key_of("a")).empty());
  EXPECT_EQ(read_file(root_ / "file"), std::vector<char>{'x'});
}

TEST_F(KeptFilesTest, ReadsAFolderThatCannotBeWritten) {
  KeptFiles(folder(), ".module").keep(key_of("a"), words_of(1));
  ::chmod(folder().c_str(), 0500);
  const std::string found = test::without_root([&] {
    KeptFiles(folder(), ".module").keep(key_of("b"), words_of(2));
    return KeptFiles(folder(), ".module").find(key_of("a")) == words_of(1) ? "a" : "";
  });
  EXPECT_EQ(found, "a");
  EXPECT_EQ(file_count(), 1U);
}

TEST_F(KeptFilesTest, KeepsItsBoundByDroppingWhatWasUsedLongestAgo) {
  constexpr std::uint64_t kFile = 80 + 4000;
  const KeptFiles cache(folder(), ".module", 3 * kFile);
  for (int i = 0; i < 5; ++i) {
    cache.keep(key_of(std::to_string(i)), words_of(static_cast<std::uint32_t>(i)));
    const struct timespec then[2] = {{1000 + i, 0}, {1000 + i, 0}};
    ASSERT_EQ(::utimensat(AT_FDCWD, file_of(key_of(std::to_string(i))).c_str(), then, 0), 0);
  }
  EXPECT_FALSE(cache.find(key_of("0")).empty());  // used just now
  write_file(folder() / "notes.txt", {'x'});      // none of its own
  cache.trim();
  EXPECT_LE(bytes() - 1, 3 * kFile);
  EXPECT_FALSE(cache.find(key_of("0")).empty());
  EXPECT_TRUE(cache.find(key_of("1")).empty());
  EXPECT_TRUE(cache.find(key_of("2")).empty());
  EXPECT_FALSE(cache.find(key_of("3")).empty());
  EXPECT_FALSE(cache.find(key_of("4")).empty());
  EXPECT_TRUE(fs::exists(folder() / "notes.txt"));
}

TEST_F(KeptFilesTest, SweepsUpAfterKilledWriters) {
  const KeptFiles cache(folder(), ".module");
  cache.keep(key_of("a"), words_of(1));
  const fs::path old = folder() / (hexadecimal(key_of("b")) + ".part-1-0");
  const fs::path fresh = folder() / (hexadecimal(key_of("b")) + ".part-2-0");
  for (const fs::path& part : {old, fresh}) write_file(part, {'x'});
  const struct timespec then[2] = {{1000, 0}, {1000, 0}};
  ASSERT_EQ(::utimensat(AT_FDCWD, old.c_str(), then, 0), 0);
  cache.trim();
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(fresh)) << "its writer may be at work";
  EXPECT_FALSE(cache.find(key_of("a")).empty());
}

TEST_F(KeptFilesTest, IsSafeWithManyProcessesAtOnce) {
  constexpr int kProcesses = 4;
  constexpr std::uint64_t kFile = 80 + 4000;
  std::vector<pid_t> children;
  for (int child = 0; child < kProcesses; ++child) {
    const pid_t pid = ::fork();
    ASSERT_GE(pid, 0);
    if (pid == 0) {
      const KeptFiles cache(folder(), ".module", 2 * kFile);
      bool sound = true;
      for (std::uint32_t round = 0; round < 300; ++round) {
        const std::uint32_t which = round % 3;
        const Digest key = key_of(std::to_string(which));
        if (const Words found = cache.find(key); !found.empty()) sound = sound && found == words_of(which);
        cache.keep(key, words_of(which));
        if (round % 10 == 0) cache.trim();
      }
      ::_exit(sound ? 0 : 1);
    }
    children.push_back(pid);
  }
  for (const pid_t pid : children) {
    int status = 0;
    ASSERT_EQ(::waitpid(pid, &status, 0), pid);
    EXPECT_EQ(status, 0) << "a process read what nobody wrote";
  }
  KeptFiles(folder(), ".module", 2 * kFile).trim();
  EXPECT_EQ(file_count(), 2U);
}

TEST(UserCacheFolder, FollowsTheEnvironment) {
  const ScopedEnvironment own("AIRLIGHT_CACHE", nullptr);
  const ScopedEnvironment home("HOME", "/home/somebody");
  {
    const ScopedEnvironment cache("XDG_CACHE_HOME", "/var/somebody");
    EXPECT_EQ(user_cache_folder(), "/var/somebody/airlight");
    const ScopedEnvironment chosen("AIRLIGHT_CACHE", "/elsewhere");
    EXPECT_EQ(user_cache_folder(), "/elsewhere");
    const ScopedEnvironment off("AIRLIGHT_CACHE", "off");
    EXPECT_EQ(user_cache_folder(), "");
  }
  const ScopedEnvironment relative("XDG_CACHE_HOME", "not/absolute");
  EXPECT_EQ(user_cache_folder(), "/home/somebody/.cache/airlight");
  const ScopedEnvironment homeless("HOME", nullptr);
  EXPECT_EQ(user_cache_folder(), "");
}

}  // namespace
}  // namespace airlight
