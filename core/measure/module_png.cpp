#include "core/measure/module_png.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>

#include "core/error.h"
#include "core/measure/words.h"

namespace airlight::measure {

std::vector<std::byte> encode_png(const Raster& raster) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput proxy(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png");
  if (!output) throw RunError("OpenImageIO has no PNG writer: " + one_line(OIIO::geterror()));
  OIIO::ImageSpec spec(raster.width(), raster.height(), 3, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", 4);
  if (!output->set_ioproxy(&proxy) || !output->open("memory.png", spec) ||
      !output->write_image(OIIO::TypeUInt8, raster.rgb().data()) || !output->close()) {
    throw RunError("cannot encode a PNG: " + one_line(output->geterror()));
  }
  std::vector<std::byte> result(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i) result[i] = static_cast<std::byte>(bytes[i]);
  return result;
}

}  // namespace airlight::measure
