#include "core/output/png_texts.h"

#include <array>

namespace airlight {
namespace {

constexpr std::uint64_t kSignature = 8;
constexpr std::uint64_t kLongestText = std::uint64_t{64} << 20;

std::uint64_t big_endian(const char* bytes) {
  std::uint64_t number = 0;
  for (int i = 0; i < 4; ++i) {
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

// tEXt: keyword, 0, text. iTXt: keyword, 0, compression flag, its method, language, 0, translated keyword, 0, text.
void add_text(std::map<std::string, std::string>& texts, const std::string& type, const std::string& data) {
  std::size_t end = data.find('\0');
  if (end == std::string::npos) {
    return;
  }
  const std::string key = data.substr(0, end);
  if (type == "iTXt") {
    if (data.size() < end + 3 || data[end + 1] != 0) {
      return;
    }
    end = data.find('\0', end + 3);
    end = end == std::string::npos ? end : data.find('\0', end + 1);
    if (end == std::string::npos) {
      return;
    }
  }
  texts[key] = data.substr(end + 1);
}

}  // namespace

PngTexts read_png_texts(std::istream& in, std::uint64_t file_size) {
  PngTexts found;
  std::array<char, 8> head{};
  for (std::uint64_t at = kSignature; in.seekg(static_cast<std::streamoff>(at)) && in.read(head.data(), head.size());) {
    const std::uint64_t length = big_endian(head.data());
    const std::string type(head.data() + 4, 4);
    at += length + 12;
    if (at > file_size) {
      return found;
    }
    if (type == "IEND") {
      found.is_whole = at == file_size;
      return found;
    }
    if ((type == "tEXt" || type == "iTXt") && length < kLongestText) {
      std::string data(length, '\0');
      in.read(data.data(), static_cast<std::streamsize>(length));
      add_text(found.texts, type, data);
    }
  }
  return found;
}

}  // namespace airlight
