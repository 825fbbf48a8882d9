#include "cli/cost/cost_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/cost/cost_columns.h"

namespace sir::cli {
namespace {

constexpr std::size_t kLine = 100;

// The group of columns stands over the first of them.
std::string table_text(const CostPart& part, const std::vector<CostColumn>& columns) {
  std::vector<std::size_t> widths;
  for (const CostColumn& column : columns) {
    std::size_t width = std::max(column.title.size(), column.group.size());
    for (const CostRow& row : part.rows) width = std::max(width, column.cell(row).size());
    widths.push_back(width);
  }
  const auto line = [&](const auto& cell) {
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i)
      text += i == 0 ? fmt::format("{:<{}}", cell(i), widths[i])
                     : fmt::format("  {:>{}}", cell(i), widths[i]);
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string text = line([&](std::size_t i) {
    return i == 0 || columns[i].group != columns[i - 1].group ? columns[i].group : std::string();
  });
  text += line([&](std::size_t i) { return (i == 0 ? "  " : "") + columns[i].title; });
  for (const CostRow& row : part.rows)
    text += line([&](std::size_t i) { return columns[i].cell(row); });
  return text;
}

// Words in lines, all but the first indented.
std::string wrapped(const std::string& words, std::size_t indent) {
  std::string text;
  std::size_t column = 0;
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t end = std::min(words.find(' ', from), words.size());
    if (column > indent && column + 1 + end - from > kLine) {
      text += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > 0) {
      text += ' ';
      ++column;
    }
    text += words.substr(from, end - from);
    column += end - from;
    from = end + 1;
  }
  return text + "\n";
}

std::string part_text(const CostImage& image, const std::string& of, const CostPart& part,
                      const std::vector<CostColumn>& columns) {
  std::string text = title_of(image) + ": " + of + "\n\n" + table_text(part, columns) + "\n";
  for (const std::string& sentence : part.sentences) text += wrapped("- " + sentence, 2);
  return text + "\n";
}

}  // namespace

std::string cost_text(const CostReport& report) {
  std::string text;
  for (const CostImage& image : report.images) {
    if (image.tracer) text += part_text(image, "the tracer", *image.tracer, tracer_columns());
    if (image.lut) text += part_text(image, "the LUT", *image.lut, lut_columns());
    for (const CostAnswer& answer : image.answers) text += answer.text + "\n";
    if (!image.answers.empty()) text += "\n";
  }
  for (const auto& [term, meaning] : cost_legend(report)) text += wrapped(term + ": " + meaning, 4);
  return text;
}

}  // namespace sir::cli
