#include "core/methods/path_trace/checkpoint.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/base/file_descriptor.h"
#include "core/methods/path_trace/random.h"

namespace airlight {
namespace {

constexpr std::string_view kMagic = "airlight path-trace checkpoint 1\n";
constexpr std::uint64_t kByteOrder = 0x0102030405060708u;

static_assert(sizeof(PixelSums) == 56, "written as it stands in memory");

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = bytes.size();
  for (std::size_t k = 0; k < bytes.size(); k += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + k, std::min<std::size_t>(8, bytes.size() - k));
    sum = mix_bits(sum + kGoldenGamma + word);
  }
  return sum;
}

template <class T>
void append(std::string& text, const T& value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string header_of(const std::string& identity) {
  return std::string(kMagic) + identity + "\n";
}

// The first line in which two identities differ: the scene's and the file's.
std::string difference(std::string_view scene, std::string_view file) {
  while (!scene.empty() || !file.empty()) {
    const std::string_view a = scene.substr(0, scene.find('\n'));
    const std::string_view b = file.substr(0, file.find('\n'));
    if (a != b) {
      return "the scene has \"" + std::string(a) + "\", the checkpoint \"" + std::string(b) + "\"";
    }
    scene.remove_prefix(std::min(a.size() + 1, scene.size()));
    file.remove_prefix(std::min(b.size() + 1, file.size()));
  }
  return "their contents differ";
}

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw InputError(file + ": " + why + "; name another file, or delete this one to start anew");
}

void write_whole(const std::string& file, std::string_view bytes) {
  const FileDescriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!out || !write_all(out.get(), std::as_bytes(std::span(bytes))) || ::fsync(out.get()) != 0) {
    throw RunError(file + ": cannot write the checkpoint: " + std::strerror(errno) +
                   "; free some space or name another");
  }
}

}  // namespace

bool read_checkpoint(const std::string& file, const std::string& identity, std::span<PixelSums> pixels) {
  if (::access(file.c_str(), F_OK) != 0 && errno == ENOENT) {
    return false;
  }
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.good() && !in.eof()) {
    refuse(file, std::string("cannot be read: ") + std::strerror(errno));
  }
  if (!bytes.starts_with(kMagic)) {
    refuse(file, "is not a checkpoint of path-trace (expected its first line to be \"" +
                     std::string(kMagic.substr(0, kMagic.size() - 1)) + "\")");
  }
  const std::string header = header_of(identity);
  const std::size_t data = bytes.find("\n\n");
  if (data == std::string::npos) {
    refuse(file, "is cut short");
  }
  if (bytes.substr(0, data + 2) != header) {
    refuse(file, "was made from another scene: " +
                     difference(identity, std::string_view(bytes).substr(kMagic.size(), data + 1 - kMagic.size())));
  }
  const std::size_t body = sizeof kByteOrder + pixels.size_bytes();
  if (bytes.size() != header.size() + body + sizeof(std::uint64_t)) {
    refuse(file, "is cut short: " + std::to_string(bytes.size()) + " bytes, expected " +
                     std::to_string(header.size() + body + sizeof(std::uint64_t)));
  }
  std::uint64_t order = 0;
  std::uint64_t sum = 0;
  std::memcpy(&order, bytes.data() + header.size(), sizeof order);
  std::memcpy(&sum, bytes.data() + header.size() + body, sizeof sum);
  if (order != kByteOrder || sum != checksum(std::string_view(bytes).substr(0, header.size() + body))) {
    refuse(file, "is damaged (its checksum does not fit)");
  }
  std::memcpy(pixels.data(), bytes.data() + header.size() + sizeof order, pixels.size_bytes());
  return true;
}

void write_checkpoint(const std::string& file, const std::string& identity, std::span<const PixelSums> pixels) {
  std::string bytes = header_of(identity);
  append(bytes, kByteOrder);
  bytes.append(reinterpret_cast<const char*>(pixels.data()), pixels.size_bytes());
  append(bytes, checksum(bytes));
  const std::string temporary = file + ".part-" + std::to_string(::getpid());
  try {
    write_whole(temporary, bytes);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  if (std::rename(temporary.c_str(), file.c_str()) != 0) {
    const std::string why = std::strerror(errno);
    ::unlink(temporary.c_str());
    throw RunError(file + ": cannot replace the checkpoint: " + why);
  }
}

}  // namespace airlight
