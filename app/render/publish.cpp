#include "app/render/publish.h"

#include "app/render/table_files.h"
#include "core/error.h"
#include "core/output/atomic_file.h"

namespace airlight::cli {
namespace {

[[noreturn]] void refuse(const PictureContext& context, const PublishOrder& order, const std::string& fault) {
  const std::string what = order.source + ": " + fault;
  if (context.rendering.picture_fault().empty()) {
    throw RunError(what + "; no picture was written");  // in a layer, which no PNG shows
  }
  if (context.scene.display.view != kDiagnosticView || order.targets.png.empty()) {
    throw RunError(what + "; no picture was written; --png FILE --view diagnostic shows where");
  }
  write_file(order.targets.png, picture_png(context, std::nullopt, order.bits));
  throw RunError(what + "; " + order.targets.png + " shows where: " + diagnostic_legend());
}

}  // namespace

Published publish(const PictureContext& context, const PublishOrder& order,
                  const std::optional<DisplayTransform>& transform, Stopwatch& watch) {
  const std::string fault = context.rendering.fault();
  if (!fault.empty()) {
    refuse(context, order, fault);
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
  if (!order.targets.tables.empty()) {
    const std::vector<std::string> written =
        write_tables(order.targets.tables, context.rendering.tables, context.provenance);
    done.files.insert(done.files.end(), written.begin(), written.end());
    watch.lap("tables, encoding and writing");
  }
  return done;
}

}  // namespace airlight::cli
