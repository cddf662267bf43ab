#include "core/foreign/foreign_picture.h"

#include <fstream>

#include "core/error.h"
#include "core/foreign/exr_picture.h"
#include "core/foreign/module.h"
#include "core/output/first_bytes.h"

namespace airlight::foreign {

const Channel* Picture::find(const std::string& name) const {
  for (const Channel& channel : channels) {
    if (channel.name == name) {
      return &channel;
    }
  }
  return nullptr;
}

std::string Picture::channel_list() const {
  constexpr std::size_t kMost = 40;
  std::string list;
  for (std::size_t i = 0; i < channels.size() && i < kMost; ++i) {
    list += (list.empty() ? "" : ", ") + channels[i].name;
  }
  return list + (channels.size() > kMost ? " and " + std::to_string(channels.size() - kMost) + " more" : "");
}

Picture read_picture(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (in && starts_with(in, kExrMagic)) {
    return read_exr_picture(file);
  }
  static const auto read = reinterpret_cast<ReadFunction>(module_entry(kReadEntry));
  Picture picture;
  std::string problem;
  read(file, picture, problem);
  if (!problem.empty()) {
    throw InputError(problem);
  }
  return picture;
}

}  // namespace airlight::foreign
