// Against netpbm, whose median cut and mapping are the plain ones of the field, and against the
// plain search: CPU time, user's and system's.
// Usage: peer_bench SIR [BASE...]   (the program `sir`; planes of 640x480, without any made-up
// images)
// The contenders take turns within each round; printed are medians, and the median of the
// rounds' ratios with the most that we allow ourselves. Exit code 1 where results differ that
// must be equal, or something cannot be run. A ratio that is missed is told, no more: it depends
// on the machine. Without netpbm only what needs none is measured.
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "bench/child.h"
#include "bench/made_up.h"
#include "bench/timing.h"
#include "quant/choose.h"
#include "quant/nearest.h"
#include "tracer/planes.h"
#include "viewer/png_file.h"

namespace {

namespace fs = std::filesystem;
using namespace sir::quant;
using sir::Planes;
using sir::bench::child_cpu_seconds;
using sir::bench::median;

const int kRounds = sir::bench::rounds(15);
constexpr int kCalls = 5;  // of our functions in a round: one is too short for the clock

constexpr double kMostOfChoice = 0.3, kMostOfProcesses = 0.5;
constexpr double kMostOfRenderedSearch = 0.03, kMostOfNoiseSearch = 0.1;

/// A folder of our own that goes away with its content.
struct Scratch {
  fs::path path = fs::temp_directory_path() / ("peer_bench." + std::to_string(::getpid()));
  Scratch() { fs::create_directory(path); }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string file(const char* name) const { return (path / name).string(); }
};

struct Picture {
  std::string name;
  Planes planes;
  bool noise = false;
};

template <typename Work>
double cpu_seconds(int calls, Work work) {
  const double start = sir::bench::own_cpu_seconds();
  for (int i = 0; i < calls; ++i) work();
  return (sir::bench::own_cpu_seconds() - start) / calls;
}

double run(const std::vector<std::string>& words, const std::string& out = "/dev/null") {
  const auto seconds = child_cpu_seconds(words, out);
  if (!seconds) throw std::runtime_error("cannot run " + words[0]);
  return *seconds;
}

void write_ppm(const std::string& path, const Planes& image) {
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << image.size.width << ' ' << image.size.height << "\n255\n";
  for (std::size_t i = 0; i < image.size.pixels(); ++i)
    for (const auto& plane : image.channel) file.put(static_cast<char>(plane[i]));
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

/// The ratios of all images but the noise, by contest.
using Summary = std::map<std::string, std::vector<double>>;

/// Seconds of one contender and of what it is held against, round by round.
struct Duel {
  std::vector<double> ours, theirs;

  void tell(const std::string& what, double most, Summary& summary) const {
    std::vector<double> ratio;
    for (std::size_t i = 0; i < ours.size(); ++i) ratio.push_back(ours[i] / theirs[i]);
    const double middle = median(ratio);
    summary[what].push_back(middle);
    std::printf("  %-24s %8.2f ms of %8.2f ms   ratio %6.4f, at most %4.2f%s\n", what.c_str(),
                1e3 * median(ours), 1e3 * median(theirs), middle, most,
                middle <= most ? "" : "   MISSED");
  }
};

/// Counting and choosing by the four methods, from the planes' files, against pnmcolormap.
void duel_of_choices(const Scratch& scratch, Summary& summary) {
  struct Contender {
    const char* name;
    Method method;
    Space space;
    Duel duel;
  };
  std::array<Contender, 4> contenders{{{"choose frequency rgb", Method::frequency, Space::rgb, {}},
                                       {"choose frequency hsv", Method::frequency, Space::hsv, {}},
                                       {"choose median rgb", Method::median, Space::rgb, {}},
                                       {"choose median hsv", Method::median, Space::hsv, {}}}};
  for (int round = 0; round < kRounds; ++round) {
    const double netpbm = run({"pnmcolormap", "256", scratch.file("image.ppm")});
    for (Contender& one : contenders) {
      ChooseOptions options;
      options.method = one.method;
      options.space = one.space;
      one.duel.theirs.push_back(netpbm);
      one.duel.ours.push_back(cpu_seconds(kCalls, [&] {
        (void)choose_lut(sir::read_planes(scratch.file("image"), sir::ImageSize{}), options);
      }));
    }
  }
  for (const Contender& one : contenders) one.duel.tell(one.name, kMostOfChoice, summary);
}

/// `sir lut` and `sir show` against pnmcolormap and pnmremap. False where the PNG is not the
/// image through the LUT.
bool duel_of_processes(const Scratch& scratch, const std::string& program, const Planes& image,
                       Summary& summary) {
  const std::string base = scratch.file("image"), ppm = scratch.file("image.ppm"),
                    lut = scratch.file("image.LUT"), png = scratch.file("shown.png"),
                    map = scratch.file("map.ppm");
  Duel duel;
  for (int round = 0; round < kRounds; ++round) {
    duel.ours.push_back(run({program, "lut", base, "-o", lut}) +
                        run({program, "show", base, "--lut", lut, "--crop", "--png", png}));
    duel.theirs.push_back(run({"pnmcolormap", "256", ppm}, map) +
                          run({"pnmremap", "-mapfile=" + map, ppm}, scratch.file("mapped.ppm")));
  }
  duel.tell("sir lut, sir show", kMostOfProcesses, summary);
  const Lut chosen = read_lut(lut);
  Planes shown(image.size);
  const auto indices = map_exhaustively(image, chosen);
  for (std::size_t i = 0; i < indices.size(); ++i) shown.set(i, chosen.seen(indices[i]));
  return chosen.entry == choose_lut(image).entry && sir::viewer::read_png(png) == shown;
}

/// Mapping against 256 comparisons a pixel. False where an index differs.
bool duel_of_searches(const Picture& picture, Summary& summary) {
  const Lut lut = choose_lut(picture.planes);
  Duel duel;
  bool equal = true;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::uint8_t> plain, fast;
    duel.theirs.push_back(cpu_seconds(1, [&] { plain = map_exhaustively(picture.planes, lut); }));
    duel.ours.push_back(cpu_seconds(kCalls, [&] { fast = map_to_lut(picture.planes, lut); }));
    equal = equal && plain == fast;
  }
  duel.tell("nearest entry", picture.noise ? kMostOfNoiseSearch : kMostOfRenderedSearch, summary);
  return equal;
}

bool compare(const Picture& picture, const std::string& program, bool netpbm, Summary& all) {
  Summary ignored;
  Summary& summary = picture.noise ? ignored : all;
  std::printf("%s\n", picture.name.c_str());
  bool equal = duel_of_searches(picture, summary);
  if (netpbm) {
    const Scratch scratch;
    sir::write_planes(scratch.file("image"), picture.planes);
    write_ppm(scratch.file("image.ppm"), picture.planes);
    duel_of_choices(scratch, summary);
    equal = duel_of_processes(scratch, program, picture.planes, summary) && equal;
  }
  if (!equal) std::printf("  DIFFERENT\n");
  return equal;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2) throw std::runtime_error("usage: peer_bench SIR [BASE...]");
  std::vector<Picture> pictures;
  for (int i = 2; i < count; ++i)
    pictures.push_back({arguments[i], sir::read_planes(arguments[i], sir::ImageSize{})});
  if (pictures.empty()) pictures.push_back({"balls", sir::bench::balls()});
  pictures.push_back({"noise", sir::bench::noise(), true});
  const bool netpbm = child_cpu_seconds({"pnmcolormap", "--version"}).has_value();
  if (!netpbm) std::printf("netpbm is not installed: only the search for entries is measured\n");
  bool equal = true;
  Summary summary;
  for (const Picture& picture : pictures)
    equal = compare(picture, arguments[1], netpbm, summary) && equal;
  std::printf("median of the images' ratios, the noise left out\n");
  for (const auto& [what, ratios] : summary)
    std::printf("  %-24s %6.4f\n", what.c_str(), median(ratios));
  return equal ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "peer_bench: %s\n", error.what());
  return 1;
}
