// A small scene in a folder of its own, and `sir` run there.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/run_program.h"
#include "tests/temp_folder.h"

namespace sir::test {

/// A cube [0,1]^3 (node 1, surface 1) less a sphere of radius 0.5 about
/// (1,1,1) (node 2, surface 2), seen from (1,1,1) towards the origin.
class CliTest : public testing::Test {
 protected:
  CliTest() {
    folder.write("s.CSG",
                 "3\n\n0\ntudo\nCOMPOSTO\nDIFERENÇA\nPRIMITIVO\nPRIMITIVO\n1\n2\n\n"
                 "1\ncaixa\nPRIMITIVO\nCUBO\n1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n\n"
                 "2\nfuro\nPRIMITIVO\nESFERA\n2\n.5 0 0 0\n0 .5 0 0\n0 0 .5 0\n1 1 1 1\n");
    folder.write("s.CAM", "4 3\n.5 .5 .5\n-1 -1 -1\n4\n0 1 0\n");
    folder.write("s.LUZ", "0 0 .2\n.1\n1\n5 6 7 1\n");
    folder.write("s.SUP",
                 "2\n\n1\nazul\nLISA\n.1 .1 .3 .1 .1 .8 .2 20 0 0\n\n"
                 "2\nxadrez\nXADREZ\n.1 .1 .3 .1 .1 .8 .2 20 0 0\n4 4\n"
                 ".3 .1 .1 .9 .1 .1 0 1 0 0\n");
  }

  Ended sir(const std::vector<std::string>& arguments, Start start = {}) const {
    start.folder = folder.path();
    return run_sir(arguments, start);
  }

  Ended sir_reading(const std::string& in, const std::vector<std::string>& arguments) const {
    Start start;
    start.in = in;
    return sir(arguments, start);
  }

  /// Planes and PNG of the scene, of 64x48 pixels.
  void render() const { EXPECT_EQ(sir({"render", "s", "--size", "64x48", "-q"}).exit_code, 0); }

  TempFolder folder;
};

/// Exit code, and one line "sir: ..." on standard error that holds `reason`.
inline void expect_failure(const Ended& ended, const std::string& reason) {
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  EXPECT_TRUE(ended.err.starts_with("sir: ")) << ended.err;
  EXPECT_EQ(ended.err.find('\n'), ended.err.size() - 1) << ended.err;
  EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err << "expected: " << reason;
}

}  // namespace sir::test
