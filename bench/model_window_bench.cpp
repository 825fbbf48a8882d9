// What one drawing of the modeler's window costs: the first with the mouse over the picture, later
// ones there and over the panel; and a command of a hand that drags, with the tree that comes of
// it. Of 200 solids, and of one of 1,999 nodes. Medians of 41, in SDL's dummy driver, which draws
// with the processor. `model_window_bench`, from anywhere.
#include <cstdio>

#ifdef SIR_WITH_IMGUI
#include <SDL.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "bench/timing.h"
#include "viewer/model_window.h"

namespace {

using sir::viewer::ModelDesk;
using sir::viewer::ModelWindow;

const int kRuns = sir::bench::rounds(41);

void measure(const char* name, const std::vector<std::string>& commands, const char* dragged) {
  ModelWindow window({}, [&](ModelDesk& desk) {
    for (const std::string& line : commands)
      if (!desk.execute(line))
        std::fprintf(stderr, "%s: %s\n", line.c_str(), desk.message().c_str());
  });
  window.settle();
  const auto picture = window.find("picture").value_or(ModelWindow::Spot{});
  const sir::ImageSize size = window.desk().picture_size();
  std::vector<double> hover, panel, drag;
  const auto move_to = [&](int x, int y) {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.x = x;
    event.motion.y = y;
    SDL_PushEvent(&event);
    // An event is drawn twice.
    return sir::bench::milliseconds([&] { window.settle(); }) / 2;
  };
  const double first = move_to(picture.x + size.width / 2, picture.y + size.height / 2);
  for (int run = 0; run < kRuns; ++run) {
    hover.push_back(
        move_to(picture.x + size.width / 2 + run, picture.y + size.height / 2 + run % 7));
    panel.push_back(move_to(picture.x + size.width + 200, 200 + run));
  }
  for (int run = 0; run < kRuns; ++run) {
    const std::string line = std::string(dragged) + std::to_string(run + 1) + "e-3 0 0";
    drag.push_back(sir::bench::milliseconds([&] {
      if (!window.desk().drag(line)) std::fputs(window.desk().message().c_str(), stderr);
      window.desk().selected_node();  // what waits to be worked out is
    }));
  }
  window.desk().end_drag();
  std::printf("%-22s %8.1f %8.1f %8.1f %8.3f\n", name, first, sir::bench::median(hover),
              sir::bench::median(panel), sir::bench::median(drag));
}

std::vector<std::string> solids(int count) {
  std::vector<std::string> lines;
  for (int i = 0; i < count; ++i) {
    const std::string name = "s" + std::to_string(i);
    lines.push_back("create " + name + " sphere " + std::to_string(i % 7 + 1));
    lines.push_back("translate " + name + " " + std::to_string(i % 20 * 3) + " 0 " +
                    std::to_string(i / 20 * 3));
  }
  return lines;
}

// One solid of them all, a tree as flat as can be.
std::vector<std::string> as_one(int count) {
  std::vector<std::string> lines = solids(count);
  for (int step = 1; step < count; step *= 2)
    for (int i = 0; i + step < count; i += 2 * step) {
      const std::string name = "s" + std::to_string(i);
      lines.push_back("combine t " + name + " union s" + std::to_string(i + step));
      lines.push_back("rename t " + name);
    }
  return lines;
}

}  // namespace

int main() {
  setenv("SDL_VIDEODRIVER", "dummy", 1);
  std::printf("%-22s %8s %8s %8s %8s\n", "ms", "first", "picture", "panel", "command");
  std::vector<std::string> many = solids(200);
  many.push_back("select s199");
  measure("200 solids", many, "translate s199 ");
  std::vector<std::string> large = as_one(1000);
  large.push_back("select s0 1998");
  measure("one of 1,999 nodes", large, "edit s0 1998 translate ");
}
#else
int main() {
  std::puts("this build has no window: it needs SDL2 and Dear ImGui");
  return 1;
}
#endif
