// A workshop over a folder of files, for tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/eventually.h"
#include "tests/temp_folder.h"
#include "tests/viewer_images.h"
#include "viewer/png_file.h"
#include "viewer/workshop.h"

namespace sir::test {

class WorkshopTest : public testing::Test {
 protected:
  static constexpr ImageSize kSize{32, 24};

  WorkshopTest() {
    options.size = kSize;
    options.watch_every = std::chrono::milliseconds(20);
  }

  viewer::Workshop& workshop() {
    if (!workshop_) workshop_ = std::make_unique<viewer::Workshop>(options);
    return *workshop_;
  }

  void close() { workshop_.reset(); }

  std::size_t open(std::string_view name) { return workshop().open(folder / name); }

  viewer::Workshop::State state(std::size_t number) { return workshop().state(number); }

  /// The state once no attempt is under way.
  viewer::Workshop::State settled(std::size_t number) {
    EXPECT_TRUE(eventually([&] { return !state(number).busy; })) << state(number).message;
    return state(number);
  }

  bool comes_to_show(std::size_t number, const Planes& planes) {
    return eventually([&] {
      const auto now = state(number);
      return !now.busy && !now.failed && now.picture && now.picture->planes == planes;
    });
  }

  bool comes_to_fail(std::size_t number) {
    return eventually([&] { return state(number).failed && !state(number).busy; });
  }

  /// Asks until it is there.
  std::shared_ptr<const viewer::Rendition> rendition(std::size_t number, viewer::Method method) {
    viewer::Workshop::Shown shown;
    EXPECT_TRUE(eventually([&] {
      shown = workshop().shown(number, method);
      return shown.current;
    })) << workshop().rendition_error(number, method);
    return shown.rendition;
  }

  bool comes_to_say(std::size_t number, viewer::Method method, const std::string& part) {
    return eventually([&] {
      (void)workshop().shown(number, method);
      return workshop().rendition_error(number, method).find(part) != std::string::npos;
    });
  }

  TempFolder folder;
  viewer::WorkshopOptions options;

 private:
  std::unique_ptr<viewer::Workshop> workshop_;
};

}  // namespace sir::test
