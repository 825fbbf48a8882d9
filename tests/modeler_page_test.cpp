// The manual says what the modeler does.
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/modeler_fixture.h"

namespace sir::test {
namespace {

using testing::HasSubstr;

std::string page() {
  std::ifstream file(std::string(SIR_DOCS) + "/modeler.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

// Back to where we were, whatever happens.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::filesystem::path& folder) {
    std::filesystem::current_path(folder);
  }
  ~WorkingFolder() { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

class ModelerPage : public ModelerTest {};

TEST_F(ModelerPage, TheGlassIsBuiltAsTheTranscriptHasIt) {
  const std::string text = page();
  const auto begin = text.find("sir> ");
  ASSERT_NE(begin, text.npos);
  const std::string transcript = text.substr(begin, text.find("```", begin) - begin);
  const WorkingFolder here(folder.path());
  std::istringstream lines(transcript);
  std::string line, played;
  int commands = 0;
  while (std::getline(lines, line)) {
    if (!line.starts_with("sir> ")) continue;
    played += line + "\n";
    ++commands;
    try {
      const modeler::Reply reply = say(line.substr(5));
      played += reply.text + (reply.done.empty() ? "" : reply.done + "\n");
      EXPECT_TRUE(reply.warnings.empty());
    } catch (const modeler::CommandError& error) {
      played += std::string(error.what()) + "\n";
    }
  }
  EXPECT_GT(commands, 20);
  EXPECT_EQ(played, transcript);
  EXPECT_TRUE(folder.has("glass.CSG"));
}

TEST_F(ModelerPage, TheTableHasEveryCommand) {
  const std::string text = page();
  for (const modeler::CommandInfo& info : modeler::commands()) {
    std::string form(info.form);
    for (auto at = form.find('|'); at != form.npos; at = form.find('|', at + 2))
      form.insert(at, "\\");
    EXPECT_THAT(text, HasSubstr("\n| `" + std::string(info.name) + (form.empty() ? "" : " ") +
                                form + "` | `" + std::string(info.portuguese) + "` | " +
                                std::string(info.help) + " |\n"));
  }
}

}  // namespace
}  // namespace sir::test
