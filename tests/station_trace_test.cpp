// What a person does to the images on the screen passes on the bus, and can be replayed.
#include <gtest/gtest.h>

#include <vector>

#include "eltek/trace_player.h"
#include "eltek/trace_recorder.h"
#include "eltek/trace_text.h"
#include "viewer/station.h"

namespace sir::viewer {
namespace {

constexpr ImageSize kSize{64, 48};

Rendition image(int seed, const quant::DacBits& dac) {
  Rendition made;
  for (std::size_t i = 0; i < kSize.pixels(); ++i)
    made.indices.push_back(static_cast<std::uint8_t>(i * static_cast<std::size_t>(seed)));
  made.lut.dac = dac;
  for (std::size_t i = 0; i < 256; ++i)
    made.lut.entry[i] = {static_cast<std::uint8_t>(i % 32), static_cast<std::uint8_t>(i / 4),
                         static_cast<std::uint8_t>(i * 7 % 32)};
  return made;
}

TEST(StationTrace, PlanesAndImagesAreReplayed) {
  const quant::DacBits high{{5, 6, 5}};
  eltek::TraceRecorder recorder;
  Station station;
  station.add_listener(recorder);
  std::vector<std::size_t> ends;
  std::vector<eltek::IndexedScreen> seen;
  const auto note = [&] {
    ends.push_back(recorder.trace().records().size());
    seen.push_back(station.capture());
  };
  station.show("A", kSize, image(3, high));
  note();
  station.set_planes(0b11110111);
  note();
  station.show("B", kSize, image(5, {}));  // another DAC
  note();
  station.show("C", kSize, image(7, {}));
  note();
  station.set_planes(0xFF);
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
