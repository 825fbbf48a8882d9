// Sessions as nobody would think of them.
#pragma once

#include <cstdint>
#include <iterator>
#include <random>
#include <string>
#include <utility>

#include "modeler/interpreter.h"

namespace sir::test {

/// Commands of all sorts, most of which can be done.
class Player {
 public:
  Player(std::uint64_t seed, std::string folder) : random_(seed), folder_(std::move(folder)) {}

  std::string draw(const modeler::Interpreter& interpreter) {
    const auto& entries = interpreter.solids().entries();
    const auto any = [&] {
      if (entries.empty()) return std::string("nothing");
      auto at = entries.begin();
      std::advance(at, static_cast<std::ptrdiff_t>(random_() % entries.size()));
      return "\"" + at->second->name + "\"";
    };
    const std::string fresh = "s" + number(20);
    switch (random_() % 34) {
      case 0: return "create " + fresh + " cube " + number(4);
      case 1: return "create " + fresh + " sphere " + number(4);
      case 2: return "create " + fresh + " cone 1 " + number(4);
      case 3: return "translate " + any() + " " + real() + " " + real() + " 0";
      case 4: return "rotate " + any() + " y " + real();
      case 5:
      case 6: return "combine " + fresh + " " + any() + " union " + any();
      case 7: return "split " + any();
      case 8: return random_() % 2 == 0 ? "delete " + any() : "rename " + any() + " " + fresh;
      case 9: return "copy " + any() + " " + fresh;
      case 10: return "camera turn " + real() + " " + real();
      case 11: return "camera pan " + real() + " " + real();
      case 12: return "camera zoom " + real() + "  # nearer";
      case 13: return "camera target " + real() + " 0 0 focal " + real() + " parallel";
      case 14: return random_() % 2 == 0 ? "camera frame" : "camera frame " + any();
      case 15: return random_() % 2 == 0 ? "camera auto" : "camera perspective";
      case 16: return random_() % 2 == 0 ? "undo camera" : "redo camera";
      case 17: return "light add " + real() + " 1 2 " + real();
      case 18: return "light move " + number(3) + " 1 " + real() + " 3";
      case 19: return "light colour " + number(3) + " " + real();
      case 20: return "light delete " + number(3);
      case 21: return random_() % 2 == 0 ? "light ambient " + real() : "light background " + real();
      case 22: return random_() % 3 == 0 ? "light auto" : "light load " SIR_IMAGES "/lcg";
      case 23: return "surface " + number(5) + " colour " + real() + " specular 0.25";
      case 24: return "surface " + number(5) + " chequer 3 4 odd diffuse " + real();
      case 25: return "surfaces delete " + number(5);
      case 26: return random_() % 4 == 0 ? "surfaces load " SIR_IMAGES "/calice" : "list";
      case 27: return "view ghosts " + std::string(random_() % 2 == 0 ? "on" : "off");
      case 28: return "view axes " + std::string(random_() % 2 == 0 ? "on" : "off");
      case 29: return random_() % 8 == 0 ? "select" : "select " + any() + " " + number(3) + " 0";
      case 30: return saving(any());
      case 31:
      case 32: return "undo";
      default: return "redo";
    }
  }

 private:
  std::string number(std::uint64_t below) { return std::to_string(random_() % below); }
  std::string real() { return std::to_string(static_cast<double>(random_() % 2000) / 700 - 1); }

  // To a file of its own each time.
  std::string saving(const std::string& name) {
    const std::string to = folder_ + "/f" + std::to_string(files_++);
    switch (random_() % 6) {
      case 0: return "save " + name + " " + to + ".CSG";
      case 1: return "camera save " + to + ".CAM";
      case 2: return "light save " + to + ".LUZ";
      case 3: return "surfaces save " + to + ".SUP";
      case 4: return "show " + name + " " + to + ".png --size 12x9";
      default: return "show " + name + " " + to + ".png --size 12x9 --shaded";
    }
  }

  std::mt19937_64 random_;
  std::string folder_;
  int files_ = 0;
};

}  // namespace sir::test
