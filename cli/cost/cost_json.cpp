#include <nlohmann/json.hpp>

#include "cli/cost/cost_fields.h"

namespace sir::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Put {
  Json& row;
  const char* key;
  void operator()(std::monostate) const {}
  template <typename Value>
  void operator()(const Value& value) const {
    row[key] = value;  // an infinite number is dumped as null
  }
};

Json rows_json(const CostPart& part) {
  Json rows = Json::array();
  for (const CostRow& each : part.rows) {
    Json row = Json::object();
    for (const CostField& field : cost_fields()) std::visit(Put{row, field.key}, field.of(each));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json answer_json(const CostImage& image, const CostAnswer& answer) {
  Json json{{"question", answer.question},
            {"part", answer.of_tracer ? "tracer" : "lut"},
            {"met", answer.row.has_value()}};
  if (answer.row) {
    const CostRow& row = (answer.of_tracer ? image.tracer : image.lut)->rows[*answer.row];
    json["choice"] = row.name;
    json["ms"] = row.time.median;
    json["psnr"] = comparable(row.picture.psnr);
  }
  json["text"] = answer.text;
  return json;
}

}  // namespace

std::string cost_json(const CostReport& report) {
  Json images = Json::array();
  for (const CostImage& image : report.images) {
    Json json{{"image", image.name}, {"size", {image.size.width, image.size.height}}};
    if (image.tracer)
      json["tracer"] = {{"truth", image.truth},
                        {"truth_noise", comparable(image.truth_noise)},
                        {"rows", rows_json(*image.tracer)},
                        {"sentences", image.tracer->sentences}};
    if (image.lut) {
      json["rows"] = rows_json(*image.lut);
      json["sentences"] = image.lut->sentences;
    }
    json["answers"] = Json::array();
    for (const CostAnswer& answer : image.answers)
      json["answers"].push_back(answer_json(image, answer));
    images.push_back(std::move(json));
  }
  // Names of files need not be UTF-8.
  return Json{{"threads", report.threads},
              {"repeats", report.repeats},
              {"truth_samples", report.truth_samples},
              {"images", images}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace sir::cli
