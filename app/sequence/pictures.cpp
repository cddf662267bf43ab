#include "app/sequence/pictures.h"

#include "app/cli/interruption.h"
#include "app/cli/terminal.h"
#include "app/render/picture_files.h"
#include "app/sequence/film.h"
#include "core/base/error.h"
#include "core/output/atomic_file.h"
#include "core/output/last_words.h"
#include "core/output/picture_reader.h"
#include "core/scene/json_format.h"
#include "core/sequence/contact_sheet.h"

namespace airlight::cli {
namespace {

// Frames of any sequence as 8-bit pictures, read back one by one.
class FrameReader {
 public:
  explicit FrameReader(const SequenceJob& job) : job_(job) {
    PictureOptions options = job.picture;
    options.bits = 8;
    transform_ = display_transform(options, job.scene);
  }

  // The colours of the pictures read.
  std::optional<ColourCode> colours() const { return transform_ ? transform_->colours() : kSrgbCode; }

  PixelImage read(std::size_t index) const {
    const Targets files = files_of(job_, sequence::frame_number(job_.source, index));
    if (job_.png) {
      return read_png_picture(files.png);
    }
    ExrPicture picture = read_exr_picture(files.exr);
    const WorkingSpace space = working_space_of(job_.picture);
    picture.radiance = converted(std::move(picture.radiance), space, WorkingSpace::linear_rec709);
    if (picture.bloom) {
      picture.bloom = converted(std::move(*picture.bloom), space, WorkingSpace::linear_rec709);
    }
    AddedLight glow;
    if (picture.bloom) {
      glow = {picture.bloom->rgba.data(), static_cast<float>(job_.scene.bloom.intensity)};
    }
    return transform_->apply(picture.radiance, glow, picture.exposure);
  }

 private:
  const SequenceJob& job_;
  std::optional<DisplayTransform> transform_;
};

// The label that tells a frame from its neighbours: the time, or the sun's elevation, or its number.
std::string label_of(const SequenceJob& job, std::size_t index) {
  const sequence::Frame frame = sequence::frame_at(job.source, index);
  if (frame.time) {
    return sequence::clock_text(frame.time->utc, frame.time->offset_seconds);
  }
  const bool sweep = std::holds_alternative<sequence::Sweep>(job.source);
  return sweep ? format_number(frame.keys.front().second.front()) + " deg" : std::to_string(frame.number);
}

// False where a signal ended it; nothing is written then.
bool make_contact_sheet(const std::string& file, const SequenceJob& job, const FrameReader& reader) {
  constexpr std::size_t kMostFrames = 60;
  constexpr int kLargestSide = 160;
  std::vector<sequence::Thumbnail> thumbnails;
  for (const std::size_t index : sequence::frames_shown(sequence::frame_count(job.source), kMostFrames)) {
    if (Interruption::signal() != 0) {
      return false;
    }
    const PixelImage picture = reader.read(index);
    thumbnails.push_back(
        sequence::shrink(picture.width, picture.height, picture.channels, picture.bytes, kLargestSide));
    thumbnails.back().label = label_of(job, index);
  }
  const measure::Raster sheet = sequence::contact_sheet(thumbnails);
  PngOptions options;
  options.smallest = true;
  options.texts["Software"] = std::string("airlight ") + AIRLIGHT_VERSION;
  write_png(file, {sheet.width(), sheet.height(), 3, 8, sheet.rgb(), {}}, options);
  return true;
}

void make_preview(const SequencePictures& pictures, const SequenceJob& job, const FrameReader& reader) {
  const std::size_t frames = sequence::frame_count(job.source);
  const PixelImage first = reader.read(0);
  Film film(*pictures.preview, first.width, first.height, pictures.frames_a_second, reader.colours());
  for (std::size_t index = 0; index < frames; ++index) {
    if (Interruption::signal() != 0) {
      return;  // its destructor removes the film
    }
    const PixelImage picture = index == 0 ? first : reader.read(index);
    if (picture.width != first.width || picture.height != first.height) {
      throw RunError(*pictures.preview + ": frame " + std::to_string(sequence::frame_number(job.source, index)) +
                     " has another size than the first; a film needs frames of one size");
    }
    film.add(picture);
  }
  film.finish();
}

}  // namespace

void check_pictures(const SequencePictures& pictures, const SequenceJob& job) {
  if (!pictures.preview && !pictures.contact_sheet) {
    return;
  }
  const std::string option = pictures.preview ? "sequence: --preview" : "sequence: --contact-sheet";
  if (job.shard.count > 1) {
    throw InputError(option + ": one shard is not the whole sequence; when all are done, give the same command once " +
                     "without --shard: whole frames are kept");
  }
  if (!job.png && (job.scene.display.view == kGpuView || job.scene.display.view == kDiagnosticView)) {
    throw InputError(option + ": EXRs are shown through OpenColorIO, which has no view '" + job.scene.display.view +
                     "'; write PNGs too: --png 'sky.####.png'");
  }
  if (pictures.contact_sheet) {
    require_ending(*pictures.contact_sheet, "sequence: --contact-sheet", ".png");
    require_writable(*pictures.contact_sheet);
  }
  if (pictures.preview) {
    require_film(*pictures.preview, "sequence: --preview");
    for (const auto& [pointer, values] : sequence::frame_at(job.source, 0).keys) {
      if (pointer.starts_with("/image/")) {
        throw InputError("sequence: --preview: frames have their own " + pointer +
                         ", and a film needs frames of one size; leave one of the two out");
      }
    }
  }
}

void make_pictures(const SequencePictures& pictures, const SequenceJob& job) {
  if (!pictures.preview && !pictures.contact_sheet) {
    return;
  }
  const Interruption interruption;
  if (pictures.contact_sheet) {
    remove_abandoned_files_of(*pictures.contact_sheet);
  }
  if (pictures.preview) {
    remove_abandoned_film(*pictures.preview);
  }
  const FrameReader reader(job);
  std::string whole = "the frames";
  std::string missing;
  if (pictures.contact_sheet) {
    const bool made = make_contact_sheet(*pictures.contact_sheet, job, reader);
    tell(job.quiet || !made ? "" : *pictures.contact_sheet + "\n");
    (made ? whole : missing) += made ? " and " + *pictures.contact_sheet : "the contact sheet";
  }
  if (pictures.preview && Interruption::signal() == 0) {
    make_preview(pictures, job, reader);
  }
  if (const int signal = Interruption::signal(); signal != 0) {
    if (pictures.preview) {
      missing += missing.empty() ? "the preview" : ", the preview";
    }
    throw RunError(std::string("stopped by ") + signal_name(signal) + ": " + whole + " are whole" +
                   (missing.empty() ? "" : "; not made: " + missing));
  }
  if (pictures.preview) {
    tell(job.quiet ? "" : *pictures.preview + "\n");
  }
}

}  // namespace airlight::cli
