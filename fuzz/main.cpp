// One program for each target: SIR_FUZZ_PLAY is its function, libFuzzer has the rest.
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sir::fuzz::SIR_FUZZ_PLAY({data, size});
  return 0;
}
