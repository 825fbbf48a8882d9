// How long the program has worked (for the times of thesis 2.5 and 4.3).
#pragma once

namespace sir {

/// Processor time of the whole program so far, all threads together.
double processor_seconds();

}  // namespace sir
