#include "core/scene/named_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace airlight {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestText = std::size_t{16} << 20U;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

}  // namespace

std::string named_file_problem(const fs::path& file) {
  if (file.native().find('\0') != std::string::npos) {
    return "no file has a NUL in its name";
  }
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  switch (status.type()) {
    case fs::file_type::regular:
      return {};
    case fs::file_type::directory:
      return "is a directory";
    case fs::file_type::fifo:
      return "is a pipe, not a file";
    case fs::file_type::socket:
      return "is a socket, not a file";
    case fs::file_type::block:
    case fs::file_type::character:
      return "is a device, not a file";
    default:
      return std::strerror(error ? error.value() : ENOENT);
  }
}

NamedText read_named_text(const fs::path& file) {
  if (std::string problem = named_file_problem(file); !problem.empty()) {
    return {.text = {}, .problem = std::move(problem)};
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    return {.text = {}, .problem = std::strerror(errno != 0 ? errno : ENOENT)};
  }
  std::string text;
  char piece[16384];  // most have a few kilobytes: room for the largest is 4096 pages to clear
  while (stream && text.size() <= kLargestText) {
    stream.read(piece, sizeof piece);
    text.append(piece, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) {
    return {.text = {}, .problem = std::strerror(errno != 0 ? errno : EIO)};
  }
  if (text.size() > kLargestText) {
    return {.text = {}, .problem = "is larger than 16 MiB"};
  }
  if (text.starts_with(kByteOrderMark)) {
    text.erase(0, kByteOrderMark.size());
  }
  return {.text = std::move(text), .problem = {}};
}

}  // namespace airlight
