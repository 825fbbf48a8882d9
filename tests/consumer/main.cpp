// consumer BASE: traces a scene, chooses its LUT, shows it on the MA120 and prints in numbers what
// came of it: an example of the libraries, and the proof that what is installed is all that it
// takes.
#include <cstdio>
#include <iostream>
#include <string>

#include "eltek/display_driver.h"
#include "eltek/ma120.h"
#include "eltek/screen_hash.h"
#include "interchange/pov_export.h"
#include "modeler/interpreter.h"
#include "quant/choose.h"
#include "quant/map_image.h"
#include "quant/metrics.h"
#include "tracer/error.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: consumer BASE\n", stderr);
    return 2;
  }
  try {
    const sir::Scene scene = sir::read_scene(argv[1]);
    sir::RenderOptions options;
    options.size = {160, 120};
    const sir::Planes image = sir::render(scene, options).planes;

    const sir::quant::Lut lut = sir::quant::choose_lut(image);
    const auto cells = sir::quant::occupied_cells(image);
    const auto indices = sir::quant::map_image(image, lut, {});

    sir::eltek::Ma120 monitor;
    const auto area = show_image(monitor, {argv[1], image.size, indices}, lut);
    const sir::eltek::Screen screen = monitor.scan_out();
    const auto metrics = sir::quant::measure(image, to_planes(crop(screen, area)));

    std::printf("cells_rgb %zu\ncells_hsv %zu\nentries %zu\nhash %016llx\n", cells.rgb, cells.hsv,
                lut.chosen, static_cast<unsigned long long>(sir::eltek::hash(screen)));
    std::printf("psnr %.6f\nde_mean %.6f\n", metrics.psnr.value_or(0), metrics.de_mean);
    std::printf("pov %zu\n", sir::pov_text(scene, {}).size());

    sir::modeler::Interpreter modeler;
    modeler.execute(std::string("load solid \"") + argv[1] + '"');
    std::fputs(modeler.execute("list").text.c_str(), stdout);
  } catch (const sir::FileError& error) {
    std::cerr << "consumer: " << error.what() << '\n';
    return 1;
  }
}
