// How long the modeler takes for long scripts, and what they keep in memory: transforms of one
// primitive and of a large composite, chains of combinations, edits of parts; each also with every
// second command an undo, after half as many without, and with a journal, as at the prompt, in the
// folder for temporary files (TMPDIR). `modeler_bench [COMMANDS]`, 100,000 if not told.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "modeler/interpreter.h"
#include "modeler/keeper.h"
#include "tests/temp_folder.h"

namespace {

using sir::modeler::Interpreter;

const int kRuns = sir::bench::rounds(3);
constexpr int kPrimitives = 1000;  // of the composite: 1,999 nodes

// A composite c, its primitives in rows and its tree as flat as can be.
void make_composite(Interpreter& session) {
  const char* const kinds[] = {"cube 1", "sphere 2", "cone 1", "cylinder 3"};
  int made = 0;
  const std::function<std::string(int)> grow = [&](int primitives) {
    const std::string name = primitives == kPrimitives ? "c" : "n" + std::to_string(made++);
    if (primitives == 1) {
      session.execute("create " + name + " " + kinds[made % 4]);
      session.execute("translate " + name + " " + std::to_string(made % 20) + " " +
                      std::to_string(made / 20 % 20) + " " + std::to_string(made / 400));
      return name;
    }
    const std::string left = grow(primitives / 2), right = grow(primitives - primitives / 2);
    session.execute("combine " + name + " " + left + " union " + right);
    return name;
  };
  grow(kPrimitives);
}

struct Kind {
  const char* name;
  void (*prepare)(Interpreter&);
  /// The command of a number, from 0.
  std::string (*command)(int);
};

std::string chained(int i) {
  const std::string link = std::to_string(i / 3);
  if (i % 3 == 0) return "create p sphere 1";
  if (i % 3 == 1) return "scale p 0.5";
  return "combine c" + std::to_string(i / 3 + 1) + " c" + link + " union p";
}

// A part at a place that is another each time.
std::string place(int i) { return std::to_string(1 + i * 37 % (2 * kPrimitives - 2)); }

constexpr Kind kKinds[] = {
    {"translate a primitive", [](Interpreter& session) { session.execute("create a cube 1"); },
     [](int) { return std::string("translate a 0.1 0 0.2"); }},
    {"translate a composite", make_composite,
     [](int) { return std::string("translate c 0.1 0 0.2"); }},
    {"rotate a composite", make_composite, [](int) { return std::string("rotate c y 1"); }},
    {"create, scale, combine", [](Interpreter& session) { session.execute("create c0 cube 1"); },
     chained},
    {"translate parts", make_composite,
     [](int i) { return "edit c " + place(i) + " translate 0.1 0 0"; }},
    {"paint parts", make_composite, [](int i) { return "edit c " + place(i) + " paint 4"; }},
};

enum class Way { plain, undoing, kept };

struct Cost {
  double seconds = 0, megabytes = 0;
};

double peak_megabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Cost run(const Kind& kind, int commands, Way way) {
  const bool undoing = way == Way::undoing;
  Interpreter session;
  kind.prepare(session);
  const int first = undoing ? commands / 2 : 0;
  for (int i = 0; i < first; ++i) session.execute(kind.command(i));
  const sir::test::TempFolder folder;
  std::optional<sir::modeler::Keeper> keeper;
  if (way == Way::kept) keeper.emplace(session, folder.path());
  const double before = peak_megabytes();
  Cost cost;
  cost.seconds = sir::bench::milliseconds([&] {
                   for (int i = 0; i < commands; ++i) {
                     const bool back = undoing && i % 2 == 1;
                     session.execute(back ? "undo" : kind.command(undoing ? first : i));
                   }
                 }) /
                 1000;
  cost.megabytes = peak_megabytes() - before;
  return cost;
}

// In a process of its own, whose memory is this run's alone.
Cost run_alone(const Kind& kind, int commands, Way way) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    const Cost cost = run(kind, commands, way);
    const bool told = ::write(ends[1], &cost, sizeof cost) == sizeof cost;
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  Cost cost;
  const bool heard = child > 0 && ::read(ends[0], &cost, sizeof cost) == sizeof cost;
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!heard || status != 0) throw std::runtime_error(std::string(kind.name) + ": failed");
  return cost;
}

}  // namespace

int main(int count, char** words) try {
  const int commands = count > 1 ? std::atoi(words[1]) : 100'000;
  std::printf("%d commands; a composite has %d nodes; median of %d\n", commands,
              2 * kPrimitives - 1, kRuns);
  std::printf("%-24s %10s %8s %16s %10s\n", "", "s", "MB", "with undo: s", "kept: s");
  for (const Kind& kind : kKinds) {
    std::vector<double> seconds, megabytes, undoing, kept;
    for (int i = 0; i < kRuns; ++i) {
      const Cost cost = run_alone(kind, commands, Way::plain);
      seconds.push_back(cost.seconds);
      megabytes.push_back(cost.megabytes);
      undoing.push_back(run_alone(kind, commands, Way::undoing).seconds);
      kept.push_back(run_alone(kind, commands, Way::kept).seconds);
    }
    using sir::bench::median;
    std::printf("%-24s %10.3f %8.1f %16.3f %10.3f\n", kind.name, median(seconds), median(megabytes),
                median(undoing), median(kept));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "modeler_bench: %s\n", error.what());
  return 1;
}
