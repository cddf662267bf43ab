#pragma once
// Work without what root may do beyond others, so that a file's rights count for whoever runs the tests.

#include <linux/capability.h>
#include <linux/securebits.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <stdexcept>
#include <string>

namespace airlight::test {

// For a child process, before or without exec(): there is no way back. The user stays the same, so what is root's may
// still be used as its owner may.
inline void give_up_roots_rights() {
  ::prctl(PR_SET_SECUREBITS, SECBIT_NOROOT);  // or exec() gives them again; only root may, and only root needs it
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
  if (::syscall(SYS_capset, &header, none.data()) != 0) ::_exit(126);
}

// What `work` returns, run in a child that has given up root's rights.
inline std::string without_root(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("pipe failed");
  const pid_t child = ::fork();
  if (child == 0) {
    give_up_roots_rights();
    const std::string result = work();
    ::_exit(::write(ends[1], result.data(), result.size()) < 0 ? 1 : 0);
  }
  ::close(ends[1]);
  std::string result;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = ::read(ends[0], buffer.data(), buffer.size())) > 0;) {
    result.append(buffer.data(), static_cast<std::size_t>(count));
  }
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return status == 0 ? result : "the child ended with status " + std::to_string(status);
}

}  // namespace airlight::test
