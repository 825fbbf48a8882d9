// The report page: whole in itself, and a browser shows it without a word.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "tests/cli_fixture.h"
#include "viewer/png_file.h"

namespace sir::test {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

class ReportTest : public CliTest {
 protected:
  ReportTest() {
    ended = sir({"table", "--images", SIR_IMAGES, "--repeats", "1", "--html", "report.html"});
    page = text_of(folder / "report.html");
  }
  Ended ended;
  std::string page;
};

TEST_F(ReportTest, NeedsNothingButItself) {
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_EQ(count(page, "http:") + count(page, "https:") + count(page, "url("), 0u);
  EXPECT_EQ(count(page, "src="), count(page, "src=\"data:image/png;base64,"));
  EXPECT_EQ(count(page, "<img "), 35u);  // five images four ways, fifteen heat maps
  EXPECT_EQ(count(page, "alt="), 35u);
  EXPECT_EQ(count(page, "<svg "), 16u);     // fifteen LUTs and the clock
  EXPECT_EQ(count(page, "<circle "), 10u);  // its ten times
  EXPECT_EQ(count(page, "<figcaption>best LUT</figcaption>"), 5u);
  EXPECT_EQ(count(page, "<td>best</td>"), 5u);
  for (const char* title : {"WHITTED", "CALICE", "LUMINAR", "PIRÂMIDE", "LCG"})
    EXPECT_GE(count(page, title), 10u) << title;
}

// The page's own policy forbids every request but data:, and a browser that has to enforce it
// says so on the console. (Which requests are the page's cannot be told from a log: Chromium asks
// its maker for the time and more, whatever it shows.)
TEST_F(ReportTest, ABrowserShowsItWithoutAWord) {
  if (std::system("command -v chromium >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "chromium is not installed";
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(count(page, "default-src 'none'; img-src data:; style-src 'unsafe-inline'"), 1u);
  const std::string here = folder.path().string();
  const std::string command =
      "cd '" + here +
      "' && timeout 120 chromium --headless --no-sandbox --disable-gpu "
      "--no-first-run --disable-background-networking --disable-component-update "
      "--user-data-dir='" +
      here +
      "/profile' --enable-logging=stderr "
      "--screenshot=page.png --window-size=1280,3000 'file://" +
      here + "/report.html' 2>said";
  // First a page that breaks the policy: then it would be seen.
  const auto show = [&](const std::string& text) {
    std::ofstream(folder / "report.html") << text;
    EXPECT_EQ(std::system(command.c_str()), 0) << text_of(folder / "said");
  };
  std::string broken = page;
  broken.insert(broken.find("</body>"), "<img src=\"other.png\" alt=\"\">");
  show(broken);
  EXPECT_GT(count(text_of(folder / "said"), "CONSOLE"), 0u);
  show(page);
  EXPECT_EQ(count(text_of(folder / "said"), "CONSOLE"), 0u) << text_of(folder / "said");

  const Planes shot = viewer::read_png(folder / "page.png");
  EXPECT_EQ(shot.size, (ImageSize{1280, 3000}));
  std::set<std::array<std::uint8_t, 3>> colours;
  for (std::size_t p = 0; p < shot.size.pixels(); ++p)
    colours.insert({shot.at(p).r, shot.at(p).g, shot.at(p).b});
  EXPECT_GT(colours.size(), 20000u) << "the pictures are not there";
}

}  // namespace
}  // namespace sir::test
