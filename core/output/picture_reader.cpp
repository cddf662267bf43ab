#include "core/output/picture_reader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <png.h>

#include <string>

#include "core/base/error.h"
#include "core/output/exr_header.h"

namespace airlight {
namespace {

namespace imf = OPENEXR_IMF_NAMESPACE;

RadianceImage blank(const Imath::Box2i& window) {
  RadianceImage image{window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  return image;
}

// Reads PREFIX.R to PREFIX.A into the image; A becomes 1 where it is missing.
void add_slices(imf::FrameBuffer& frame, RadianceImage& image, const Imath::Box2i& window, const std::string& prefix) {
  for (std::size_t c = 0; c < 4; ++c) {
    const std::string name = prefix + "RGBA"[c];
    frame.insert(name, imf::Slice::Make(imf::FLOAT, image.rgba.data() + c, window.min, image.width, image.height,
                                        4 * sizeof(float), 4 * sizeof(float) * static_cast<std::size_t>(image.width), 1,
                                        1, c == 3 ? 1.0 : 0.0));
  }
}

}  // namespace

ExrPicture read_exr_picture(const std::filesystem::path& file) {
  try {
    require_room_for_exr(file);
    imf::InputFile in(file.c_str());
    const Imath::Box2i window = in.header().dataWindow();
    ExrPicture picture;
    picture.radiance = blank(window);
    imf::FrameBuffer frame;
    add_slices(frame, picture.radiance, window, "");
    if (in.header().channels().findChannel("bloom.R") != nullptr) {
      picture.bloom = blank(window);
      add_slices(frame, *picture.bloom, window, "bloom.");
    }
    in.setFrameBuffer(frame);
    in.readPixels(window.min.y, window.max.y);
    if (const auto* exposure = in.header().findTypedAttribute<imf::FloatAttribute>("airlight:exposure")) {
      picture.exposure = exposure->value();
    }
    return picture;
  } catch (const std::exception& error) {
    throw RunError(file.string() + ": cannot be read back: " + error.what());
  }
}

PixelImage read_png_picture(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto fail = [&]() {
    const std::string reason = png.message;
    png_image_free(&png);
    return RunError(file.string() + ": cannot be read back: " + reason);
  };
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0) {
    throw fail();
  }
  png.format = PNG_FORMAT_RGB;
  PixelImage image{static_cast<int>(png.width), static_cast<int>(png.height), 3, 8, {}, {}};
  image.bytes.resize(PNG_IMAGE_SIZE(png));
  const png_color black{0, 0, 0};  // behind what is transparent
  if (png_image_finish_read(&png, &black, image.bytes.data(), 0, nullptr) == 0) {
    throw fail();
  }
  return image;
}

}  // namespace airlight
