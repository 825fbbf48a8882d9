// What `sir probe` says: a line with a ray in, a line of JSON out (the thesis has no such thing).
#pragma once

#include <string>
#include <string_view>

#include "tracer/probe.h"

namespace sir {

/// Answers `ox oy oz dx dy dz`, a ray in SC_CENA: appends to `text`
///
///   {"hits":[{"t":1.5,"side":"in","node":3,"face":0,"surface":2},...]}
///
/// with the boundaries in order and 17 digits of t, or {"error":"..."} for a line that is no ray,
/// and for one along which some t is no finite number. A blank line gets nothing. False: an error.
bool answer_ray(Prober& prober, std::string_view line, std::string& text);

/// Appends {"error":"..."}; `reason` is plain ASCII without quotation marks.
void append_probe_error(std::string_view reason, std::string& text);

}  // namespace sir
