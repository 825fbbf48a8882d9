#include "bench/peers_programs.h"

#include <fstream>
#include <stdexcept>

#include "bench/child.h"
#include "interchange/pov_export.h"

namespace sir::bench {

bool has_povray() { return child_cpu_seconds({"povray", "--help"}).has_value(); }

Words sir_words(const std::string& sir, ImageSize size, int depth, const std::string& precision) {
  const std::string pixels = std::to_string(size.width) + "x" + std::to_string(size.height);
  return {sir,           "-q",      "render",    "ours",
          "--size",      pixels,    "--depth",   std::to_string(depth),
          "--precision", precision, "--threads", "1",
          "--no-png",    "--out",   "planes"};
}

void write_pov(const std::filesystem::path& folder, const Scene& scene, ImageSize size, int depth) {
  PovOptions options;
  options.file = "theirs.pov";
  options.depth_limit = depth;
  options.size = size;
  options.scale = PovScale::keep;
  std::ofstream(folder / options.file) << pov_text(scene, options);
}

Words pov_words(ImageSize size, int threads, bool with_image) {
  Words words{"povray"};
  for (const std::string& word : pov_arguments("theirs.pov", "theirs.png", size))
    if (with_image || (!word.starts_with("+O") && !word.starts_with("+F"))) words.push_back(word);
  if (!with_image) words.push_back("-F");
  words.push_back("+WT" + std::to_string(threads));
  return words;
}

double seconds_of(const Words& words) {
  const auto used = child_cpu_seconds(words);
  if (!used) throw std::runtime_error("cannot run " + words[0]);
  return *used;
}

}  // namespace sir::bench
