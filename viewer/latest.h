// A result that is made in the background, and made again when what it is made of changes.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "viewer/worker.h"

namespace sir::viewer {

/// What a result is made of: objects that never change, compared by identity. Holding them keeps
/// an identity from being given to another object.
using Ingredients = std::vector<std::shared_ptr<const void>>;

/// The newest result of one kind. All members are for one thread, the window's; none waits.
///
///   Latest<DuelMap> duel;
///   auto map = duel.get(workshop.worker(), {picture, a, b}, [=](std::stop_token stop) {
///     return std::make_shared<const DuelMap>(make_duel_map(*picture, *a, *b, stop));
///   });
template <typename T>
class Latest {
 public:
  using Result = std::shared_ptr<const T>;

  /// Called by the worker's thread; hence it captures by value. What it throws becomes error().
  /// After a stop request it may return null, or what serves in the meantime.
  using Make = std::function<Result(std::stop_token)>;

  /// The result of these ingredients, if it is there; else that is asked for, unless it failed,
  /// and the one before is returned, or null.
  Result get(Worker& worker, const Ingredients& of, Make make) {
    const std::scoped_lock lock(store_->mutex);
    if (store_->of == of || (request_ && wanted_ == of && worker.ask_again(request_)))
      return store_->result;
    if (request_) worker.take_back(request_);
    wanted_ = of;
    request_ = worker.ask([store = store_, of, make = std::move(make)](std::stop_token stop) {
      store->fill(of, make, stop);
    });
    return store_->result;
  }

  /// What get() returned or would return by now; asks for nothing.
  Result newest() const {
    const std::scoped_lock lock(store_->mutex);
    return store_->result;
  }

  /// Whether get() would return a result of these ingredients.
  bool is_current(const Ingredients& of) const {
    const std::scoped_lock lock(store_->mutex);
    return store_->of == of && store_->error.empty();
  }

  /// Why the latest attempt that ended gave nothing; "" where it gave something.
  std::string error() const {
    const std::scoped_lock lock(store_->mutex);
    return store_->error;
  }

 private:
  struct Store {
    void fill(const Ingredients& ingredients, const Make& make, const std::stop_token& stop) {
      Result made;
      std::string reason;
      try {
        made = make(stop);
      } catch (const std::exception& failure) {
        reason = failure.what();
      }
      const std::scoped_lock lock(mutex);
      if (made) {
        result = std::move(made);
        of.reset();  // what that was made of is no longer here
      }
      if (stop.stop_requested()) return;  // it may be less than what was asked for
      of = ingredients;
      error = std::move(reason);
    }

    std::mutex mutex;
    Result result;
    std::optional<Ingredients> of;  // of the latest attempt that ended
    std::string error;
  };

  // The worker may still fill it when this object is gone.
  std::shared_ptr<Store> store_ = std::make_shared<Store>();
  Ingredients wanted_;
  Worker::Handle request_;
};

}  // namespace sir::viewer
