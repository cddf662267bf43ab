#include "core/scene/printable.h"

#include <algorithm>

namespace airlight {
namespace {

std::string hex(unsigned value, int digits) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
    text += kDigits[(value >> static_cast<unsigned>(shift)) & 15U];
  }
  return text;
}

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

bool is_obeyed(unsigned code) {
  const bool control = code < 0x20U || (code >= 0x7fU && code < 0xa0U);
  const bool direction = code == 0x061cU || code == 0x200eU || code == 0x200fU ||
                         (code >= 0x202aU && code <= 0x202eU) || (code >= 0x2066U && code <= 0x2069U);
  return control || direction || code == 0x2028U || code == 0x2029U;
}

}  // namespace

Character character_at(std::string_view text, std::size_t i) {
  const unsigned first = byte_at(text, i);
  if (first < 0x80U) {
    return {first, 1};
  }
  const std::size_t bytes = first >= 0xf0U ? 4 : first >= 0xe0U ? 3 : 2;
  if (first < 0xc2U || first > 0xf4U || i + bytes > text.size()) {
    return {};
  }
  unsigned code = first & (0x7fU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k) {
    const unsigned next = byte_at(text, i + k);
    if ((next & 0xc0U) != 0x80U) {
      return {};
    }
    code = (code << 6U) | (next & 0x3fU);
  }
  const unsigned least = bytes == 4 ? 0x10000U : bytes == 3 ? 0x800U : 0x80U;
  const bool surrogate = code >= 0xd800U && code < 0xe000U;
  return code < least || surrogate || code > 0x10ffffU ? Character{} : Character{code, bytes};
}

std::string printable(std::string_view text, bool keep_lines) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const Character c = character_at(text, i);
    if (c.bytes == 0) {
      out += "\\x" + hex(byte_at(text, i), 2);
    } else if (c.code == '\n') {
      out += keep_lines ? "\n" : "\\n";
    } else if (c.code == '\t') {
      out += "\\t";
    } else if (is_obeyed(c.code)) {
      out += "\\u" + hex(c.code, 4);
    } else {
      out += text.substr(i, c.bytes);
    }
    i += std::max<std::size_t>(c.bytes, 1);
  }
  return out;
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) {
    return std::string(text);
  }
  std::size_t end = most;
  // The cut must not fall inside a UTF-8 character, whose later bytes are 10xxxxxx.
  while (end > 0 && (byte_at(text, end) & 0xc0U) == 0x80U) {
    --end;
  }
  return std::string(text.substr(0, end)) + "...";
}

std::string quoted_text(std::string_view text) {
  std::string escaped;
  for (const char c : shortened(text)) {
    escaped += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return "\"" + printable(escaped) + "\"";
}

}  // namespace airlight
