#include "viewer/commands.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "viewer/font.h"
#include "viewer/prompt.h"

namespace sir::viewer {
namespace {

Key key(std::string_view text) { return parse_key(text).value(); }

TEST(Key, IsReadAndWrittenTheSame) {
  for (const char* text :
       {"G", "Ctrl+G", "Shift+R", "Page Up", "?", "+", "-", ",", "F11", "Esc", "Ctrl+Shift+1"})
    EXPECT_EQ(viewer::text(key(text)), text);
  EXPECT_EQ(key("G").code, U'g');
  EXPECT_EQ(key("Shift+R"), (Key{U'r', false, true, false}));
  for (const char* text : {"", "Ctrl+", "Page", "ab", "Hyper+X"})
    EXPECT_FALSE(parse_key(text)) << text;
}

TEST(Commands, EveryKeyIsOneAndIsForOneCommand) {
  std::map<std::string, std::string> taken;
  for (const CommandInfo& info : commands())
    for (const std::string_view text : info.keys) {
      ASSERT_TRUE(parse_key(text)) << text;
      EXPECT_EQ(viewer::text(key(text)), text);
      const auto [at, fresh] = taken.emplace(text, info.name);
      EXPECT_TRUE(fresh) << text << ": " << at->second << " and " << info.name;
      EXPECT_EQ(command_for(key(text)), info.command);
    }
  EXPECT_FALSE(command_for(key("Ctrl+Alt+Q")));
}

TEST(Commands, EachStandsInTheTableOnceWithAKeyAndANameThatCanBeWritten) {
  std::set<Command> seen;
  for (const CommandInfo& info : commands()) {
    EXPECT_TRUE(seen.insert(info.command).second) << info.name;
    EXPECT_FALSE(info.keys.empty()) << info.name;
    EXPECT_FALSE(info.name.empty());
    std::string_view rest = info.name;
    while (!rest.empty()) EXPECT_TRUE(has_glyph(take_character(rest))) << info.name;
  }
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(Command::quit) + 1);
}

TEST(Commands, TheManualHasThemAllWithTheirKeys) {
  std::ifstream file(SIR_DOCS "/viewer.md");
  const std::string manual{std::istreambuf_iterator<char>(file), {}};
  for (const CommandInfo& info : commands()) {
    if (info.command >= Command::plane_1 && info.command <= Command::plane_8) continue;
    std::string keys;
    for (const std::string_view key : info.keys)
      keys.append(keys.empty() ? "`" : ", `").append(key).append("`");
    const std::string line = "| " + keys + " | " + std::string(info.name) + " |\n";
    EXPECT_NE(manual.find(line), std::string::npos) << line;
  }
}

TEST(Commands, AreFoundByPartsOfTheirNames) {
  EXPECT_EQ(find_commands("").size(), commands().size());
  const auto median = find_commands("median");
  ASSERT_EQ(median.size(), 2u);
  EXPECT_EQ(median[0]->command, Command::rgb_median);
  const auto hsv = find_commands("HSV cut");
  ASSERT_EQ(hsv.size(), 1u);
  EXPECT_EQ(hsv[0]->command, Command::hsv_median);
  EXPECT_TRUE(find_commands("no such thing").empty());
  // Names that begin so come first.
  EXPECT_EQ(find_commands("re")[0]->command, Command::reload);
}

TEST(Prompt, ChoosesAmongTheCommandsThatMatch) {
  Prompt prompt;
  EXPECT_FALSE(prompt.open());
  prompt.ask(Prompt::Kind::command);
  EXPECT_EQ(prompt.found().size(), commands().size());
  prompt.type("med");
  EXPECT_EQ(prompt.command(), Command::rgb_median);
  EXPECT_TRUE(prompt.press(key("Down")));
  EXPECT_EQ(prompt.command(), Command::hsv_median);
  EXPECT_TRUE(prompt.press(key("Down")));  // the last stays
  EXPECT_EQ(prompt.command(), Command::hsv_median);
  EXPECT_TRUE(prompt.press(key("Up")));
  EXPECT_TRUE(prompt.press(key("Up")));
  EXPECT_EQ(prompt.command(), Command::rgb_median);
  prompt.type(" xyz");
  EXPECT_EQ(prompt.command(), std::nullopt);
  EXPECT_EQ(prompt.pixel(), std::nullopt);
  for (int i = 0; i < 4; ++i) prompt.press(key("Backspace"));
  EXPECT_EQ(prompt.text(), "med");
  EXPECT_FALSE(prompt.press(key("G")));
}

TEST(Prompt, BackspaceTakesWholeCharacters) {
  Prompt prompt;
  prompt.ask(Prompt::Kind::command);
  prompt.type("aç");
  prompt.press(key("Backspace"));
  EXPECT_EQ(prompt.text(), "a");
  prompt.press(key("Backspace"));
  prompt.press(key("Backspace"));
  EXPECT_EQ(prompt.text(), "");
}

TEST(Prompt, ReadsAPixel) {
  for (const char* text : {"320,200", "320 200", " 320, 200 ", "320x200", "320;200"}) {
    Prompt prompt;
    prompt.ask(Prompt::Kind::pixel);
    prompt.type(text);
    EXPECT_EQ(prompt.pixel(), (Place{320, 200})) << text;
  }
  for (const char* text : {"", "320", "a,b", "1,2,3", "1,2 3", "99999999999,1", "1.5,2"}) {
    Prompt prompt;
    prompt.ask(Prompt::Kind::pixel);
    prompt.type(text);
    EXPECT_EQ(prompt.pixel(), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace sir::viewer
