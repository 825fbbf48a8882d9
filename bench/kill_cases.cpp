#include "bench/kill_cases.h"

#include <fstream>
#include <stdexcept>

#include "bench/child.h"

namespace sir::bench {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// A chequered floor below a ball: many colours, few rays.
void write_scene_files(const fs::path& base, const char* level) {
  const auto put = [&](const char* suffix, const std::string& text) {
    std::ofstream(base.string() + suffix) << text << std::flush;
  };
  put(".CSG",
      "3\n\n0\nboth\nCOMPOSTO\nUNIÃO\nPRIMITIVO\nPRIMITIVO\n1\n2\n\n"
      "1\nfloor\nPRIMITIVO\nCUBO\n2\n8 0 0 0\n0 1 0 0\n0 0 8 0\n-4 -2 -4 1\n\n"
      "2\nball\nPRIMITIVO\nESFERA\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  put(".CAM", "4 3\n0 0 0\n-1 -1 -1\n4\n0 1 0\n");
  put(".LUZ", std::string("0 0 ") + level + "\n" + level + "\n1\n5 6 7 1\n");
  put(".SUP", std::string("2\n\n1\nball\nLISA\n.1 .1 .3 .3 .1 ") + level +
                  " .2 20 0 0\n\n2\nfloor\nXADREZ\n.1 .1 .3 .1 .7 " + level +
                  " .2 20 0 0\n40 40\n.3 .1 .1 .9 .4 .1 0 1 0 0\n");
}

// A script that saves everything a script can, `scale` large.
void write_script(const fs::path& file, const std::string& scale, const std::string& size) {
  std::ofstream(file) << "create ball sphere 1\nscale ball " + scale + "\ncreate box cube 2\n" +
                             "surface 1 diffuse .1 .2 ." + scale +
                             "\ncombine both ball union box\nlight ambient ." + scale +
                             "\ncamera distance " + scale +
                             "\nsave both o/m.CSG\ncamera save o/m.CAM\nlight save o/m.LUZ\n"
                             "surfaces save o/m.SUP\nshow both o/m.png --shaded --size " +
                             size + "\nscript save o/m.model\n"
                      << std::flush;
}

}  // namespace

std::vector<KillCase> kill_cases(const std::string& program, const fs::path& folder,
                                 ImageSize size) {
  const std::string pixels = std::to_string(size.width) + "x" + std::to_string(size.height);
  fs::create_directory(folder / "o");
  for (const char* which : {"a", "b"}) {
    fs::create_directory(folder / which);
    write_scene_files(folder / which / "s", *which == 'a' ? ".2" : ".8");
    write_script(folder / (std::string(which) + ".model"), *which == 'a' ? "3" : "4", pixels);
    for (const Words& words :
         {Words{program, "render", folder / which / "s", "--size", pixels, "-q"},
          Words{program, "lut", folder / which / "s.png", "-q"}})
      if (!child_use(words)) throw std::runtime_error(words[1] + " of the trial's scene fails");
  }
  const auto words = [&](const std::string& which) {
    return std::vector<Words>{{"render", which + "/s", "--size", pixels, "--out", "o", "-q"},
                              {"lut", which + "/s.png", "-o", "o/x.LUT"},
                              {"show", which + "/s.png", "--crop", "--lut", which + "/s.LUT",
                               "--png", "o/x.png", "--trace", "o/x.trace", "-q"},
                              {"model", which + ".model"}};
  };
  std::vector<KillCase> cases{
      {"render", {}, {}, {"o/s.R", "o/s.G", "o/s.B", "o/s.png"}},
      {"lut", {}, {}, {"o/x.LUT"}},
      {"show --png --trace", {}, {}, {"o/x.png", "o/x.trace"}},
      {"model", {}, {}, {"o/m.CSG", "o/m.CAM", "o/m.LUZ", "o/m.SUP", "o/m.png", "o/m.model"}}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    cases[i].before = words("a")[i];
    cases[i].killed = words("b")[i];
  }
  return cases;
}

}  // namespace sir::bench
