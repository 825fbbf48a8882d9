#include "tests/writing_commands.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace sir::test {

namespace fs = std::filesystem;

const std::vector<WritingCommand>& writing_commands() {
  static const std::vector<WritingCommand> all{
      {.name = "render",
       .words = {"render", "s", "--size", "64x48", "--out", "o", "--hesitation", "o/h.png"},
       .outputs = {"s.R", "s.G", "s.B", "s.png", "h.png"},
       .tells_nothing = false},
      {.name = "lut",
       .words = {"lut", "s.png", "-o", "o/x.LUT"},
       .outputs = {"x.LUT"},
       .tells_nothing = false},
      {.name = "show",
       .words = {"show", "s.png", "--png", "o/x.png", "--trace", "o/x.trace"},
       .outputs = {"x.png", "x.trace"}},
      {.name = "model",
       .words = {"model", "all.model"},
       .outputs = {"m.CSG", "b.model", "m.CAM", "m.LUZ", "m.SUP", "m.png", "m.model"},
       .together = false},
      {.name = "paint",
       .words = {"paint", "s.png", "-o", "o/p.png", "--hue", "10..20", "--with", "1,2,3"},
       .outputs = {"p.png"},
       .tells_nothing = false},
      {.name = "planes",
       .words = {"planes", "s", "--size", "64x48", "-o", "o/p.png"},
       .outputs = {"p.png"}},
      {.name = "planes back",
       .words = {"planes", "s.png", "-o", "o/p"},
       .outputs = {"p.R", "p.G", "p.B"},
       .tells_nothing = false},
      {.name = "export", .words = {"export", "s", "--pov", "o/s.pov"}, .outputs = {"s.pov"}},
      {.name = "metrics",
       .words = {"metrics", "s.png", "s.png", "--heat-map", "o/h.png"},
       .outputs = {"h.png"},
       .tells_nothing = false},
      {.name = "replay",
       .words = {"replay", "s.trace", "--png", "o/r.png"},
       .outputs = {"r.png"},
       .tells_nothing = false},
      {.name = "cost",
       .words = {"cost", "s", "--size", "16x12", "--repeats", "1", "--truth-samples", "1", "--only",
                 "depth", "--csv", "o/c.csv", "--html", "o/c.html"},
       .outputs = {"c.csv", "c.html"},
       .same_bytes = false,
       .tells_nothing = false}};
  return all;
}

WritingTest::WritingTest() {
  render();
  EXPECT_EQ(sir({"lut", "s.png", "-q"}).exit_code, 0);
  EXPECT_EQ(sir({"show", "s.png", "--png", "shown.png", "--trace", "s.trace", "-q"}).exit_code, 0);
  folder.write("all.model",
               "create ball sphere 1\nsave ball o/m.CSG\nsave ball o/b.model\ncamera save o/m.CAM\n"
               "light save o/m.LUZ\nsurfaces save o/m.SUP\nshow ball o/m.png --size 64x48\n"
               "script save o/m.model\n");
  fs::create_directory(folder / "o");
}

void WritingTest::make_old(const WritingCommand& command) const {
  for (const auto& entry : fs::directory_iterator(folder / "o")) fs::remove(entry);
  for (const std::string& name : command.outputs) folder.write("o/" + name, "old");
}

std::map<std::string, std::string> WritingTest::found(const WritingCommand& command) const {
  std::map<std::string, std::string> content;
  for (const std::string& name : command.outputs)
    if (folder.has("o/" + name)) content[name] = folder.read("o/" + name);
  return content;
}

std::map<std::string, std::string> WritingTest::made_by(const WritingCommand& command) const {
  make_old(command);
  const Ended ended = sir(command.words);
  EXPECT_EQ(ended.exit_code, 0) << command.name << ": " << ended.err;
  if (command.tells_nothing) {
    EXPECT_EQ(ended.out, "") << command.name;
  }
  auto content = found(command);
  EXPECT_EQ(content.size(), command.outputs.size()) << command.name;
  for (const auto& [name, bytes] : content) EXPECT_NE(bytes, "old") << command.name << ": " << name;
  return content;
}

void WritingTest::expect_failed(const WritingCommand& command, const Ended& ended,
                                const std::string& reason) {
  EXPECT_EQ(ended.exit_code, 1) << command.name << ": " << ended.err;
  // Notes may come before it.
  const std::size_t last = ended.err.rfind("sir: ");
  ASSERT_NE(last, std::string::npos) << command.name << ": " << ended.err;
  const std::string line = ended.err.substr(last);
  EXPECT_EQ(line.find('\n'), line.size() - 1) << command.name << ": " << line;
  EXPECT_NE(line.find(reason), std::string::npos) << command.name << ": " << line << reason;
  EXPECT_TRUE(std::any_of(
      command.outputs.begin(), command.outputs.end(),
      [&](const auto& name) { return line.find("o/" + name + ": ") != std::string::npos; }))
      << command.name << ": " << line;
}

void WritingTest::expect_nothing_lost(const WritingCommand& command,
                                      const std::map<std::string, std::string>& made) const {
  auto names = command.outputs;
  for (const std::string& name : names) {
    const std::string bytes = folder.read("o/" + name);
    if (bytes == "old") continue;
    EXPECT_FALSE(command.together) << command.name << ": " << name;
    EXPECT_TRUE(made.contains(name) && bytes == made.at(name)) << command.name << ": " << name;
  }
  if (folder.has("o/filler")) names.push_back("filler");
  std::vector<std::string> there;
  for (const auto& entry : fs::directory_iterator(folder / "o"))
    there.push_back(entry.path().filename());
  EXPECT_THAT(there, testing::UnorderedElementsAreArray(names)) << command.name;
}

}  // namespace sir::test
