#include "viewer/png_file.h"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "tests/random_planes.h"
#include "tracer/error.h"

namespace sir::viewer {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;
using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// What a test file is made of; libpng writes it as told.
struct Recipe {
  ImageSize size;
  int bits = 8;
  int colour_type = PNG_COLOR_TYPE_RGB;
  Bytes rows;  ///< packed as in the file, no filters
  int interlace = PNG_INTERLACE_NONE;
  std::function<void(png_structp, png_infop)> chunks = [](png_structp, png_infop) {};
};

class PngFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("png_file_test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name = "test.png") const { return folder_ / name; }

  // libpng's default error handling leaves through abort(), which a test may.
  fs::path make(const Recipe& recipe) const {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const Stream out(std::fopen(file().c_str(), "wb"), &std::fclose);
    png_init_io(png, out.get());
    png_set_benign_errors(png, 1);
    png_set_check_for_invalid_index(png, 0);
    png_set_IHDR(png, info, static_cast<png_uint_32>(recipe.size.width),
                 static_cast<png_uint_32>(recipe.size.height), recipe.bits, recipe.colour_type,
                 recipe.interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    recipe.chunks(png, info);
    const std::size_t row_bytes = recipe.rows.size() / static_cast<std::size_t>(recipe.size.height);
    std::vector<png_bytep> rows;
    for (int j = 0; j < recipe.size.height; ++j)
      rows.push_back(const_cast<png_bytep>(&recipe.rows[static_cast<std::size_t>(j) * row_bytes]));
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return file();
  }

  static Bytes content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path store(const Bytes& bytes) const {
    std::ofstream(file("stored.png"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return file("stored.png");
  }

  // The reason for which a file is refused; empty if it is not.
  static std::string refusal(const fs::path& path) {
    try {
      read_png(path);
    } catch (const FileError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find(path.string() + ": "), 0u) << text;
      EXPECT_EQ(text.find('\n'), std::string::npos) << text;
      return text;
    }
    return "";
  }

  fs::path folder_;
};

bool contains(const Bytes& bytes, const std::string& tag) {
  return std::search(bytes.begin(), bytes.end(), tag.begin(), tag.end()) != bytes.end();
}

#define EXPECT_REFUSED(path, reason) \
  EXPECT_NE(refusal(path).find(reason), std::string::npos) << "said: " << refusal(path)

// Writing.

TEST_F(PngFile, RgbComesBackExactly) {
  for (const ImageSize size : {ImageSize{1, 1}, ImageSize{640, 480}, ImageSize{7, 300}}) {
    const Planes planes = test::random_planes(size, 5);
    write_rgb_png(file(), planes);
    EXPECT_EQ(read_png(file()), planes);
  }
}

TEST_F(PngFile, WritingTwiceGivesTheSameBytesAndNoTimeOrGamma) {
  const Planes planes = test::random_planes({64, 48}, 6);
  write_rgb_png(file("a.png"), planes);
  write_rgb_png(file("b.png"), planes);
  EXPECT_EQ(content(file("a.png")), content(file("b.png")));
  for (const char* tag : {"tIME", "gAMA", "sRGB", "tEXt"})
    EXPECT_FALSE(contains(content(file("a.png")), tag)) << tag;
}

eltek::IndexedScreen some_screen() {
  eltek::IndexedScreen screen{{100, 40}, Bytes(4000), {}};
  for (std::size_t i = 0; i < 4000; ++i) screen.indices[i] = static_cast<std::uint8_t>(i * 7 % 50);
  // Equal entries, and entries that no pixel has: order and number must stay.
  for (std::size_t i = 0; i < 256; ++i) {
    const auto level = static_cast<std::uint8_t>(255 - i / 2);
    screen.palette[i] = {level, static_cast<std::uint8_t>(level / 3), 7};
  }
  return screen;
}

TEST_F(PngFile, IndexedKeepsTheLutOrderAndSaysSixBits) {
  const eltek::IndexedScreen screen = some_screen();
  write_indexed_png(file(), screen);

  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const Stream in(std::fopen(file().c_str(), "rb"), &std::fclose);
  png_init_io(png, in.get());
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_PALETTE);
  EXPECT_EQ(png_get_bit_depth(png, info), 8);
  EXPECT_EQ(png_get_image_width(png, info), 100u);
  EXPECT_EQ(png_get_image_height(png, info), 40u);
  png_colorp palette = nullptr;
  int entries = 0;
  png_get_PLTE(png, info, &palette, &entries);
  ASSERT_EQ(entries, 256);
  for (std::size_t i = 0; i < 256; ++i)
    EXPECT_EQ((Rgb8{palette[i].red, palette[i].green, palette[i].blue}), screen.palette[i]) << i;
  png_color_8p significant = nullptr;
  ASSERT_NE(png_get_sBIT(png, info, &significant), 0u);
  EXPECT_EQ(significant->red, 6);
  EXPECT_EQ(significant->green, 6);
  EXPECT_EQ(significant->blue, 6);
  for (std::size_t j = 0; j < 40; ++j)
    for (std::size_t i = 0; i < 100; ++i)
      ASSERT_EQ(png_get_rows(png, info)[j][i], screen.indices[j * 100 + i]);
  png_destroy_read_struct(&png, &info, nullptr);
}

TEST_F(PngFile, IndexedSaysTheBitsOfAnotherDac) {
  eltek::IndexedScreen screen = some_screen();
  screen.dac = {{5, 8, 1}};
  write_indexed_png(file(), screen);
  const Bytes bytes = content(file());
  const std::string text(bytes.begin(), bytes.end());
  const auto chunk = text.find("sBIT");
  ASSERT_NE(chunk, std::string::npos);
  EXPECT_EQ(text.substr(chunk + 4, 3), "\x05\x08\x01");
}

TEST_F(PngFile, IndexedReadsAsTheColoursSeen) {
  const eltek::IndexedScreen screen = some_screen();
  write_indexed_png(file(), screen);
  const Planes planes = read_png(file());
  EXPECT_EQ(planes.size, screen.size);
  for (std::size_t i = 0; i < screen.indices.size(); ++i)
    ASSERT_EQ(planes.at(i), screen.palette[screen.indices[i]]);
}

TEST_F(PngFile, WritingWhereNothingCanBeFails) {
  EXPECT_THROW(write_rgb_png(folder_ / "no" / "x.png", test::random_planes({4, 4}, 1)), FileError);
  EXPECT_THROW(write_rgb_png(file(), Planes(ImageSize{0, 0})), FileError);
  EXPECT_FALSE(fs::exists(file()));
  EXPECT_TRUE(fs::is_empty(folder_));  // no temporary file either
}

// The failure passes through libpng and arrives as what it was.
TEST_F(PngFile, AFullDiskIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  try {
    write_rgb_png("/dev/full", test::random_planes({300, 300}, 1));
    FAIL() << "a full disk took the file";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
}

// Reading what others write.

TEST_F(PngFile, ReadsGreyOfEveryDepth) {
  make({{4, 1}, 8, PNG_COLOR_TYPE_GRAY, {0, 1, 128, 255}});
  EXPECT_EQ(read_png(file()).channel[0], (Bytes{0, 1, 128, 255}));
  EXPECT_EQ(read_png(file()).channel[2], (Bytes{0, 1, 128, 255}));
  make({{8, 1}, 1, PNG_COLOR_TYPE_GRAY, {0b10100101}});
  EXPECT_EQ(read_png(file()).channel[1], (Bytes{255, 0, 255, 0, 0, 255, 0, 255}));
  make({{4, 1}, 2, PNG_COLOR_TYPE_GRAY, {0b00011011}});
  EXPECT_EQ(read_png(file()).channel[1], (Bytes{0, 85, 170, 255}));
  make({{2, 1}, 4, PNG_COLOR_TYPE_GRAY, {0x1E}});
  EXPECT_EQ(read_png(file()).channel[1], (Bytes{17, 238}));
}

TEST_F(PngFile, ReadsPalettesOfFewBits) {
  const auto palette = [](png_structp png, png_infop info) {
    const png_color colours[4] = {{1, 2, 3}, {40, 50, 60}, {7, 8, 9}, {255, 0, 255}};
    png_set_PLTE(png, info, colours, 4);
  };
  make({{4, 2}, 2, PNG_COLOR_TYPE_PALETTE, {0b00011011, 0b11100100}, PNG_INTERLACE_NONE, palette});
  const Planes planes = read_png(file());
  EXPECT_EQ(planes.channel[0], (Bytes{1, 40, 7, 255, 255, 7, 40, 1}));
  EXPECT_EQ(planes.channel[1], (Bytes{2, 50, 8, 0, 0, 8, 50, 2}));
}

// round(v * 255 / 65535), not the high byte: 0x00FF is 255/257 = 0.99.
TEST_F(PngFile, SixteenBitsAreRounded) {
  make({{2, 2}, 16, PNG_COLOR_TYPE_GRAY, {0x00, 0xFF, 0x00, 0x80, 0x80, 0x80, 0xFE, 0xFF}});
  EXPECT_EQ(read_png(file()).channel[0], (Bytes{1, 0, 128, 254}));
  make({{1, 1}, 16, PNG_COLOR_TYPE_RGB, {0x12, 0xFF, 0x00, 0x00, 0xFF, 0xFF}});
  EXPECT_EQ(read_png(file()).at(0), (Rgb8{0x13, 0, 255}));
}

TEST_F(PngFile, TagsOfGammaAndColourSpaceChangeNothing) {
  Bytes ramp(256);
  for (std::size_t i = 0; i < 256; ++i) ramp[i] = static_cast<std::uint8_t>(i);
  const std::vector<std::function<void(png_structp, png_infop)>> tags = {
      [](png_structp png, png_infop info) { png_set_gAMA(png, info, 1.0); },
      [](png_structp png, png_infop info) { png_set_gAMA(png, info, 0.3); },
      [](png_structp png, png_infop info) { png_set_sRGB_gAMA_and_cHRM(png, info, 0); }};
  for (const auto& tag : tags) {
    make({{256, 1}, 8, PNG_COLOR_TYPE_GRAY, ramp, PNG_INTERLACE_NONE, tag});
    EXPECT_EQ(read_png(file()).channel[0], ramp);
  }
}

TEST_F(PngFile, ReadsInterlacedFiles) {
  const Planes planes = test::random_planes({37, 23}, 9);
  Bytes rows;
  for (std::size_t i = 0; i < planes.size.pixels(); ++i)
    for (const auto& plane : planes.channel) rows.push_back(plane[i]);
  make({planes.size, 8, PNG_COLOR_TYPE_RGB, rows, PNG_INTERLACE_ADAM7});
  EXPECT_EQ(read_png(file()), planes);
}

TEST_F(PngFile, OpaqueAlphaIsAccepted) {
  make({{2, 1}, 8, PNG_COLOR_TYPE_RGBA, {1, 2, 3, 255, 4, 5, 6, 255}});
  EXPECT_EQ(read_png(file()).at(1), (Rgb8{4, 5, 6}));
  make({{2, 1}, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {9, 255, 8, 255}});
  EXPECT_EQ(read_png(file()).at(0), (Rgb8{9, 9, 9}));
}

TEST_F(PngFile, TransparencyIsRefusedWithItsPlace) {
  make({{2, 2}, 8, PNG_COLOR_TYPE_RGBA, {1, 2, 3, 255, 4, 5, 6, 255, 1, 1, 1, 255, 2, 2, 2, 254}});
  EXPECT_REFUSED(file(), "transparent pixel at column 1, row 1");
  make({{1, 1}, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {9, 0}});
  EXPECT_REFUSED(file(), "transparent");
}

TEST_F(PngFile, ATransparentColourCountsWhereItIsUsed) {
  const auto grey_7_is_clear = [](png_structp png, png_infop info) {
    png_color_16 colour{};
    colour.gray = 7;
    png_set_tRNS(png, info, nullptr, 0, &colour);
  };
  make({{2, 1}, 8, PNG_COLOR_TYPE_GRAY, {6, 8}, PNG_INTERLACE_NONE, grey_7_is_clear});
  EXPECT_EQ(read_png(file()).channel[0], (Bytes{6, 8}));
  make({{2, 1}, 8, PNG_COLOR_TYPE_GRAY, {6, 7}, PNG_INTERLACE_NONE, grey_7_is_clear});
  EXPECT_REFUSED(file(), "transparent pixel at column 1, row 0");

  const auto entry_1_is_half_clear = [](png_structp png, png_infop info) {
    const png_color colours[3] = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    const png_byte opacity[2] = {255, 128};
    png_set_PLTE(png, info, colours, 3);
    png_set_tRNS(png, info, opacity, 2, nullptr);
  };
  make({{2, 1}, 8, PNG_COLOR_TYPE_PALETTE, {0, 2}, PNG_INTERLACE_NONE, entry_1_is_half_clear});
  EXPECT_EQ(read_png(file()).channel[0], (Bytes{1, 3}));
  make({{2, 1}, 8, PNG_COLOR_TYPE_PALETTE, {0, 1}, PNG_INTERLACE_NONE, entry_1_is_half_clear});
  EXPECT_REFUSED(file(), "transparent");
}

TEST_F(PngFile, AFileInMemoryReadsAsOneOnDisk) {
  const Planes planes = test::random_planes({21, 13}, 5);
  write_rgb_png(file(), planes);
  Bytes bytes = content(file());
  EXPECT_EQ(parse_png("memory", bytes), planes);
  bytes.resize(bytes.size() / 2);
  for (const Bytes& wrong : {bytes, Bytes{}, Bytes{0x89, 'P'}}) {
    std::string on_disk = refusal(store(wrong)), in_memory;
    on_disk.replace(0, store(wrong).string().size(), "memory");
    try {
      parse_png("memory", wrong);
    } catch (const FileError& error) {
      in_memory = error.what();
    }
    EXPECT_EQ(in_memory, on_disk);
  }
}

// What cannot be read.

TEST_F(PngFile, MissingEmptyAndForeignFilesAreRefused) {
  EXPECT_REFUSED(file("none.png"), "No such file");
  EXPECT_REFUSED(folder_, "cannot be read");
  EXPECT_REFUSED(store({}), "is empty");
  EXPECT_REFUSED(store({'P', '6', '\n', '1', ' ', '1', '\n', '2', '5', '5'}), "not a PNG");
  EXPECT_REFUSED(store({0x89, 'P', 'N'}), "not a PNG");
}

TEST_F(PngFile, AFileCutOffAnywhereIsRefused) {
  write_rgb_png(file(), test::random_planes({40, 30}, 3));
  const Bytes whole = content(file());
  for (int length = 8; length < std::ssize(whole); length += length < 100 ? 1 : 97)
    EXPECT_NE(refusal(store(Bytes(whole.begin(), std::next(whole.begin(), length)))), "") << length;
  EXPECT_REFUSED(store(Bytes(whole.begin(), whole.end() - 20)), "ends too early");
}

TEST_F(PngFile, AFlippedBitAnywhereIsRefused) {
  write_indexed_png(file(), some_screen());
  const Bytes whole = content(file());
  for (std::size_t i = 0; i < whole.size(); i += 3) {
    Bytes damaged = whole;
    damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ 0x10);
    EXPECT_NE(refusal(store(damaged)), "") << "byte " << i;
  }
}

TEST_F(PngFile, AnIndexBeyondThePaletteIsRefused) {
  const auto two = [](png_structp png, png_infop info) {
    const png_color colours[2] = {{1, 1, 1}, {2, 2, 2}};
    png_set_PLTE(png, info, colours, 2);
  };
  make({{3, 1}, 8, PNG_COLOR_TYPE_PALETTE, {0, 1, 2}, PNG_INTERLACE_NONE, two});
  EXPECT_REFUSED(file(), "the palette 2 entries");
}

// Only the header tells of 11000 x 11000 pixels; nothing else is there.
TEST_F(PngFile, AHugeImageIsRefusedByItsHeader) {
  const auto header_of = [&](ImageSize size) {
    make({{1, 1}, 8, PNG_COLOR_TYPE_GRAY, {0}});
    Bytes bytes = content(file());
    png_save_uint_32(&bytes[16], static_cast<png_uint_32>(size.width));
    png_save_uint_32(&bytes[20], static_cast<png_uint_32>(size.height));
    std::uint32_t crc = 0xFFFFFFFFu;  // over the chunk's type and content
    for (std::size_t i = 12; i < 29; ++i) {
      crc ^= bytes[i];
      for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    png_save_uint_32(&bytes[29], ~crc);
    return store(bytes);
  };
  EXPECT_REFUSED(header_of({11000, 11000}), "11000x11000 is too large");
  EXPECT_REFUSED(header_of({2'000'000'000, 2'000'000'000}), "too large");
  EXPECT_REFUSED(header_of({10000, 10000}), "damaged");  // as large as allowed, but cut off
  EXPECT_REFUSED(header_of({0, 5}), "damaged");
}

}  // namespace
}  // namespace sir::viewer
