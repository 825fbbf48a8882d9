#include "cli/cost/answer.h"

#include <fmt/format.h>

#include "tracer/text_file.h"

namespace sir::cli {
namespace {

bool parse_positive(std::string_view text, double factor, std::optional<double>& value) {
  double number = 0;
  if (!parse_number(text, number) || !(number * factor > 0) || number * factor > 1e300)
    return false;
  value = number * factor;
  return true;
}

std::string quality(const CostRow& row) {
  return row.picture.psnr ? fmt::format("{:.2f} dB", *row.picture.psnr) : "no error at all";
}

// Index of the row of which no allowed one is better.
template <typename Allowed, typename Better>
std::optional<std::size_t> best_of(const CostPart& part, Allowed allowed, Better better) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < part.rows.size(); ++i)
    if (allowed(part.rows[i]) && (!best || better(part.rows[i], part.rows[*best]))) best = i;
  return best;
}

bool is_cheaper(const CostRow& a, const CostRow& b) {
  if (a.time.median != b.time.median) return a.time.median < b.time.median;
  return comparable(a.picture.psnr) > comparable(b.picture.psnr);
}

bool is_more_accurate(const CostRow& a, const CostRow& b) {
  if (comparable(a.picture.psnr) != comparable(b.picture.psnr))
    return comparable(a.picture.psnr) > comparable(b.picture.psnr);
  return a.time.median < b.time.median;
}

constexpr auto kAny = [](const CostRow&) { return true; };

}  // namespace

bool parse_time(std::string_view text, std::optional<double>& milliseconds) {
  if (text.ends_with("ms")) return parse_positive(text.substr(0, text.size() - 2), 1, milliseconds);
  if (text.ends_with("s"))
    return parse_positive(text.substr(0, text.size() - 1), 1000, milliseconds);
  return false;
}

bool parse_decibels(std::string_view text, std::optional<double>& decibels) {
  if (text.ends_with("dB")) text.remove_suffix(2);
  return parse_positive(text, 1, decibels);
}

std::string readable_time(double ms) {
  if (ms < 10) return fmt::format("{:.2f} ms", ms);
  if (ms < 999.5) return fmt::format("{:.0f} ms", ms);
  return fmt::format("{:.{}f} s", ms / 1000, ms < 99'950 ? 1 : 0);
}

CostAnswer within_budget(const CostPart& part, double budget_ms) {
  CostAnswer answer;
  answer.question = fmt::format("within {:g} ms", budget_ms);
  answer.row = best_of(
      part, [&](const CostRow& row) { return row.time.median <= budget_ms; }, is_more_accurate);
  const CostRow& row = part.rows[answer.row.value_or(*best_of(part, kAny, is_cheaper))];
  answer.text =
      answer.row ? fmt::format("Within {}, the most accurate is \"{}\": {} in {}.",
                               readable_time(budget_ms), row.name, quality(row),
                               readable_time(row.time.median))
                 : fmt::format("Nothing takes {} or less: the cheapest, \"{}\", costs {}.",
                               readable_time(budget_ms), row.name, readable_time(row.time.median));
  return answer;
}

CostAnswer at_target(const CostPart& part, double target_db) {
  CostAnswer answer;
  answer.question = fmt::format("at {:g} dB", target_db);
  answer.row = best_of(
      part, [&](const CostRow& row) { return comparable(row.picture.psnr) >= target_db; },
      is_cheaper);
  const CostRow& row = part.rows[answer.row.value_or(*best_of(part, kAny, is_more_accurate))];
  answer.text =
      answer.row ? fmt::format("The cheapest that reaches {:g} dB is \"{}\": {} in {}.", target_db,
                               row.name, quality(row), readable_time(row.time.median))
                 : fmt::format("Nothing reaches {:g} dB: the best, \"{}\", reaches {} in {}.",
                               target_db, row.name, quality(row), readable_time(row.time.median));
  return answer;
}

}  // namespace sir::cli
