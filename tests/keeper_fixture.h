// A modeler whose session is kept, in a folder of the test's own.
#pragma once

#include <memory>

#include "modeler/keeper.h"
#include "tests/modeler_fixture.h"

namespace sir::test {

class KeeperTest : public ModelerTest {
 protected:
  KeeperTest() { begin(); }

  std::filesystem::path journals() const { return folder / "state"; }

  /// A session with nothing in it, after the one before was dropped, as by a crash.
  void begin(const std::string& from = {}) {
    keeper.reset();
    interpreter = modeler::Interpreter(outlet());
    keeper = std::make_unique<modeler::Keeper>(interpreter, journals(), from);
  }

  static modeler::Outlet outlet() {
    modeler::Outlet outlet;
    outlet.write_picture = [](const std::filesystem::path& file, const Planes&) {
      std::ofstream(file) << "a picture";
    };
    return outlet;
  }

  static std::string all_of(const modeler::Interpreter& session) {
    std::string text = state_of(session) + looks_of(session);
    for (const std::string& line : session.script()) text += line + "\n";
    for (const std::string& name : session.unsaved()) text += "unsaved: " + name + "\n";
    return text + (session.looks_unsaved() ? "looks unsaved\n" : "") +
           std::to_string(session.undoable());
  }

  std::string file(const std::string& name) const { return (folder / name).string(); }

  /// The only journal there is, byte for byte.
  std::string journal() const {
    const auto kept = keeper->sessions();
    if (kept.size() != 1) return "(" + std::to_string(kept.size()) + " journals)";
    std::ifstream bytes(kept.front().file, std::ios::binary);
    return {std::istreambuf_iterator<char>(bytes), {}};
  }

  std::unique_ptr<modeler::Keeper> keeper;
};

}  // namespace sir::test
