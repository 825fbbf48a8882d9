#include "cli/add_option.h"

#include <limits>

#include "cli/option_values.h"
#include "tracer/limits.h"
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
  app->add_option_function<std::string>(
         "--size",
         [&size](const std::string& text) {
           ImageSize parsed;
           if (!parse_size(text, parsed))
             throw CLI::ValidationError(
                 "--size",
                 fmt::format("\"{}\" is not WxH, both positive, at most 2^28 pixels in all", text));
           if (parsed.pixels() > limits().pixels)
             throw CLI::ValidationError(
                 "--size", fmt::format("{} is too large: {}", text,
                                       at_most(limits().pixels, "pixels", "--max-pixels")));
           size = parsed;
         },
         help)
      ->type_name("WxH");
}

}  // namespace sir::cli
