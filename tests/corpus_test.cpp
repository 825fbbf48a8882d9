// What fuzzing found to be of interest, played again without libFuzzer: seeds, the minimised corpus
// and the inputs that once broke something (docs/fuzzing.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/targets.h"

namespace sir::fuzz {
namespace {

namespace fs = std::filesystem;

using Files = std::vector<fs::path>;

void add_folder(const fs::path& folder, const std::string& suffix, Files& files) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && (suffix.empty() || entry.path().extension() == suffix))
      files.push_back(entry.path());
}

// The scenes of the laboratory are seeds by themselves.
std::string image_suffix(std::string_view target) {
  if (target == "camera") return ".CAM";
  if (target == "csg") return ".CSG";
  if (target == "light") return ".LUZ";
  if (target == "script") return ".model";
  if (target == "surfaces") return ".SUP";
  return "";
}

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void play(const Target& target, const fs::path& path) {
  const auto bytes = bytes_of(path);
  try {
    target.play(bytes);
  } catch (const std::exception& error) {
    ADD_FAILURE() << path.string() << ": " << error.what();
  }
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, IsPlayedWithoutAFinding) {
  const std::string name(GetParam().name);
  const fs::path root(SIR_FUZZ);
  Files files;
  for (const char* part : {"seeds", "corpus", "regressions"})
    add_folder(root / part / name, "", files);
  if (const std::string suffix = image_suffix(name); !suffix.empty())
    add_folder(SIR_IMAGES, suffix, files);
  std::sort(files.begin(), files.end());
  ASSERT_FALSE(files.empty());
  for (const fs::path& file : files) play(GetParam(), file);
}

// Any input is fine, nothing at all too.
TEST_P(Corpus, NothingIsAnInput) { EXPECT_NO_THROW(GetParam().play({})); }

INSTANTIATE_TEST_SUITE_P(Of, Corpus, testing::ValuesIn(kTargets),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace sir::fuzz
