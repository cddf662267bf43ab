#include "core/output/working_space.h"

#include <OpenColorIO/OpenColorIO.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/output/parallel.h"

namespace airlight {
namespace {

namespace ocio = OCIO_NAMESPACE;

const std::array<std::string, 4> kNames = {"linear-rec709", "ACEScg", "ACES2065-1", "linear-rec2020"};

// ITU-R BT.709 and BT.2020 with D65; SMPTE ST 2065-1 and the Academy's S-2014-004 with ACES's white.
constexpr std::array<Chromaticities, 4> kChromaticities = {{
    {0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F},
    {0.713F, 0.293F, 0.165F, 0.830F, 0.128F, 0.044F, 0.32168F, 0.33767F},
    {0.7347F, 0.2653F, 0.0F, 1.0F, 0.0001F, -0.077F, 0.32168F, 0.33767F},
    {0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F},
}};

// ITU-R BT.2087-0, annex 2: linear BT.709 to linear BT.2020.
constexpr std::array<double, 16> kRec709ToRec2020 = {0.6274, 0.3293, 0.0433, 0.0, 0.0691, 0.9195, 0.0114, 0.0,
                                                     0.0164, 0.0880, 0.8956, 0.0, 0.0,    0.0,    0.0,    1.0};

ocio::ConstTransformRcPtr transform_to(WorkingSpace space) {
  auto all = ocio::GroupTransform::Create();
  if (space == WorkingSpace::linear_rec2020) {
    auto matrix = ocio::MatrixTransform::Create();
    matrix->setMatrix(kRec709ToRec2020.data());
    all->appendTransform(matrix);
  }
  if (space == WorkingSpace::acescg || space == WorkingSpace::aces2065_1) {
    auto to_ap1 = ocio::BuiltinTransform::Create();
    to_ap1->setStyle("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD");
    to_ap1->setDirection(ocio::TRANSFORM_DIR_INVERSE);
    all->appendTransform(to_ap1);
  }
  if (space == WorkingSpace::aces2065_1) {
    auto to_ap0 = ocio::BuiltinTransform::Create();
    to_ap0->setStyle("ACEScg_to_ACES2065-1");
    all->appendTransform(to_ap0);
  }
  return all;
}

ocio::ConstCPUProcessorRcPtr processor_to(WorkingSpace space, ocio::TransformDirection direction) {
  try {
    return ocio::Config::CreateRaw()->getProcessor(transform_to(space), direction)->getDefaultCPUProcessor();
  } catch (const ocio::Exception& error) {
    throw RunError(std::string("OpenColorIO cannot reach ") + kNames.at(static_cast<std::size_t>(space)) + ": " +
                   error.what());
  }
}

void transform_pixels(RadianceImage& image, const ocio::ConstCPUProcessorRcPtr& processor) {
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  for_row_strips(image.height, [&](int first, int end) {
    float* const start = image.rgba.data() + row * static_cast<std::size_t>(first);
    ocio::PackedImageDesc pixels(start, image.width, end - first, 4);
    processor->apply(pixels);
  });
}

}  // namespace

std::span<const std::string> working_space_names() {
  return kNames;
}

std::optional<WorkingSpace> working_space(std::string_view name) {
  return named<WorkingSpace>(kNames, name);
}

Chromaticities chromaticities_of(WorkingSpace space) {
  return kChromaticities.at(static_cast<std::size_t>(space));
}

ColorMatrix from_rec709(WorkingSpace space) {
  RadianceImage axes{3, 1, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1}};
  axes = converted(std::move(axes), WorkingSpace::linear_rec709, space);
  ColorMatrix matrix{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      matrix[row][column] = static_cast<double>(axes.rgba[4 * column + row]);
    }
  }
  return matrix;
}

RadianceImage converted(RadianceImage image, WorkingSpace from, WorkingSpace to) {
  if (from == to) {
    return image;
  }
  if (from != WorkingSpace::linear_rec709) {
    transform_pixels(image, processor_to(from, ocio::TRANSFORM_DIR_INVERSE));
  }
  if (to != WorkingSpace::linear_rec709) {
    transform_pixels(image, processor_to(to, ocio::TRANSFORM_DIR_FORWARD));
  }
  return image;
}

}  // namespace airlight
