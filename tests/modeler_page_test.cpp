// The manual says what the modeler does.
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/modeler_fixture.h"

namespace sir::test {
namespace {

using testing::HasSubstr;

std::string page(const std::string& name) {
  std::ifstream file(std::string(SIR_DOCS) + "/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The blocks of a page that begin with a prompt, one after the other.
std::string transcript_of(const std::string& text) {
  constexpr std::string_view kFence = "```\n";
  std::string transcript;
  for (auto at = text.find("```\nsir> "); at != text.npos; at = text.find("```\nsir> ", at)) {
    at += kFence.size();
    const auto end = text.find(kFence, at);
    transcript += text.substr(at, end - at);
    at = end;
  }
  return transcript;
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

class ModelerPage : public ModelerTest {
 protected:
  // The transcript with what the modeler says now behind each of its commands.
  std::string played(const std::string& transcript) {
    std::istringstream lines(transcript);
    std::string line, text;
    while (std::getline(lines, line)) {
      if (!line.starts_with("sir> ")) continue;
      text += line + "\n";
      try {
        const modeler::Reply reply = say(line.substr(5));
        text += reply.text + (reply.done.empty() ? "" : reply.done + "\n");
        for (const std::string& warning : reply.warnings) text += "warning: " + warning + "\n";
      } catch (const modeler::CommandError& error) {
        text += std::string(error.what()) + "\n";
      }
    }
    return text;
  }
};

TEST_F(ModelerPage, TheGlassIsBuiltAsTheTranscriptHasIt) {
  const std::string transcript = transcript_of(page("modeler.md"));
  const WorkingFolder here(folder.path());
  EXPECT_EQ(played(transcript), transcript);
  EXPECT_TRUE(folder.has("glass.CSG"));
}

// A long session: its chalice is the one of images/calice, to the last bit.
TEST_F(ModelerPage, TheChaliceIsBuiltAsTheTranscriptHasIt) {
  const std::string transcript = transcript_of(page("chalice.md"));
  std::filesystem::create_directory_symlink(SIR_IMAGES, folder / "images");
  const WorkingFolder here(folder.path());
  EXPECT_EQ(played(transcript), transcript);
  const std::string built = folder.read("chalice.CSG");
  say_all({"delete Cálice", "load scene images/calice", "split scene", "split Metal",
           "save Cálice part"});
  EXPECT_EQ(built, folder.read("part.CSG"));
}

TEST_F(ModelerPage, TheTableHasEveryCommand) {
  const std::string text = page("modeler.md");
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
