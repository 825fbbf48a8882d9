// The text of a register trace (our format; docs/ma120.md has an example).
#pragma once

#include <filesystem>
#include <string>

#include "eltek/trace_record.h"
#include "tracer/atomic_file.h"

namespace sir::eltek {

/// One record a line, between a first line that names format, version and DAC, and a last one
/// with the number of records:
///
///   MA120 trace 1 dac 6 6 6
///   lut.write 0              port and value, decimal; the ports as name(Port) has them
///   blank on                 or off
///   pixel 4D*192 00 1F       indices, two hexadecimal digits; *N: N times
///   read lut.data 63         what was read; ? where that is unknown
///   read pixel 4D*3 ?*2
///   wait 300                 until that line is next
///   power 5 6 5              off and on, with a DAC of these bits
///   end 7
///
/// Lower and upper case are the same; # begins a comment; blank lines are passed over.
///
/// Reading throws FileError with file and line for anything else, for values beyond a register's
/// range, for more pixels than Trace allows, and, as "cut off", for a file that has no last line
/// or another number of records than that line says.
Trace read_trace(const std::filesystem::path& path);

/// The same from memory; `name` stands for the file in errors.
Trace parse_trace(std::string name, std::string text);

/// The whole text; parse_trace() gives an equal trace.
std::string trace_text(const Trace& trace);

/// Writes trace_text() piece by piece into a file whose commit() is the caller's. Throws FileError.
void write_trace(AtomicFile& file, const Trace& trace);

/// The same as a whole: the file is there with all its content or not at all.
void write_trace(const std::filesystem::path& path, const Trace& trace);

}  // namespace sir::eltek
