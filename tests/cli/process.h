#pragma once
// The tool as a process, in a folder of its own.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace airlight::test {

using Names = std::vector<std::string>;

struct Outcome {
  int exit_code = -1;  // -1: ended by `signal`
  int signal = 0;
  std::string out;
  std::string err;
};

struct Start {
  std::string input;                               // on standard input
  std::map<std::string, std::string> environment;  // added to the test's own
  int kill_signal = 0;                             // sent kill_after_ms after the start; 0: none
  int kill_after_ms = 0;
  std::string kill_at_file;   // or after a file with this in its name is in the folder; / is the name's end
  bool close_output = false;  // standard output has no reader
  bool without_root = false;  // what root may do beyond others is given up
};

// Runs a program with its arguments and waits. The working folder is `folder`. PATH begins with the folder of the tool
// under test, so `airlight` is that tool to a shell wherever the build lies.
Outcome run(const std::filesystem::path& folder, const Names& words, const Start& start = {});

// A line of bash.
Outcome shell(const std::filesystem::path& folder, const std::string& line, const Start& start = {});

// The tool under test: that of this build, or the one that $AIRLIGHT_TOOL_UNDER_TEST names. A path, not a string, so
// that it cannot be put into a shell's line, where a space would end it.
const std::filesystem::path& tool_program();

// Runs the tool with these arguments.
Outcome airlight(const std::filesystem::path& folder, Names arguments, const Start& start = {});

// Words that go before a command which mounts, so that nobody else sees what it mounts: "unshare -m" as root, or what
// gives a user such a view where the kernel allows it. Empty where this process may not mount.
std::vector<std::string> mount_privately();

// Runs the tool on a disk of this size ("100k") that holds the files of `folder` and is full early. Afterwards `folder`
// also has the files that the tool left there. Needs mount_privately().
Outcome airlight_on_a_small_disk(const std::filesystem::path& folder, const std::string& size,
                                 const std::vector<std::string>& arguments);

// A fresh folder, removed with everything in it.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  Names files() const;  // of the whole tree, relative, sorted; folders left out

 private:
  std::filesystem::path path_;
};

Names lines_of(const std::string& text);

bool contains(const std::string& text, const std::string& part);

// A valid preset that renders very fast.
std::string small_preset();

}  // namespace airlight::test
