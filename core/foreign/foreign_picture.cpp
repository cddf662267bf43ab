#include "core/foreign/foreign_picture.h"

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/foreign/exr_picture.h"
#include "core/foreign/jpeg_extent.h"
#include "core/foreign/module.h"
#include "core/foreign/png_extent.h"
#include "core/foreign/tiff_extent.h"
#include "core/output/first_bytes.h"
#include "core/scene/named_file.h"
#include "core/scene/printable.h"

namespace airlight::foreign {

std::string Picture::channel_list() const {
  constexpr std::size_t kMost = 40;
  std::string list;
  for (std::size_t i = 0; i < channels.size() && i < kMost; ++i) {
    list += (list.empty() ? "" : ", ") + channels[i].name;
  }
  return list + (channels.size() > kMost ? " and " + std::to_string(channels.size() - kMost) + " more" : "");
}

Picture read_picture(const std::string& file, const Accept& accept) {
  if (file.find('\0') != std::string::npos) {
    throw InputError(printable(file) + ": no file has a NUL in its name");
  }
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw InputError(file + ": no such file; expected a picture");
  }
  if (const std::string problem = named_file_problem(file); !problem.empty()) {
    throw InputError(file + ": " + problem + "; expected a picture");
  }
  std::ifstream in(file, std::ios::binary);
  if (in && starts_with(in, kExrMagic)) {
    return read_exr_picture(file, accept);
  }
  try {
    require_whole_tiff(file);
    require_whole_jpeg(file);
    require_whole_png(file);
  } catch (const std::exception& reason) {
    throw InputError(file + ": damaged or cut short: " + reason.what() + "; write or copy it again");
  }
  static const auto read = reinterpret_cast<ReadFunction>(module_entry(kReadEntry));
  Picture picture;
  std::string problem;
  read(file, accept, picture, problem);
  if (!problem.empty()) {
    throw InputError(problem);
  }
  return picture;
}

}  // namespace airlight::foreign
