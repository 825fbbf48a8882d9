#include "viewer/worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/eventually.h"
#include "viewer/latest.h"

namespace sir::viewer {
namespace {

using test::eventually;
using testing::ElementsAre;

/// Keeps the worker busy until it is let go or asked to stop.
class Hold {
 public:
  Worker::Work work() {
    return [this](const std::stop_token& stop) {
      begun = true;
      while (!let_go && !stop.stop_requested()) std::this_thread::yield();
      stopped = stop.stop_requested();
      ended = true;
    };
  }

  std::atomic<bool> begun = false, let_go = false, stopped = false, ended = false;
};

class WorkerTest : public testing::Test {
 protected:
  Worker::Work note(const std::string& name) {
    return [this, name](const std::stop_token&) {
      const std::scoped_lock lock(mutex);
      done.push_back(name);
    };
  }

  std::vector<std::string> done_so_far() {
    const std::scoped_lock lock(mutex);
    return done;
  }

  Worker::Handle hold_up() {
    const auto held = worker.ask(hold.work());
    EXPECT_TRUE(eventually([&] { return hold.begun.load(); }));
    return held;
  }

  std::mutex mutex;
  std::vector<std::string> done;
  std::atomic<int> wakes = 0;
  Hold hold;
  Worker worker{[this] { ++wakes; }};
};

TEST_F(WorkerTest, DoesWhatTheLatestDrawingAskedForFirstThenInTheOrderOfAsking) {
  const auto held = hold_up();
  const auto old = worker.ask(note("old"));
  worker.end_drawing();
  EXPECT_TRUE(worker.ask_again(held));
  worker.ask(note("a"));
  worker.ask(note("b"));
  EXPECT_TRUE(worker.ask_again(old));
  worker.end_drawing();
  worker.ask(note("new"));
  hold.let_go = true;
  ASSERT_TRUE(eventually([&] { return done_so_far().size() == 4; }));
  EXPECT_THAT(done_so_far(), ElementsAre("new", "old", "a", "b"));
  EXPECT_FALSE(worker.ask_again(old));
  EXPECT_TRUE(eventually([&] { return wakes == 5; }));
}

TEST_F(WorkerTest, DropsWhatADrawingNoLongerAsksFor) {
  hold_up();
  const auto dropped = worker.ask(note("dropped")), kept = worker.ask(note("kept"));
  worker.end_drawing();
  EXPECT_TRUE(worker.ask_again(kept));
  worker.end_drawing();
  EXPECT_FALSE(worker.ask_again(dropped));
  ASSERT_TRUE(eventually([&] { return hold.ended.load(); })) << "nobody asked for it again";
  EXPECT_TRUE(hold.stopped);
  ASSERT_TRUE(eventually([&] { return !done_so_far().empty(); }));
  EXPECT_THAT(done_so_far(), ElementsAre("kept"));
}

TEST_F(WorkerTest, WhatRunsIsLetEndWhereNothingElseWaits) {
  hold_up();
  worker.end_drawing();
  worker.end_drawing();
  hold.let_go = true;
  ASSERT_TRUE(eventually([&] { return hold.ended.load(); }));
  EXPECT_FALSE(hold.stopped);
}

TEST_F(WorkerTest, TakesBack) {
  const auto running = worker.ask(hold.work());
  ASSERT_TRUE(eventually([&] { return hold.begun.load(); }));
  const auto waiting = worker.ask(note("waiting"));
  worker.take_back(waiting);
  worker.take_back(running);
  EXPECT_FALSE(worker.ask_again(waiting));
  EXPECT_FALSE(worker.ask_again(running));
  worker.ask(note("last"));
  ASSERT_TRUE(eventually([&] { return !done_so_far().empty(); }));
  EXPECT_TRUE(hold.stopped);
  EXPECT_THAT(done_so_far(), ElementsAre("last"));
}

TEST(Worker, ItsEndStopsWhatRunsAndBeginsNothing) {
  Hold hold;
  std::atomic<bool> begun = false;
  {
    Worker worker([] {});
    worker.ask(hold.work());
    ASSERT_TRUE(eventually([&] { return hold.begun.load(); }));
    worker.ask([&](const std::stop_token&) { begun = true; });
  }
  EXPECT_TRUE(hold.stopped);
  EXPECT_FALSE(begun);
}

class LatestTest : public testing::Test {
 protected:
  using Number = Latest<int>;

  static Number::Make give(int number) {
    return [number](const std::stop_token&) { return std::make_shared<const int>(number); };
  }
  static std::shared_ptr<const void> ingredient() { return std::make_shared<const int>(0); }

  Worker worker{[] {}};
  Number latest;
};

TEST_F(LatestTest, IsMadeOnceAndAgainForOtherIngredients) {
  const Ingredients first{ingredient()}, second{ingredient(), ingredient()};
  EXPECT_EQ(latest.get(worker, first, give(1)), nullptr);
  ASSERT_TRUE(eventually([&] { return latest.is_current(first); }));
  EXPECT_EQ(*latest.get(worker, first, give(99)), 1);
  EXPECT_FALSE(latest.is_current(second));
  EXPECT_EQ(*latest.get(worker, second, give(2)), 1) << "the one before";
  ASSERT_TRUE(eventually([&] { return latest.is_current(second); }));
  EXPECT_EQ(*latest.newest(), 2);
}

TEST_F(LatestTest, AnErrorIsKeptAndNotTriedAgain) {
  const Ingredients good{ingredient()}, bad{ingredient()};
  latest.get(worker, good, give(1));
  ASSERT_TRUE(eventually([&] { return latest.is_current(good); }));
  std::atomic<int> tries = 0;
  const auto fail = [&](const std::stop_token&) -> Number::Result {
    ++tries;
    throw std::runtime_error("no luck");
  };
  latest.get(worker, bad, fail);
  ASSERT_TRUE(eventually([&] { return latest.error() == "no luck"; }));
  EXPECT_EQ(*latest.get(worker, bad, fail), 1) << "the last good one";
  EXPECT_FALSE(latest.is_current(bad));
  EXPECT_EQ(tries, 1);
  latest.get(worker, good, give(3));
  ASSERT_TRUE(eventually([&] { return latest.is_current(good); }));
  EXPECT_EQ(latest.error(), "");
  EXPECT_EQ(*latest.newest(), 3);
}

// A stop leaves something for the meantime, which does not count as what was asked for.
TEST_F(LatestTest, WhatWasStoppedIsShownButNotCurrent) {
  const Ingredients first{ingredient()}, second{ingredient()};
  std::latch begun(1);
  const auto until_stopped = [&](const std::stop_token& stop) {
    begun.count_down();
    while (!stop.stop_requested()) std::this_thread::yield();
    return std::make_shared<const int>(1);
  };
  latest.get(worker, first, until_stopped);
  begun.wait();
  Hold hold;
  latest.get(worker, second, [&](const std::stop_token& stop) {
    hold.work()(stop);
    return std::make_shared<const int>(2);
  });
  ASSERT_TRUE(eventually([&] { return latest.newest() && *latest.newest() == 1; }));
  EXPECT_FALSE(latest.is_current(first));
  hold.let_go = true;
  ASSERT_TRUE(eventually([&] { return latest.is_current(second); }));
  EXPECT_EQ(*latest.newest(), 2);
}

// What was there before a stopped one is gone: it must not pass for current.
TEST_F(LatestTest, WhatWasStoppedTakesThePlaceOfWhatWasCurrent) {
  const Ingredients first{ingredient()}, second{ingredient()}, third{ingredient()};
  latest.get(worker, first, give(1));
  ASSERT_TRUE(eventually([&] { return latest.is_current(first); }));
  std::latch begun(1);
  latest.get(worker, second, [&](const std::stop_token& stop) {
    begun.count_down();
    while (!stop.stop_requested()) std::this_thread::yield();
    return std::make_shared<const int>(2);
  });
  begun.wait();
  EXPECT_EQ(*latest.get(worker, first, give(99)), 1);  // back again while it runs
  Hold hold;
  latest.get(worker, third, [&](const std::stop_token& stop) {
    hold.work()(stop);
    return std::make_shared<const int>(3);
  });
  ASSERT_TRUE(eventually([&] { return *latest.newest() == 2; }));
  EXPECT_FALSE(latest.is_current(first));
  hold.let_go = true;
  latest.get(worker, first, give(4));
  ASSERT_TRUE(eventually([&] { return latest.is_current(first); }));
  EXPECT_EQ(*latest.newest(), 4);
}

TEST_F(LatestTest, ADroppedRequestIsMadeAnew) {
  Hold hold;
  worker.ask(hold.work());
  ASSERT_TRUE(eventually([&] { return hold.begun.load(); }));
  const Ingredients of{ingredient()};
  latest.get(worker, of, give(1));
  worker.end_drawing();
  worker.end_drawing();
  hold.let_go = true;
  ASSERT_TRUE(eventually([&] {
    latest.get(worker, of, give(2));
    return latest.is_current(of);
  }));
  EXPECT_EQ(*latest.newest(), 2);
}

}  // namespace
}  // namespace sir::viewer
