// What `sir show` says of the MA120's registers: the trace (our model) and the bytes on the bus
// (thesis 3.5, whose program sends them).
#pragma once

#include "cli/session.h"
#include "cli/show_command.h"
#include "cli/shown_image.h"
#include "eltek/trace_recorder.h"
#include "tracer/atomic_files.h"

namespace sir::cli {

/// Before anything is done for it: refuses (FileError) a trace that would go where an input, the
/// LUT or the picture is.
void check_trace(const ShowOptions& options);

/// Writes the trace where one was asked for, as the last of `files`, and commits them.
void save_trace(AtomicFiles& files, const ShowOptions& options,
                const eltek::TraceRecorder& recorder, const Session& session);

/// Prints what the display program sends for an image, counted where it is sent, and how long a
/// bus of the rate that was asked for takes; nothing where none was.
void report_transfer(const ShownImage& image, const ShowOptions& options);

}  // namespace sir::cli
