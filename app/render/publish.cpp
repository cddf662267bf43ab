#include "app/render/publish.h"

#include "core/error.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {

void refuse(const Scene& scene, const Rendering& rendering, const std::string& source, const std::string& png,
            const std::function<void()>& write_png) {
  const std::string what = source + ": " + rendering.fault();
  if (rendering.picture_fault().empty()) {
    throw RunError(what + "; no picture was written");  // in a layer, which no PNG shows
  }
  if (scene.display.view != kDiagnosticView || png.empty()) {
    throw RunError(what + "; no picture was written; --png FILE --view diagnostic shows where");
  }
  write_png();
  throw RunError(what + "; " + png + " shows where: " + diagnostic_legend());
}

Published publish(const PictureContext& context, const PublishOrder& order,
                  const std::optional<DisplayTransform>& transform, Stopwatch& watch) {
  if (!context.rendering.fault().empty()) {
    refuse(context.scene, context.rendering, order.source, order.targets.png,
           [&] { write_file(order.targets.png, picture_png(context, std::nullopt, order.bits)); });
  }
  Published done;
  ExrFile exr;
  std::vector<std::byte> png;
  if (!order.targets.exr.empty()) {
    exr = picture_exr(context, order.half);
    done.exr = exr.counts;
    watch.lap("EXR, encoding");
  }
  if (!order.targets.png.empty()) {
    png = picture_png(context, transform, order.bits);
    watch.lap("PNG, display transform and encoding");
  }
  if (!order.targets.exr.empty()) {
    write_file(order.targets.exr, exr.bytes);
    done.files.push_back(order.targets.exr);
    watch.lap("EXR, writing");
  }
  if (!order.targets.png.empty()) {
    write_file(order.targets.png, png);
    done.files.push_back(order.targets.png);
    watch.lap("PNG, writing");
  }
  return done;
}

}  // namespace airlight::cli
