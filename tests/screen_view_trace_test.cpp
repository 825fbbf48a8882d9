// What a person does to the images on the screen passes on the bus, and can be replayed.
#include <gtest/gtest.h>

#include <vector>

#include "eltek/trace_player.h"
#include "eltek/trace_recorder.h"
#include "eltek/trace_text.h"
#include "viewer/screen_view.h"

namespace sir::viewer {
namespace {

ShownImage image(const char* name, int seed, const quant::DacBits& dac) {
  ShownImage shown{name, name, {64, 48}, std::vector<std::uint8_t>(64 * 48), {}};
  for (std::size_t i = 0; i < shown.indices.size(); ++i)
    shown.indices[i] = static_cast<std::uint8_t>(i * static_cast<std::size_t>(seed));
  shown.lut.dac = dac;
  for (std::size_t i = 0; i < 256; ++i)
    shown.lut.entry[i] = {static_cast<std::uint8_t>(i % 32), static_cast<std::uint8_t>(i / 4),
                          static_cast<std::uint8_t>(i * 7 % 32)};
  return shown;
}

TEST(ScreenViewTrace, PlanesAndImagesAreReplayed) {
  const quant::DacBits high{{5, 6, 5}};
  eltek::TraceRecorder recorder;
  ScreenView view({image("A", 3, high), image("B", 5, {}), image("C", 7, {})}, false, &recorder);
  std::vector<std::size_t> ends;
  std::vector<eltek::IndexedScreen> seen;
  const auto note = [&] {
    ends.push_back(recorder.trace().records().size());
    seen.push_back(view.capture());
  };
  note();
  view.toggle_plane(3);
  note();
  view.next();  // another DAC
  note();
  view.next();
  note();
  view.all_planes();
  note();
  EXPECT_EQ(recorder.trace().dac(), high);
  EXPECT_EQ(ends[1], ends[0] + 1);

  eltek::TracePlayer player(eltek::parse_trace("session", eltek::trace_text(recorder.trace())));
  EXPECT_EQ(player.count(), ends.back());
  for (const std::size_t i : {4u, 0u, 2u, 1u, 3u}) {
    player.seek(ends[i]);
    EXPECT_EQ(player.raster().capture(), seen[i]) << i;
  }
}

}  // namespace
}  // namespace sir::viewer
