// Sentences and answers of the price list, from measurements that are made up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/cost/answer.h"
#include "cli/cost/sentences.h"

namespace sir::cli {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Spread spread(double low, double median, double high, std::size_t runs = 5) {
  return {median, low, high, runs};
}

TEST(CostSentence, SaysWhatTheQuartilesAllow) {
  EXPECT_EQ(cost_in_words(spread(2.2, 2.3, 2.4)), "costs 2.30x");
  EXPECT_EQ(cost_in_words(spread(0.80, 0.83, 0.9)), "costs 0.83x");
  EXPECT_EQ(cost_in_words(spread(11, 12.3, 13)), "costs 12x");
  EXPECT_EQ(cost_in_words(spread(0.97, 1.2, 1.3)), "costs nothing measurable");
  EXPECT_EQ(cost_in_words(spread(1, 1, 1)), "costs nothing measurable");
  EXPECT_EQ(cost_in_words(spread(1.001, 1.003, 1.004)), "costs less than 1 % more");
  EXPECT_EQ(cost_in_words(spread(0.995, 0.997, 0.999)), "costs less than 1 % less");
  // Quartiles of one or two runs say nothing.
  EXPECT_EQ(cost_in_words(spread(64, 64, 64, 1)), "costs 64x (by 1 run)");
  EXPECT_EQ(cost_in_words(spread(0.9, 1.05, 1.2, 2)), "costs about as much (by 2 runs)");
}

TEST(CostSentence, SaysWhatIsGained) {
  EXPECT_EQ(gain_in_words(30.0, 36.1), "for +6.1 dB");
  EXPECT_EQ(gain_in_words(36.1, 30.0), "for -6.1 dB");
  EXPECT_EQ(gain_in_words(30.0, 30.25), "for +0.25 dB");
  EXPECT_EQ(gain_in_words(30.0, 30.0), "for no gain (less than 0.01 dB)");
  EXPECT_EQ(gain_in_words(30.0, std::nullopt), "and leaves nothing wrong");
  EXPECT_EQ(gain_in_words(std::nullopt, 30.0), "and falls from no error to 30.0 dB");
  EXPECT_EQ(gain_in_words(std::nullopt, std::nullopt), "where nothing is wrong");
  EXPECT_EQ(removal_in_words(214, 0), "and removes 214 wrong pixels");
  EXPECT_EQ(removal_in_words(215, 1), "and removes 214 wrong pixels of 215");
  EXPECT_EQ(removal_in_words(1, 0), "and removes 1 wrong pixel");
  EXPECT_EQ(removal_in_words(1, 3), "and adds 2 wrong pixels");
  EXPECT_EQ(removal_in_words(0, 0), "and no pixel is wrong in either");
  EXPECT_EQ(removal_in_words(7, 7), "and leaves 7 pixels wrong as before");
}

TEST(CostSentence, SaysWhatIsNoise) {
  EXPECT_THAT(noise_in_words(51.23), HasSubstr("51.2 dB from it"));
  EXPECT_THAT(noise_in_words(std::nullopt), HasSubstr("no noise"));
}

CostRow made_up(std::optional<Knob> knob, const std::string& name, std::vector<double> ms,
                std::optional<double> psnr) {
  CostRow row;
  row.knob = knob;
  row.name = row.subject = name;
  row.ms = std::move(ms);
  row.picture.psnr = psnr;
  row.points.emplace();
  return row;
}

// Times and errors of a scene that needs depth 3.
CostPart a_part() {
  CostPart part;
  part.rows.push_back(made_up(std::nullopt, "default", {100, 200, 100}, 36.0));
  part.rows.back().at = 5;
  part.rows.back().rounded = 3;
  part.rows.push_back(made_up(Knob::precision, "float", {90, 180, 91}, 35.9));
  part.rows.back().rounded = 217;
  part.rows.push_back(made_up(Knob::precision, "long double", {400, 800, 400}, 36.0));
  part.rows.back().rounded = 0;
  for (const int depth : {1, 2, 3, 4, 6}) {
    part.rows.push_back(made_up(Knob::depth, "depth", {50, 100, 50}, 30.0));
    part.rows.back().at = depth;
    part.rows.back().points->pixels = depth < 3 ? 100u : 0u;
  }
  part.rows.push_back(made_up(Knob::cutoff, "a cutoff of 0.01", {80, 160, 80}, 35.97));
  part.rows.push_back(
      made_up(Knob::antialias, "antialiasing at threshold 16", {230, 460, 230}, 42.1));
  part.rows.back().family = "adaptive";
  part.rows.push_back(made_up(Knob::antialias, "4 random rays a pixel", {400, 800, 400}, 41.0));
  part.rows.back().family = "random";
  settle(part);
  return part;
}

TEST(CostSentence, TellsThePartsOfTheTracer) {
  const auto sentences = tracer_sentences(a_part());
  EXPECT_THAT(sentences,
              Contains("Double instead of float costs 1.11x and removes 214 wrong pixels of 217."));
  EXPECT_THAT(sentences,
              Contains("Long double instead of double costs 4.00x and removes 3 wrong pixels."));
  EXPECT_THAT(sentences, Contains("From depth 3 to 6 the number of wrong pixels stays at 0."));
  EXPECT_THAT(sentences,
              Contains("Depth 2 costs 0.50x against depth 5 and adds 100 wrong pixels."));
  EXPECT_THAT(sentences, Contains("A cutoff of 0.01 costs 0.80x and changes no pixel."));
  EXPECT_THAT(sentences, Contains("Antialiasing at threshold 16 costs 2.30x for +6.1 dB."));
  EXPECT_THAT(sentences,
              Contains("Antialiasing at threshold 16 gives 42.1 dB, no less than the 41.0 dB of 4 "
                       "random rays a pixel, and costs 0.57x against it."));
}

TEST(CostSentence, SpeaksOfNoRowThatIsNotThere) {
  CostPart part;
  part.rows.push_back(made_up(std::nullopt, "default", {1}, 36.0));
  settle(part);
  EXPECT_TRUE(tracer_sentences(part).empty());
  EXPECT_TRUE(lut_sentences(part).empty());
}

TEST(CostSentence, DepthsThatStillChangeAreToldAsSuch) {
  CostPart part = a_part();
  for (CostRow& row : part.rows)
    if (row.at == 6) row.points->pixels = 1;
  EXPECT_THAT(tracer_sentences(part),
              Contains("Every depth up to 6 still changes the number of wrong pixels."));
}

TEST(CostSentence, TellsThePartsOfTheLut) {
  CostPart part;
  part.rows.push_back(made_up(std::nullopt, "hsv", {1, 1, 1}, 35.0));
  part.rows.push_back(made_up(Knob::nearest, "one by one", {30, 30, 30}, 35.0));
  part.rows.push_back(made_up(Knob::sample, "a 16th", {0.5, 0.5, 0.5}, 34.0));
  part.rows.push_back(made_up(Knob::method, "dear and bad", {9, 9, 9}, 20.0));
  settle(part);
  const auto sentences = lut_sentences(part);
  EXPECT_THAT(sentences, Contains("One by one instead of hsv costs 30x and changes no pixel."));
  EXPECT_THAT(sentences, Contains("A 16th instead of hsv costs 0.50x for -1.0 dB."));
  EXPECT_THAT(sentences, Not(Contains(HasSubstr("bad"))));
}

TEST(CostAnswer, IsTheMostAccurateWithinTheBudget) {
  const CostPart part = a_part();
  const auto answer = within_budget(part, 300);
  ASSERT_TRUE(answer.row);
  EXPECT_EQ(part.rows[*answer.row].name, "antialiasing at threshold 16");
  EXPECT_EQ(part.rows[*within_budget(part, 229).row].name, "default");
  EXPECT_EQ(part.rows[*within_budget(part, 99).row].name, "a cutoff of 0.01");
  const auto none = within_budget(part, 49);
  EXPECT_FALSE(none.row);
  EXPECT_THAT(none.text, HasSubstr("the cheapest, \"depth\", costs 50 ms"));
}

TEST(CostAnswer, IsTheCheapestAtTheTarget) {
  CostPart part = a_part();
  EXPECT_EQ(part.rows[*at_target(part, 35.95).row].name, "a cutoff of 0.01");
  EXPECT_EQ(part.rows[*at_target(part, 42.1).row].name, "antialiasing at threshold 16");
  const auto none = at_target(part, 42.2);
  EXPECT_FALSE(none.row);
  EXPECT_THAT(none.text, HasSubstr("reaches 42.10 dB in 230 ms"));
  part.rows.push_back(made_up(std::nullopt, "exact", {900}, std::nullopt));
  settle(part);
  EXPECT_EQ(part.rows[*at_target(part, 1e6).row].name, "exact");  // no error reaches any PSNR
}

TEST(CostAnswer, ReadsTimesAndDecibels) {
  std::optional<double> value;
  for (const char* text :
       {"", "2", "s", "ms", "0s", "-1s", "infs", "nans", "2 s", "2m", "1e400s", "0ms", "2sec"})
    EXPECT_FALSE(parse_time(text, value)) << text;
  for (const char* text : {"", "dB", "0", "0dB", "-3", "inf", "nan", "nandB", "45db", "45 dB"})
    EXPECT_FALSE(parse_decibels(text, value)) << text;
  EXPECT_FALSE(value);
  EXPECT_TRUE(parse_time("2s", value));
  EXPECT_EQ(value, 2000);
  EXPECT_TRUE(parse_time("0.5ms", value));
  EXPECT_EQ(value, 0.5);
  EXPECT_TRUE(parse_decibels("45dB", value));
  EXPECT_EQ(value, 45);
  EXPECT_TRUE(parse_decibels("41.5", value));
  EXPECT_EQ(value, 41.5);
}

TEST(KnobNames, AreReadAsAList) {
  KnobSet knobs;
  EXPECT_TRUE(parse_knobs("depth,nearest", knobs));
  EXPECT_EQ(knobs, (KnobSet{Knob::depth, Knob::nearest}));
  EXPECT_TRUE(wants(knobs, Knob::depth));
  EXPECT_FALSE(wants(knobs, Knob::grid));
  EXPECT_TRUE(wants_tracer(knobs));
  EXPECT_TRUE(wants_lut(knobs));
  EXPECT_FALSE(wants_lut({Knob::preview}));
  EXPECT_FALSE(wants_tracer({Knob::method}));
  for (const Knob knob : {Knob::effort, Knob::map, Knob::dither}) {
    EXPECT_TRUE(wants_lut({knob})) << name_of(knob);
    EXPECT_FALSE(wants_tracer({knob})) << name_of(knob);
  }
  EXPECT_TRUE(wants_tracer({}) && wants_lut({Knob::combined}) && wants({}, Knob::method));
  for (const char* text : {"", "deep", "depth,", ",depth", "depth,,grid", "depth grid"})
    EXPECT_FALSE(parse_knobs(text, knobs)) << text;
  EXPECT_EQ(knobs.size(), 2u);
}

}  // namespace
}  // namespace sir::cli
