#include "app/render/table_files.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/srgb.h"
#include "core/output/png.h"
#include "core/output/quantize.h"
#include "core/output/table_exr.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

// The table at a size that can be looked at, brightest value white, negative and non-finite values black.
RadianceImage picture_of(const TableDump& table) {
  constexpr int kSmallestSide = 256;
  const int scale = std::max(1, kSmallestSide / std::max(table.width, table.height));
  float brightest = 0.0F;
  for (std::size_t i = 0; i < table.rgba.size(); ++i) {
    brightest = i % 4 != 3 && std::isfinite(table.rgba[i]) ? std::max(brightest, table.rgba[i]) : brightest;
  }
  RadianceImage picture{table.width * scale, table.height * scale, {}};
  picture.rgba.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 4);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t texel = static_cast<std::size_t>(y / scale) * static_cast<std::size_t>(table.width) +
                                static_cast<std::size_t>(x / scale);
      for (std::size_t c = 0; c < 3; ++c) {
        const float value = table.rgba[4 * texel + c];
        const bool lit = std::isfinite(value) && value > 0.0F;
        picture.rgba.push_back(lit ? srgb_encoded(value / brightest) : 0.0F);
      }
      picture.rgba.push_back(1.0F);
    }
  }
  return picture;
}

}  // namespace

void require_folder(const fs::path& folder) {
  std::error_code error;
  const std::string name = folder.string();
  if (name.empty()) {
    throw InputError("the folder's name is empty; give one such as tables");
  }
  if (fs::exists(folder, error)) {
    if (!fs::is_directory(folder, error)) {
      throw InputError(name + ": is a file, not a folder; choose another name");
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
      throw InputError(name + ": the folder cannot be written; choose one of your own");
    }
    return;
  }
  const fs::path parent = fs::absolute(folder / ".").parent_path().parent_path();
  if (!fs::is_directory(parent, error)) {
    throw InputError(name + ": the folder " + parent.string() + " does not exist; create it with: mkdir -p " +
                     parent.string());
  }
  if (::access(parent.c_str(), W_OK | X_OK) != 0) {
    throw InputError(name + ": the folder cannot be made in " + parent.string() + "; choose a place of your own");
  }
}

MadeFolder::MadeFolder(const fs::path& folder) : folder_(folder) {
  require_folder(folder);
  std::error_code error;
  made_ = fs::create_directory(folder, error);
  if (error) {
    throw RunError(folder.string() + ": the folder cannot be made: " + error.message());
  }
}

MadeFolder::~MadeFolder() {
  std::error_code not_empty;
  if (made_) {
    fs::remove(folder_, not_empty);
  }
}

std::vector<std::string> write_tables(const fs::path& folder, const std::vector<TableDump>& tables,
                                      const Provenance& provenance) {
  const MadeFolder made(folder);
  std::vector<std::string> files;
  for (const TableDump& dump : tables) {
    const Table table{dump.width, dump.height, dump.rgba.data(), dump.text, dump.channels};
    const fs::path exr = folder / (dump.name + ".exr");
    const fs::path png = folder / (dump.name + ".png");
    write_table_exr(exr, table, provenance);
    write_png(png, quantize(picture_of(dump), {}), {kSrgbCode, {{"Description", dump.text.quantity}}});
    files.push_back(exr.string());
    files.push_back(png.string());
  }
  return files;
}

}  // namespace airlight::cli
