#include "tests/cli/process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/without_root.h"

namespace airlight::test {
namespace {

namespace fs = std::filesystem;

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw std::runtime_error("pipe2 failed");
    }
  }
  ~Pipe() {
    close_read();
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_read() { close_end(0); }
  void close_write() { close_end(1); }
  int read_end() const { return ends[0]; }
  int write_end() const { return ends[1]; }

 private:
  void close_end(std::size_t i) {
    if (ends[i] >= 0) {
      ::close(ends[i]);
      ends[i] = -1;
    }
  }
};

void put_tool_on_path() {
  const fs::path folder = tool_program().parent_path();
  const char* path = std::getenv("PATH");
  if (!folder.empty() && path != nullptr) ::setenv("PATH", (folder.string() + ":" + path).c_str(), 1);
}

[[noreturn]] void become(const fs::path& folder, const std::vector<std::string>& words, const Start& start, int in,
                         int out, int err) {
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  put_tool_on_path();
  for (const auto& [name, value] : start.environment) {
    ::setenv(name.c_str(), value.c_str(), 1);
  }
  std::vector<char*> argv;
  for (const std::string& word : words) {
    argv.push_back(const_cast<char*>(word.c_str()));
  }
  argv.push_back(nullptr);
  if (start.without_root) give_up_roots_rights();
  if (::chdir(folder.c_str()) == 0) {
    ::execvp(argv[0], argv.data());
  }
  ::_exit(127);
}

void read_both(Pipe& out, Pipe& err, Outcome& outcome) {
  std::array<pollfd, 2> polled{{{out.read_end(), POLLIN, 0}, {err.read_end(), POLLIN, 0}}};
  std::array<char, 65536> buffer;
  while (polled[0].fd >= 0 || polled[1].fd >= 0) {
    ::poll(polled.data(), polled.size(), -1);
    for (std::size_t i = 0; i < polled.size(); ++i) {
      if (polled[i].fd < 0 || polled[i].revents == 0) {
        continue;
      }
      const ssize_t count = ::read(polled[i].fd, buffer.data(), buffer.size());
      if (count <= 0) {
        polled[i].fd = -1;
      } else {
        (i == 0 ? outcome.out : outcome.err).append(buffer.data(), static_cast<std::size_t>(count));
      }
    }
  }
}

bool holds(const fs::path& folder, const std::string& part) {
  return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(), [&](const fs::directory_entry& entry) {
    return (entry.path().filename().string() + "/").find(part) != std::string::npos;
  });
}

// Returns when there is a file with `part` in its name, or the process has closed its output. Some files are there for
// two milliseconds: the kernel wakes this thread as soon as there is a new one.
void wait_for_file(const fs::path& folder, const std::string& part, const std::atomic<bool>& ended) {
  pollfd news{::inotify_init1(IN_CLOEXEC | IN_NONBLOCK), POLLIN, 0};
  ::inotify_add_watch(news.fd, folder.c_str(), IN_CREATE | IN_MOVED_TO);
  std::array<char, 4096> events;
  while (!ended && !holds(folder, part)) {
    ::poll(&news, 1, 10);
    (void)!::read(news.fd, events.data(), events.size());
  }
  ::close(news.fd);
}

}  // namespace

Outcome run(const fs::path& folder, const std::vector<std::string>& words, const Start& start) {
  std::signal(SIGPIPE, SIG_IGN);  // a child that does not read its input is no reason to end the test
  Pipe in;
  Pipe out;
  Pipe err;
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int signal_number : {SIGPIPE, SIGINT, SIGHUP, SIGQUIT}) {
      std::signal(signal_number, SIG_DFL);  // ignored where the tests run by nohup or in a script's background
    }
    become(folder, words, start, in.read_end(), out.write_end(), err.write_end());
  }
  in.close_read();
  out.close_write();
  err.close_write();
  if (start.close_output) {
    out.close_read();
  }
  std::thread writer([&] {
    (void)!::write(in.write_end(), start.input.data(), start.input.size());
    in.close_write();
  });
  std::atomic<bool> ended = false;
  std::thread killer;
  if (start.kill_signal != 0) {
    killer = std::thread([&] {
      if (!start.kill_at_file.empty()) {
        wait_for_file(folder, start.kill_at_file, ended);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(start.kill_after_ms));
      ::kill(child, start.kill_signal);  // not reaped yet: the id is still the child's
    });
  }
  Outcome outcome;
  read_both(out, err, outcome);
  ended = true;
  writer.join();
  if (killer.joinable()) {
    killer.join();
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  return outcome;
}

Outcome shell(const fs::path& folder, const std::string& line, const Start& start) {
  return run(folder, {"bash", "-c", line}, start);
}

const fs::path& tool_program() {
  static const fs::path program = [] {
    const char* named = std::getenv("AIRLIGHT_TOOL_UNDER_TEST");
    return fs::path(named == nullptr ? AIRLIGHT_BINARY : named);
  }();
  return program;
}

Outcome airlight(const fs::path& folder, std::vector<std::string> arguments, const Start& start) {
  arguments.insert(arguments.begin(), tool_program());
  return run(folder, arguments, start);
}

std::vector<std::string> mount_privately() {
  const Scratch scratch;
  for (const char* option : {"-m", "-rm"}) {
    if (run(scratch.path(), {"unshare", option, "mount", "-t", "tmpfs", "none", "."}).exit_code == 0) {
      return {"unshare", option};
    }
  }
  return {};
}

Outcome airlight_on_a_small_disk(const fs::path& folder, const std::string& size,
                                 const std::vector<std::string>& arguments) {
  const Scratch disk;
  Start start;
  start.environment = {{"DISK", disk.path().string()}, {"SIZE", size}};
  // A user is root in there, and Mesa would look for its cache in root's home. It says so where it cannot make one.
  const std::string script =
      "mount -t tmpfs -o size=$SIZE none \"$DISK\" && cp -R . \"$DISK\" && cd \"$DISK\" || exit 3\n"
      "export XDG_CACHE_HOME=\"${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}\"\n"
      "mkdir -p \"$XDG_CACHE_HOME\" 2>/dev/null || export MESA_SHADER_CACHE_DISABLE=true\n"
      "\"$0\" \"$@\"; code=$?\n"
      "cp -R . \"$OLDPWD\" || exit 3\n"
      "exit $code";
  std::vector<std::string> words = mount_privately();
  words.insert(words.end(), {"sh", "-c", script, tool_program()});
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run(folder, words, start);
}

Scratch::Scratch() {
  std::string pattern = (fs::temp_directory_path() / "airlight-test-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("mkdtemp failed for " + pattern);
  }
  path_ = pattern;
}

Scratch::~Scratch() {
  std::error_code error;
  fs::remove_all(path_, error);
}

fs::path Scratch::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

std::string Scratch::read(const std::string& name) const {
  std::ifstream file(path_ / name, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> Scratch::files() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path_)) {
    if (!entry.is_directory()) {
      names.push_back(fs::relative(entry.path(), path_).string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string small_preset() {
  return R"({"airlight": 1,
 "media": [{"name": "air", "scattering_per_km": [0.0058, 0.0135, 0.0331],
            "density": {"profile": "exponential", "scale_height_km": 8}, "phase": {"function": "rayleigh"}}],
 "camera": {"pitch_deg": 10},
 "image": {"width": 32, "height": 18}}
)";
}

}  // namespace airlight::test
