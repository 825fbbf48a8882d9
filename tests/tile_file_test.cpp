// The record of finished tiles as a file: torn, damaged, somebody else's.
#include "tracer/tile_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <vector>

#include "tests/temp_folder.h"
#include "tracer/error.h"

namespace sir {
namespace {

struct Tile {
  TileId id;
  std::vector<Rgb8> colours;
  RayCounts cost;
};

// Tiles of several sizes, none like another.
std::vector<Tile> some_tiles() {
  std::vector<Tile> tiles;
  for (std::uint8_t n = 0; n < 4; ++n) {
    Tile tile{{n / 2u, 1000u * n}, {}, {}};
    for (std::uint8_t c = 0; c < 3 + 2 * n; ++c)
      tile.colours.push_back({n, c, static_cast<std::uint8_t>(n + 7 * c)});
    tile.cost.primary = 10u + n;
    tile.cost.doubtful = 20u + n;
    tile.cost.costs.calls = std::uint64_t{1} << (40 + n);
    tile.cost.costs.primitives[3] = 30u + n;
    tiles.push_back(tile);
  }
  return tiles;
}

const std::string kSettings = "--depth 5\n";

std::string encoded(const Tile& tile) {
  std::string bytes;
  TileFile::encode(tile.id, tile.colours, tile.cost, bytes);
  return bytes;
}

class TileFileTest : public testing::Test {
 protected:
  // A record of all tiles; where each of them ends.
  std::vector<std::size_t> write_record() const {
    const auto file = TileFile::open(path, true);
    file->start(kSettings);
    std::vector<std::size_t> ends{file->size()};
    for (const Tile& tile : tiles) {
      file->append(encoded(tile));
      ends.push_back(file->size());
    }
    return ends;
  }

  // Expects these tiles to be found and no others; the bytes dropped.
  std::uint64_t expect_tiles(std::size_t count) const {
    const auto file = TileFile::open(path, false);
    std::uint64_t dropped = 0;
    const auto found = file->find_tiles(dropped);
    EXPECT_EQ(found.size(), count);
    for (std::size_t t = 0; t < std::min(count, tiles.size()); ++t) {
      const auto place = found.find(tiles[t].id);
      if (place == found.end()) {
        ADD_FAILURE() << "tile " << t << " is lost";
        continue;
      }
      std::vector<Rgb8> colours(place->second.colours);
      RayCounts cost;
      EXPECT_TRUE(file->load(tiles[t].id, place->second, colours, cost));
      EXPECT_EQ(colours, tiles[t].colours);
      EXPECT_EQ(cost, tiles[t].cost);
    }
    return dropped;
  }

  test::TempFolder folder;
  const std::filesystem::path path = folder / "s.tiles";
  const std::vector<Tile> tiles = some_tiles();
};

TEST_F(TileFileTest, GivesBackWhatItWasGiven) {
  EXPECT_EQ(TileFile::open(path, false), nullptr);
  write_record();
  EXPECT_EQ(TileFile::open(path, false)->settings(), kSettings);
  EXPECT_EQ(expect_tiles(4), 0u);
}

TEST_F(TileFileTest, TornAnywhereKeepsTheWholeTilesBefore) {
  const auto ends = write_record();
  const std::string whole = folder.read("s.tiles");
  ASSERT_EQ(ends.back(), whole.size());
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    SCOPED_TRACE(length);
    folder.write("s.tiles", whole.substr(0, length));
    if (length < ends[0]) {
      EXPECT_EQ(TileFile::open(path, false)->settings(), std::nullopt);
      continue;
    }
    std::size_t count = 0;
    while (count < 4 && ends[count + 1] <= length) ++count;
    EXPECT_EQ(expect_tiles(count), length - ends[count]);
    // What comes next follows the last whole one.
    {
      const auto file = TileFile::open(path, false);
      std::uint64_t dropped = 1;
      file->find_tiles(dropped);
      EXPECT_EQ(dropped, 0u);
      for (std::size_t t = count; t < 4; ++t) file->append(encoded(tiles[t]));
    }
    ASSERT_EQ(folder.read("s.tiles"), whole);
  }
}

TEST_F(TileFileTest, NothingIsBelievedFromADamagedTileOn) {
  const auto ends = write_record();
  const std::string whole = folder.read("s.tiles");
  for (std::size_t at = 0; at < whole.size(); ++at) {
    const std::size_t bit = at % 8;
    SCOPED_TRACE(testing::Message() << "bit " << bit << " of byte " << at);
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1u << bit));
    folder.write("s.tiles", damaged);
    if (at < 10) {  // no magic: the file is somebody else's
      EXPECT_THROW(TileFile::open(path, false), FileError);
      EXPECT_EQ(folder.read("s.tiles"), damaged);
    } else if (at < ends[0]) {
      EXPECT_EQ(TileFile::open(path, false)->settings(), std::nullopt);
    } else {
      std::size_t count = 0;
      while (ends[count + 1] <= at) ++count;
      EXPECT_EQ(expect_tiles(count), whole.size() - ends[count]);
    }
  }
}

TEST_F(TileFileTest, TilesOfAnotherRecordAreNotBelieved) {
  const auto ends = write_record();
  const std::string first = folder.read("s.tiles");
  TileFile::open(path, true)->start("--depth 6\n");
  const std::string header = folder.read("s.tiles");
  ASSERT_EQ(header.size(), ends[0]);
  folder.write("s.tiles", header + first.substr(ends[0]));
  expect_tiles(0);
}

TEST_F(TileFileTest, SizesThatNobodyWroteTakeNoMemory) {
  const auto ends = write_record();
  const std::string whole = folder.read("s.tiles");
  std::string settings = whole;
  settings.replace(12, 4, 4, '\xFF');
  folder.write("s.tiles", settings);
  EXPECT_EQ(TileFile::open(path, false)->settings(), std::nullopt);
  std::string colours = whole;
  colours.replace(ends[1] + 12, 4, 4, '\xFF');
  folder.write("s.tiles", colours);
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);  // a hole to the end
  expect_tiles(1);
  EXPECT_EQ(std::filesystem::file_size(path), ends[1]);
}

TEST_F(TileFileTest, OneUserAtATime) {
  auto file = TileFile::open(path, true);
  file->start(kSettings);
  EXPECT_THAT([&] { TileFile::open(path, true); },
              testing::ThrowsMessage<FileError>(testing::HasSubstr("in use by another render")));
  file->remove();
  EXPECT_FALSE(folder.has("s.tiles"));
  // The one that comes after is another file, even while the first is open.
  TileFile::open(path, true)->start(kSettings);
  EXPECT_TRUE(folder.has("s.tiles"));
}

TEST_F(TileFileTest, WhatIsNoRecordIsLeftAlone) {
  folder.write("s.tiles", "my tiles");
  EXPECT_THROW(TileFile::open(path, true), FileError);
  EXPECT_EQ(folder.read("s.tiles"), "my tiles");
  std::filesystem::create_symlink("s.tiles", folder / "link.tiles");
  EXPECT_THROW(TileFile::open(folder / "link.tiles", true), FileError);
  ASSERT_EQ(::mkfifo((folder / "pipe.tiles").c_str(), 0600), 0);
  EXPECT_THROW(TileFile::open(folder / "pipe.tiles", true), FileError);
  std::filesystem::create_directory(folder / "folder.tiles");
  EXPECT_THROW(TileFile::open(folder / "folder.tiles", true), FileError);
}

}  // namespace
}  // namespace sir
