#include "cli/add_option.h"

#include <limits>

#include "cli/option_values.h"
#include "tracer/text_file.h"

namespace sir::cli {

CLI::Option* add_number(CLI::App* app, const std::string& name, double& value, double least,
                        double most, const std::string& help) {
  return app
      ->add_option_function<std::string>(
          name,
          [&value, least, most, name](const std::string& text) {
            double number = 0;
            if (!parse_number(text, number) || number < least || number > most)
              throw CLI::ValidationError(
                  name, most < std::numeric_limits<double>::max()
                            ? fmt::format("\"{}\" is not a number from {} to {}", text, least, most)
                            : fmt::format("\"{}\" is not a number >= {}", text, least));
            value = number;
          },
          help)
      ->type_name("X");
}

void add_size(CLI::App* app, ImageSize& size, const std::string& help) {
  add_parsed(app, "--size", size, parse_size,
             {"WxH", "WxH, both positive, at most 2^28 pixels in all"}, help);
}

}  // namespace sir::cli
