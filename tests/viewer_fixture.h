// A viewer over three small pictures, driven by keys and mouse without a window.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "eventually.h"
#include "temp_folder.h"
#include "viewer/argb.h"
#include "viewer/viewer.h"
#include "viewer_pictures.h"

namespace sir::viewer {

class ViewerTest : public testing::Test {
 protected:
  static constexpr ImageSize kLarge{64, 48}, kSmall{32, 20};

  ViewerOptions options() {
    ViewerOptions options;
    options.image_area_only = true;
    options.screenshots = folder_.path();
    options.report = [this](const std::string& text) { reports_.push_back(text); };
    options.workshop.watch_every = std::chrono::milliseconds(5);
    return options;
  }

  /// A, B and C with the seeds 3, 5 and 7; settled.
  Viewer& three() { return three(options()); }
  Viewer& three(ViewerOptions with) {
    viewer_ = std::make_unique<Viewer>(std::move(with));
    viewer_->set_window({640, 480});
    viewer_->open(test::write_picture(folder_.path(), "A", kLarge, 3), false);
    viewer_->open(test::write_picture(folder_.path(), "B", kSmall, 5), false);
    viewer_->open(test::write_picture(folder_.path(), "C", kLarge, 7), false);
    settle();
    return *viewer_;
  }

  void settle() {
    ASSERT_TRUE(test::eventually([this] {
      viewer_->refresh();
      return !viewer_->busy();
    }));
  }

  /// Keys as parse_key reads them, one after the other; then all is settled.
  void type(std::initializer_list<std::string_view> keys) {
    for (const std::string_view text : keys) {
      const auto key = parse_key(text);
      ASSERT_TRUE(key) << text;
      viewer_->press(*key);
      viewer_->release(*key);
    }
    settle();
  }

  /// What is seen at a pixel of the picture.
  Rgb8 seen(int column, int row) {
    const Frame& frame = viewer_->picture();
    return rgb(frame.words.at(frame.offset(column, row)));
  }

  /// In the window, the middle of a pixel of the picture.
  Place middle_of(Place pixel) const {
    const Letterbox box = viewer_->viewport().box();
    const int m = viewer_->viewport().multiple();
    return {box.x + pixel.x * m + m / 2, box.y + pixel.y * m + m / 2};
  }

  test::TempFolder folder_;
  std::vector<std::string> reports_;
  std::unique_ptr<Viewer> viewer_;
};

}  // namespace sir::viewer
