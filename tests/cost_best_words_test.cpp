// What the price list says of the method best, of mapping by the eye and of dither, from
// measurements that are made up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/cost/best_words.h"
#include "cli/cost/sentences.h"

namespace sir::cli {
namespace {

using quant::Goal;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

CostRow made_up(std::optional<Knob> knob, const std::string& name, double ms, double psnr,
                double de_mean, double de_blurred) {
  CostRow row;
  row.knob = knob;
  row.name = row.subject = name;
  row.ms = {ms, 2 * ms, ms};
  row.picture.psnr = psnr;
  row.picture.de_mean = de_mean;
  row.lut.emplace();
  row.lut->de_blurred = de_blurred;
  return row;
}

CostRow effort(Goal goal, int at, double ms, double psnr, double de_mean) {
  CostRow row = made_up(Knob::effort, best_name(goal, at), ms, psnr, de_mean, de_mean);
  row.family = goal == Goal::perceptual ? kBestByEye : kBestByBytes;
  row.at = at;
  return row;
}

CostPart with_default() {
  CostPart part;
  part.rows.push_back(made_up(std::nullopt, "median", 1, 32.4, 3.3, 3.1));
  return part;
}

TEST(BestName, IsAsAPersonTypesIt) {
  EXPECT_EQ(best_name(), "best --effort 3");
  EXPECT_EQ(best_name(Goal::psnr, 5), "best --goal psnr --effort 5");
}

TEST(BestSentence, TellsWhatTheMethodAndItsEffortsGain) {
  CostPart part = with_default();
  part.rows.push_back(effort(Goal::perceptual, 1, 10, 39.0, 1.1));
  part.rows.push_back(effort(Goal::perceptual, 2, 20, 39.0, 1.05));
  part.rows.push_back(effort(Goal::perceptual, 3, 40, 39.4, 1.0));
  part.rows.push_back(effort(Goal::perceptual, 5, 100, 39.4, 0.99981));
  part.rows.push_back(effort(Goal::psnr, 3, 30, 41.9, 1.26));
  part.rows.push_back(effort(Goal::psnr, 5, 60, 42.0, 1.25));
  settle(part);
  EXPECT_THAT(
      best_sentences(part),
      ElementsAre(
          "Best --effort 3 instead of median costs 40x for a mean CIEDE2000 of 1.000 instead of "
          "3.300.",
          "Best --goal psnr --effort 3 instead of median costs 30x for +9.5 dB.",
          "Best --effort 1 instead of best --effort 3 costs 0.25x for a mean CIEDE2000 of 1.100 "
          "instead of 1.000.",
          "Best --effort 5 instead of best --effort 3 costs 2.50x for a mean CIEDE2000 of 1.000 "
          "as before.",
          "Best --goal psnr --effort 5 instead of best --goal psnr --effort 3 costs 2.00x for "
          "+0.10 dB.",
          "The nearest to the eye is best --effort 5: a mean CIEDE2000 of 1.000.",
          "After the blur it is best --effort 5: 1.000."));
  // The list as a whole has them, and no second sentence of a row by its PSNR.
  const auto all = lut_sentences(part);
  for (const std::string& sentence : best_sentences(part)) EXPECT_THAT(all, Contains(sentence));
  EXPECT_THAT(all,
              Contains("The most accurate of these is best --goal psnr --effort 5: 42.00 dB."));
  EXPECT_EQ(all.size(), best_sentences(part).size() + 1);
}

TEST(BestSentence, TellsOfMappingAndDither) {
  CostPart part = with_default();
  part.rows.push_back(made_up(Knob::map, best_name(), 40, 39.4, 1.0, 0.9));
  part.rows.push_back(made_up(Knob::map, kBestMappedByBytes, 20, 40.0, 1.19, 1.0));
  part.rows.push_back(made_up(Knob::map, "median, --map perceptual", 4, 31.0, 3.0, 2.9));
  part.rows.push_back(made_up(Knob::dither, "best, --dither floyd", 80, 38.0, 1.3, 0.4));
  part.rows.push_back(made_up(Knob::dither, "median, --dither floyd", 9, 30.0, 3.9, 1.9));
  settle(part);
  EXPECT_THAT(
      best_sentences(part),
      ElementsAre(
          "Best --effort 3 instead of median costs 40x for a mean CIEDE2000 of 1.000 instead of "
          "3.300.",
          "Best, --map rgb instead of best --effort 3 costs 0.50x for a mean CIEDE2000 of 1.190 "
          "instead of 1.000.",
          "Median, --map perceptual instead of median costs 4.00x for a mean CIEDE2000 of 3.000 "
          "instead of 3.300.",
          "Best, --dither floyd instead of best --effort 3 costs 2.00x for a mean CIEDE2000 of "
          "0.400 instead of 0.900 after the blur, 1.300 instead of 1.000 without.",
          "Median, --dither floyd instead of median costs 9.00x for a mean CIEDE2000 of 1.900 "
          "instead of 3.100 after the blur, 3.900 instead of 3.300 without.",
          "The nearest to the eye is best --effort 3: a mean CIEDE2000 of 1.000.",
          "After the blur it is best, --dither floyd: 0.400."));
}

TEST(BestSentence, SpeaksOfNoRowThatIsNotThere) {
  CostPart part = with_default();
  settle(part);
  EXPECT_THAT(best_sentences(part), IsEmpty());
  // Without the usual effort there is nothing that the others could be compared with.
  part.rows.push_back(effort(Goal::perceptual, 5, 100, 39.4, 1.0));
  part.rows.push_back(effort(Goal::psnr, 5, 100, 42.0, 1.2));
  settle(part);
  EXPECT_THAT(best_sentences(part), Not(Contains(HasSubstr("costs"))));
}

}  // namespace
}  // namespace sir::cli
