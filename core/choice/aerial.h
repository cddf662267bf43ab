#pragma once
// Whether the aerial volume is right enough for the things of a picture.

#include <span>

#include "core/render/spans.h"

namespace airlight::choice {

// A bound on the volume's mean error against the march, measured at up to 256 of the spans: the greater of the
// radiance's, relative, and the transmittance's. No span: 0.
double volume_error(Executor& executor, const Stage& stage, std::span<const Span> spans, const SpanWay& volume);

}  // namespace airlight::choice
