// The inspector against what it stands for, asked by other means: brute force over the LUT, the
// tracer's own answer for the ray, the counts of the picture.
#include "viewer/inspection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "quant/nearest.h"
#include "quant/perceptual_search.h"
#include "quant/shown_through.h"
#include "tests/random_planes.h"
#include "tests/scene_builder.h"
#include "tracer/render.h"
#include "viewer/font.h"

namespace sir::viewer {
namespace {

using testing::ElementsAre;
using testing::Optional;

constexpr ImageSize kSize{64, 48};

/// A rendered scene with enough colours for the methods to choose among.
std::shared_ptr<const Picture> pictured(std::uint64_t seed = 3) {
  auto picture = std::make_shared<Picture>();
  picture->input = picture->base = "scene";
  Scene scene = test::random_scene(seed, 9, false);
  for (CsgNode& node : scene.tree.nodes) node.name = "nó " + std::to_string(node.number);
  RenderOptions options;
  options.size = kSize;
  options.threads = 1;
  picture->planes = render(scene, options).planes;
  const Planes noise = test::random_planes(kSize, 7);
  for (std::size_t i = 0; i < kSize.pixels(); i += 2) picture->planes.set(i, noise.at(i));
  picture->scene = std::make_shared<const Scene>(std::move(scene));
  return picture;
}

std::shared_ptr<const Rendition> shown_by(const Picture& picture, Method method,
                                          const quant::MapOptions& map = {}) {
  auto rendition = std::make_shared<Rendition>();
  rendition->method = method;
  rendition->lut_name = "p.LUT";
  rendition->lut =
      quant::choose_lut(picture.planes, choice_of(method).value_or(quant::ChooseOptions{}));
  rendition->reserved = map.reserved;
  rendition->indices = quant::map_image(picture.planes, rendition->lut, map);
  rendition->seen = quant::as_seen(picture.planes.size, rendition->indices, rendition->lut);
  return rendition;
}

/// Calls look(pixel, inspection) for every pixel.
template <typename Look>
void for_each_pixel(Inspector& inspector, Look look) {
  const ImageSize size = inspector.picture().planes.size;
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column)
      look(static_cast<std::size_t>(row * size.width + column), inspector.inspect(column, row));
}

TEST(Inspector, TellsThePixelAsItIsShown) {
  const auto picture = pictured();
  const auto rendition = shown_by(*picture, Method::hsv_median);
  Inspector inspector(picture, rendition);
  for_each_pixel(inspector, [&](std::size_t pixel, const Inspection& found) {
    EXPECT_EQ(found.true_colour, picture->planes.at(pixel));
    EXPECT_TRUE(found.complete);
    ASSERT_TRUE(found.shown);
    const std::uint8_t index = rendition->indices[pixel];
    EXPECT_EQ(found.shown->entry.index, index);
    EXPECT_EQ(found.shown->entry.seen, rendition->seen.at(pixel));
    EXPECT_EQ(found.shown->code, rendition->lut.entry[index]);
    EXPECT_EQ(found.shown->entry.squared,
              quant::squared_distance(found.true_colour, found.shown->entry.seen));
    EXPECT_EQ(
        found.shown->entry.difference,
        quant::ciede2000(quant::lab_of(found.true_colour), quant::lab_of(found.shown->entry.seen)));
    EXPECT_EQ(found.shown->group.pixels,
              static_cast<std::uint64_t>(
                  std::count(rendition->indices.begin(), rendition->indices.end(), index)));
    EXPECT_EQ(found.shown->image_pixels, kSize.pixels());
    EXPECT_FALSE(found.shown->dithered);
  });
}

TEST(Inspector, FindsTheNearestTwoAmongThoseThatMayBeTaken) {
  const auto picture = pictured();
  quant::MapOptions map;
  for (std::size_t i = 0; i < 256; i += 3) map.reserved.set(i);
  const auto rendition = shown_by(*picture, Method::rgb_frequency, map);
  Inspector inspector(picture, rendition, map);
  for_each_pixel(inspector, [&](std::size_t, const Inspection& found) {
    int least = 1 << 20, next = 1 << 20;
    Rgb8 winner;
    for (std::size_t i = 0; i < 256; ++i) {
      const int d = quant::squared_distance(rendition->lut.seen(i), found.true_colour);
      if (!map.reserved[i] && d < least) least = d, winner = rendition->lut.seen(i);
    }
    for (std::size_t i = 0; i < 256; ++i)
      if (!map.reserved[i] && !(rendition->lut.seen(i) == winner))
        next = std::min(next, quant::squared_distance(rendition->lut.seen(i), found.true_colour));
    const NearestTwo& two = found.shown->by_bytes;
    EXPECT_EQ(two.winner.squared, least);
    EXPECT_EQ(two.winner.index, found.shown->entry.index);
    ASSERT_TRUE(two.runner_up);
    EXPECT_EQ(two.runner_up->squared, next);
    EXPECT_FALSE(map.reserved[two.runner_up->index]);
    EXPECT_FALSE(found.shown->by_eye);
  });
}

TEST(Inspector, ByTheEyeItIsTheMappingsOwnMeasure) {
  const auto picture = pictured();
  quant::MapOptions map;
  map.by = quant::Goal::perceptual;
  const auto rendition = shown_by(*picture, Method::hsv_median, map);
  Inspector inspector(picture, rendition, map);
  bool differs = false;
  for_each_pixel(inspector, [&](std::size_t pixel, const Inspection& found) {
    ASSERT_TRUE(found.shown->by_eye);
    EXPECT_EQ(found.shown->by_eye->winner.index, rendition->indices[pixel]);
    EXPECT_EQ(found.shown->by_bytes.winner.index,
              quant::nearest_entry(found.true_colour, rendition->lut));
    differs |= found.shown->by_eye->winner.index != found.shown->by_bytes.winner.index;
    EXPECT_FALSE(found.shown->dithered);
  });
  EXPECT_TRUE(differs);
}

TEST(Inspector, SaysWhereDitheringTookAnotherEntry) {
  const auto picture = pictured();
  quant::MapOptions map;
  map.dither = quant::Dither::floyd;
  const auto rendition = shown_by(*picture, Method::rgb_median, map);
  const auto plain = shown_by(*picture, Method::rgb_median);
  Inspector inspector(picture, rendition, map);
  std::size_t dithered = 0;
  for_each_pixel(inspector, [&](std::size_t pixel, const Inspection& found) {
    EXPECT_EQ(found.shown->dithered, rendition->indices[pixel] != plain->indices[pixel]);
    dithered += found.shown->dithered;
  });
  EXPECT_GT(dithered, kSize.pixels() / 20);
  EXPECT_LT(dithered, kSize.pixels());
}

TEST(Inspector, TellsTheOriginOfTheThesissMethodsOnly) {
  const auto picture = pictured();
  for (const Method method : kMethods) {
    if (method == Method::true_colour) continue;
    const auto rendition = shown_by(*picture, method);
    Inspector inspector(picture, rendition);
    const Inspection found = inspector.inspect(5, 7);
    EXPECT_EQ(found.shown->origin.has_value(), choice_of(method).has_value()) << name(method);
    if (!found.shown->origin) continue;
    EXPECT_EQ(found.shown->made.has_value(), found.shown->origin->entry.has_value());
    if (found.shown->made) {
      EXPECT_EQ(found.shown->made->seen, rendition->lut.seen(*found.shown->origin->entry));
    }
  }
  // A LUT that is not what the method makes of this picture has no story here.
  const auto other = pictured(4);
  auto old = std::make_shared<Rendition>(*shown_by(*other, Method::hsv_median));
  Inspector inspector(picture, old);
  EXPECT_FALSE(inspector.inspect(5, 7).shown->origin);
}

TEST(Inspector, TheRayIsTheTracersFirst) {
  const auto picture = pictured();
  Inspector inspector(picture, nullptr);
  RenderOptions options;
  options.size = kSize;
  std::size_t hits = 0;
  for_each_pixel(inspector, [&](std::size_t pixel, const Inspection& found) {
    const int column = static_cast<int>(pixel) % kSize.width;
    const int row = static_cast<int>(pixel) / kSize.width;
    const TraceNode first = trace_pixel(*picture->scene, options, column, row).log.front();
    EXPECT_FALSE(found.shown);
    ASSERT_TRUE(found.ray);
    EXPECT_EQ(found.ray->hit, first.hit);
    if (!first.hit) return;
    ++hits;
    EXPECT_EQ(found.ray->node, first.node);
    EXPECT_EQ(found.ray->node_name, "nó " + std::to_string(first.node));
    EXPECT_EQ(found.ray->face, first.face);
    EXPECT_EQ(found.ray->surface, picture->scene->surfaces[first.surface].number);
    EXPECT_EQ(found.ray->t, first.t);
  });
  EXPECT_GT(hits, 0u);
  EXPECT_LT(hits, kSize.pixels());
}

TEST(Inspector, KnowsThePlaceOnTheScreen) {
  const auto plain = [](ImageSize size) {
    auto picture = std::make_shared<Picture>();
    picture->planes = Planes(size);
    return picture;
  };
  Inspector thesis(plain({640, 480}), nullptr);
  EXPECT_EQ(thesis.inspect(0, 0).screen, (eltek::Area{192, 150, {1, 1}}));
  EXPECT_EQ(thesis.inspect(639, 479).screen, (eltek::Area{831, 629, {1, 1}}));
  EXPECT_FALSE(thesis.inspect(0, 0).ray);
  Inspector large(plain({1100, 800}), nullptr);  // 38 columns and 10 rows are cut off each side
  EXPECT_FALSE(large.inspect(37, 10).screen);
  EXPECT_EQ(large.inspect(38, 10).screen, (eltek::Area{0, 0, {1, 1}}));
  EXPECT_FALSE(large.inspect(1099, 400).screen);
}

TEST(Inspector, RefusesWhatIsNotThere) {
  const auto picture = pictured();
  Inspector inspector(picture, nullptr);
  for (const auto& [column, row] : {std::pair{-1, 0}, {0, -1}, {64, 0}, {0, 48}})
    EXPECT_THROW(inspector.inspect(column, row), std::out_of_range);
  auto wrong = std::make_shared<Rendition>(*shown_by(*picture, Method::hsv_median));
  wrong->indices.pop_back();
  EXPECT_THROW(Inspector(picture, wrong), std::invalid_argument);
}

std::size_t letters(std::string_view line) {
  return static_cast<std::size_t>(text_width(line) / kLetterWidth);
}

TEST(Describe, LinesAreShortAndInLatin1) {
  const auto picture = pictured();
  auto named = std::make_shared<Picture>(*picture);
  auto scene = std::make_shared<Scene>(*picture->scene);
  for (CsgNode& node : scene->tree.nodes) node.name = "\u4E00 " + std::string(100, 'n');
  for (Surface& surface : scene->surfaces) surface.name = std::string(50, '\xFF') + "\n";
  named->scene = scene;
  quant::MapOptions map;
  map.by = quant::Goal::perceptual;
  map.dither = quant::Dither::floyd;
  for (const Method method : kMethods) {
    Inspector inspector(
        named, method == Method::true_colour ? nullptr : shown_by(*named, method, map), map);
    for_each_pixel(inspector, [&](std::size_t, const Inspection& found) {
      for (const std::string& line : describe(found)) {
        EXPECT_LE(letters(line), static_cast<std::size_t>(kDescriptionWidth)) << line;
        for (std::string_view rest = line; !rest.empty();) {
          const char32_t letter = take_character(rest);
          EXPECT_TRUE(letter < 0x100 && has_glyph(letter)) << line;
        }
      }
    });
  }
}

TEST(Describe, TellsAMedianCutsStory) {
  Inspection found;
  found.column = 312;
  found.row = 7;
  found.screen = eltek::Area{504, 157, {1, 1}};
  found.true_colour = {143, 87, 40};
  PixelShown shown;
  shown.method = Method::hsv_median;
  shown.entry = {118, {146, 85, 40}, 13, 1.204};
  shown.code = {36, 21, 10};
  shown.by_bytes = {shown.entry, EntryDistance{121, {150, 89, 44}, 69, 2.5}};
  shown.group = {1532, 41, {145, 86, 40}, 4.04};
  shown.image_pixels = 307200;
  shown.nearest_other = EntryDistance{121, {150, 89, 44}, 48, 2.25};
  quant::CellOrigin origin;
  origin.cell = {3, 21, 16};
  origin.plane = 3;
  origin.pixels = 1;
  origin.plane_cells = 310;
  origin.plane_pixels = 20411;
  origin.plane_entries = 2;
  origin.entry = 119;
  const quant::BoxSplit split{0, {{3, 7, 16}, {3, 29, 16}, 20411, 310}, 1, 15, 10198};
  origin.how = quant::CutPath{{{split, true}}, {{3, 16, 16}, {3, 29, 16}, 10213, 150}};
  shown.origin = origin;
  shown.made = EntryDistance{119, {150, 80, 40}, 98, 4.2};
  found.shown = shown;
  found.ray = RayFind{true, 12, "ta\u00E7a", PrimitiveKind::cylinder, 2, 3, "vidro", 1.25};
  EXPECT_THAT(
      describe(found),
      ElementsAre("pixel 312,7 · screen 504,157",  //
                  "true 143  87  40  #8F5728",     //
                  "seen 146  85  40  #925528",     //
                  "index 118 · code 36 21 10",     //
                  "CIEDE2000 1.20 · D² 13",        //
                  "",                              //
                  "nearest by the bytes",          //
                  "  118: 146  85  40 · D² 13 · CIEDE2000 1.20",
                  "  121: 150  89  44 · D² 69 · CIEDE2000 2.50",
                  "",                    //
                  "why: median in hsv",  //
                  "cell h 3 (30°) s 21 of 0-29 v 16 of 0-29: 1 pixel",
                  "plane 3 (30°): 310 cells, 20411 pixels, 2 entries",
                  "  s 7-29 v 16 · s>15: 10213 of 20411",
                  "  s 16-29 v 16: the mean of 10213 pixels in 150 cells",
                  "made entry 119: 150  80  40 · D² 98 · CIEDE2000 4.20",
                  "but 118 shows it: it came nearer",
                  "",  //
                  "entry 118 shows 1532 pixels, 0.50 %, 41 colours",
                  "  mean 145.0 86.0 40.0, 1.4 from the entry", "  spread 4.0 (root mean square)",
                  "  next entry 121: D² 48 · CIEDE2000 2.25",
                  "",  //
                  "ray: node 12 \"taça\", t 1.25", "  cylinder face 2 (side)",
                  "  surface 3 \"vidro\""));
}

TEST(Describe, SaysWhatIsNotKnown) {
  Inspection found;
  found.complete = false;
  found.ray = RayFind{};
  EXPECT_THAT(describe(found),
              ElementsAre("pixel 0,0 · beyond the screen", "the picture is still being rendered",
                          "true   0   0   0  #000000", "", "ray: the background"));
}

}  // namespace
}  // namespace sir::viewer
