#include <algorithm>

#include <fmt/format.h>

#include "cli/cost/sentences.h"
#include "tracer/text_file.h"

namespace sir::cli {
namespace {

class Speaker {
 public:
  explicit Speaker(const CostPart& part) : part_(part) {}

  std::vector<std::string> all() {
    const CostRow& usual = part_.rows.front();
    const CostRow* const single = named("float");
    if (single) calculated(usual, "double", *single);
    if (const CostRow* row = named("long double")) calculated(*row, row->subject, usual, "double");
    const std::string robust = "using the robust formulas";
    if (const CostRow* row = named("textbook")) calculated(usual, robust, *row);
    if (const CostRow* row = named("float, textbook"); row && single)
      calculated(*single, robust + " in float", *row, "the textbook's");
    depths();
    for (const CostRow& row : part_.rows) {
      if (row.knob == Knob::cutoff) changing(row);
      if (row.knob == Knob::antialias || row.knob == Knob::combined) gaining(row);
      if (row.knob == Knob::preview) gaining(row);
    }
    adaptive_against_random();
    return std::move(sentences_);
  }

 private:
  template <typename... Args>
  void say(fmt::format_string<Args...> format, Args&&... args) {
    sentences_.push_back(as_sentence(fmt::format(format, std::forward<Args>(args)...)));
  }

  const CostRow* named(const std::string& name) const {
    const auto row = std::find_if(part_.rows.begin(), part_.rows.end(),
                                  [&](const CostRow& each) { return each.name == name; });
    return row == part_.rows.end() ? nullptr : &*row;
  }

  // One way to calculate instead of a cheaper one, by the pixels that rounding makes wrong.
  void calculated(const CostRow& better, const std::string& name, const CostRow& worse,
                  const std::string& instead_of = {}) {
    if (!better.rounded || !worse.rounded) return;
    say("{} instead of {} {} {}", name, instead_of.empty() ? worse.subject : instead_of,
        cost_in_words(ratio_of(better.ms, worse.ms)),
        removal_in_words(*worse.rounded, *better.rounded));
  }

  void depths() {
    std::vector<const CostRow*> by_depth(1, nullptr);
    for (const CostRow& row : part_.rows)
      if (row.knob == Knob::depth) by_depth.push_back(&row);
    if (by_depth.size() == 1) return;
    by_depth[0] = &part_.rows.front();
    std::sort(by_depth.begin(), by_depth.end(),
              [](const CostRow* a, const CostRow* b) { return a->at < b->at; });
    const CostRow& last = *by_depth.back();
    std::size_t enough = by_depth.size() - 1;
    while (enough > 0 && by_depth[enough - 1]->points->pixels == last.points->pixels) --enough;
    if (enough + 1 < by_depth.size())
      say("From depth {:g} to {:g} the number of wrong pixels stays at {}", by_depth[enough]->at,
          last.at, last.points->pixels);
    else say("Every depth up to {:g} still changes the number of wrong pixels", last.at);
    for (const CostRow* row : by_depth)
      if (row->knob == Knob::depth)
        say("Depth {:g} {} against depth {:g} {}", row->at, cost_in_words(row->ratio),
            part_.rows.front().at,
            removal_in_words(part_.rows.front().points->pixels, row->points->pixels));
  }

  void changing(const CostRow& row) {
    say("{} {} and changes {}", row.subject, cost_in_words(row.ratio),
        row.changed == 0 ? "no pixel" : counted(row.changed, "pixel"));
  }

  void gaining(const CostRow& row) {
    say("{} {} {}", row.subject, cost_in_words(row.ratio),
        gain_in_words(part_.rows.front().picture.psnr, row.picture.psnr));
  }

  // For each number of random rays the cheapest threshold that gives as much.
  void adaptive_against_random() {
    for (const CostRow& random : part_.rows) {
      if (random.knob != Knob::antialias || random.family != "random") continue;
      const CostRow* best = nullptr;
      for (const CostRow& row : part_.rows)
        if (row.knob == Knob::antialias && row.family == "adaptive" &&
            comparable(row.picture.psnr) >= comparable(random.picture.psnr) &&
            (!best || row.time.median < best->time.median))
          best = &row;
      if (best && best->picture.psnr && random.picture.psnr)
        say("{} gives {:.1f} dB, no less than the {:.1f} dB of {}, and {} against it",
            best->subject, *best->picture.psnr, *random.picture.psnr, random.subject,
            cost_in_words(ratio_of(best->ms, random.ms)));
    }
  }

  const CostPart& part_;
  std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> tracer_sentences(const CostPart& part) { return Speaker(part).all(); }

}  // namespace sir::cli
