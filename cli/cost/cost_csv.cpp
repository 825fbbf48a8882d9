#include <fmt/format.h>

#include "cli/cost/cost_fields.h"

namespace sir::cli {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

struct AsCell {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::size_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const std::string& value) const { return quoted(value); }
};

void add(const CostImage& image, const char* name, const std::optional<CostPart>& part,
         std::string& text) {
  if (!part) return;
  for (const CostRow& row : part->rows) {
    text += quoted(image.name) + "," + name;
    for (const CostField& field : cost_fields()) text += "," + std::visit(AsCell{}, field.of(row));
    text += "\r\n";
  }
}

}  // namespace

std::string cost_csv(const CostReport& report) {
  std::string text = "image,part";
  for (const CostField& field : cost_fields()) text += fmt::format(",{}", field.key);
  text += "\r\n";
  for (const CostImage& image : report.images) {
    add(image, "tracer", image.tracer, text);
    add(image, "lut", image.lut, text);
  }
  return text;
}

}  // namespace sir::cli
