// What is said about why an entry exists must lead to that entry: the log of choices is walked
// here by other means than the program's, and every cell's story is held against the LUT.
#include "quant/provenance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include "quant/frequency.h"

namespace sir::quant {
namespace {

/// Colours in a few clusters and some noise: planes of many cells and of few.
Planes clustered(unsigned seed, std::size_t noise_every = 7) {
  std::mt19937 random(seed);
  Planes image(ImageSize{90, 70});
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    const auto cluster = random() % 5;
    const auto byte = [&](unsigned long centre) {
      if (i % noise_every == 0) return static_cast<std::uint8_t>(random());
      return static_cast<std::uint8_t>(std::min(255ul, centre + random() % 40));
    };
    image.set(i, {byte(cluster * 50), byte(230 - cluster * 37), byte(cluster % 2 * 120 + 20)});
  }
  return image;
}

std::vector<ChooseOptions> all_options() {
  std::vector<ChooseOptions> all;
  for (const Space space : {Space::rgb, Space::hsv})
    for (const SplitOrder split : {SplitOrder::pixels, SplitOrder::breadth, SplitOrder::longest}) {
      ChooseOptions options;
      options.space = space;
      options.split = split;
      all.push_back(options);
      options.sample = 3;
      all.push_back(options);
    }
  for (const Space space : {Space::rgb, Space::hsv}) {
    ChooseOptions options;
    options.method = Method::frequency;
    options.space = space;
    all.push_back(options);
  }
  return all;
}

DacCode mean_of(const std::vector<Cell>& cells, const Grid& grid) {
  PointSum mean;
  for (const Cell& cell : cells) mean.add(cell.at, cell.pixels);
  return grid.code(mean);
}

CellBox box_of(const std::vector<Cell>& cells) {
  CellBox box{cells.front().at, cells.front().at, 0, cells.size()};
  for (const Cell& cell : cells) {
    box.pixels += cell.pixels;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], cell.at[axis]);
      box.high[axis] = std::max(box.high[axis], cell.at[axis]);
    }
  }
  return box;
}

/// The means of a plane's boxes after the logged splits, each of which must be as it says.
std::vector<DacCode> replayed(const std::vector<Cell>& cells, const CutLog& log, const Grid& grid) {
  std::vector<std::vector<Cell>> boxes{cells};
  for (const BoxSplit& split : log.splits) {
    const std::vector<Cell> box = boxes.at(split.place);
    EXPECT_EQ(box_of(box), split.box);
    std::vector<Cell> lower, upper;
    for (const Cell& cell : box)
      (cell.at.at(split.axis) <= split.last ? lower : upper).push_back(cell);
    EXPECT_FALSE(lower.empty());
    EXPECT_FALSE(upper.empty());
    EXPECT_EQ(box_of(lower).pixels, split.lower_pixels);
    boxes[split.place] = lower;
    boxes.insert(boxes.begin() + static_cast<std::ptrdiff_t>(split.place) + 1, upper);
  }
  EXPECT_EQ(boxes.size(), log.boxes.size());
  std::vector<DacCode> codes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_EQ(box_of(boxes[i]), log.boxes.at(i));
    codes.push_back(mean_of(boxes[i], grid));
  }
  return codes;
}

TEST(ChoiceLog, ItsSplitsMakeTheLut) {
  for (const ChooseOptions& options : all_options()) {
    if (options.method != Method::median) continue;
    const Histogram cells = count_for(clustered(1), options);
    ASSERT_GT(cells.size(), kLutEntries);
    ChoiceLog log;
    const Lut lut = choose_from(cells, options, &log);
    EXPECT_EQ(lut, choose_from(cells, options)) << "the log changes the LUT";
    EXPECT_FALSE(log.each_cell_its_own);
    const auto grid = grid_for(options);
    std::vector<DacCode> codes;
    std::size_t next_cell = 0;
    for (const PlaneChoice& plane : log.planes) {
      EXPECT_EQ(plane.first_cell, next_cell);
      EXPECT_EQ(plane.first_entry, codes.size());
      const auto first = cells.begin() + static_cast<std::ptrdiff_t>(next_cell);
      const std::vector<Cell> own(first, first + static_cast<std::ptrdiff_t>(plane.cells));
      for (const Cell& cell : own) EXPECT_EQ(grid->plane(cell.at), plane.plane);
      EXPECT_EQ(box_of(own).pixels, plane.pixels);
      next_cell += plane.cells;
      if (plane.entries == 0) continue;
      EXPECT_EQ(plane.cut.splits.size(), plane.entries - 1);
      const auto made = replayed(own, plane.cut, *grid);
      codes.insert(codes.end(), made.begin(), made.end());
    }
    EXPECT_EQ(next_cell, cells.size());
    EXPECT_EQ(make_lut(codes), lut);
  }
}

TEST(Provenance, EveryCellsStoryLeadsToItsEntry) {
  for (const ChooseOptions& options : all_options()) {
    const Planes image = clustered(2);
    const Provenance provenance(image, options);
    EXPECT_EQ(provenance.lut(), choose_lut(image, options));
    const auto grid = grid_for(options);
    std::map<GridPoint, std::uint64_t> counted;
    for (std::size_t i = 0; i < image.size.pixels(); i += options.sample)
      ++counted[grid->point(grid->cell(image.at(i)))];
    std::map<std::size_t, std::vector<Cell>> made_of;
    std::map<GridPoint, bool> met;
    for (std::size_t i = 0; i < image.size.pixels(); i += options.sample) {
      const CellOrigin origin = provenance.of(image.at(i));
      if (std::exchange(met[origin.cell], true)) continue;
      EXPECT_EQ(origin.cell, grid->point(grid->cell(image.at(i))));
      EXPECT_EQ(origin.pixels, counted.at(origin.cell));
      if (origin.entry) made_of[*origin.entry].push_back({origin.cell, origin.pixels});
      if (const auto* path = std::get_if<CutPath>(&origin.how)) {
        for (const Descent& step : path->splits)
          for (std::size_t axis = 0; axis < 3; ++axis) {
            EXPECT_LE(step.split.box.low[axis], origin.cell[axis]);
            EXPECT_GE(step.split.box.high[axis], origin.cell[axis]);
          }
        for (std::size_t k = 1; k < path->splits.size(); ++k) {
          const Descent& before = path->splits[k - 1];
          EXPECT_EQ(path->splits[k].split.box.pixels,
                    before.upper ? before.split.box.pixels - before.split.lower_pixels
                                 : before.split.lower_pixels);
        }
        EXPECT_EQ(origin.entry.has_value(), origin.plane_entries > 0);
      } else {
        const auto& rank = std::get<FrequencyRank>(origin.how);
        EXPECT_EQ(origin.entry.has_value(), rank.rank <= origin.plane_entries);
        if (origin.entry) {
          EXPECT_GE(origin.pixels, rank.last_chosen);
        } else if (origin.plane_entries > 0) {
          EXPECT_LE(origin.pixels, rank.last_chosen);
        }
        if (rank.rank == origin.plane_entries) {
          EXPECT_EQ(origin.pixels, rank.last_chosen);
        }
      }
    }
    // The cells that claim an entry are all that it was made of.
    EXPECT_EQ(made_of.size(), provenance.lut().chosen);
    for (const auto& [entry, cells] : made_of)
      EXPECT_EQ(mean_of(cells, *grid), provenance.lut().entry.at(entry)) << entry;
  }
}

TEST(Provenance, FewColoursHaveEntriesOfTheirOwn) {
  Planes image(ImageSize{40, 5});
  for (std::size_t i = 0; i < 200; ++i)
    image.set(i, {static_cast<std::uint8_t>(i % 20 * 12), 200, static_cast<std::uint8_t>(i / 20)});
  for (const ChooseOptions& options : all_options()) {
    const Provenance provenance(image, options);
    const auto grid = grid_for(options);
    for (std::size_t i = 0; i < 200; i += options.sample) {
      const CellOrigin origin = provenance.of(image.at(i));
      EXPECT_TRUE(std::holds_alternative<OwnEntry>(origin.how));
      ASSERT_TRUE(origin.entry);
      EXPECT_EQ(provenance.lut().entry.at(*origin.entry),
                code_of({origin.cell, origin.pixels}, *grid));
    }
  }
}

TEST(Provenance, SaysWhereNothingWasCounted) {
  Planes image(ImageSize{4, 1});
  for (std::size_t i = 0; i < 4; ++i) image.set(i, {255, 0, 0});
  image.set(3, {0, 0, 255});
  ChooseOptions options;
  options.sample = 2;  // the blue pixel is passed over
  const Provenance provenance(image, options);
  const CellOrigin blue = provenance.of({0, 0, 255}), red = provenance.of({255, 0, 0});
  EXPECT_TRUE(std::holds_alternative<NotCounted>(blue.how));
  EXPECT_EQ(blue.pixels, 0u);
  EXPECT_FALSE(blue.entry);
  EXPECT_EQ(blue.cell, (GridPoint{24, 29, 29}));
  EXPECT_EQ(red.pixels, 2u);
  EXPECT_EQ(red.plane_cells, 1u);
  EXPECT_EQ(red.entry, std::optional<std::size_t>(0));
  EXPECT_TRUE(provenance.of({90, 90, 90}).grey);
  EXPECT_FALSE(red.grey);
}

}  // namespace
}  // namespace sir::quant
