// What is worked out from an image and its rendition: judgements, maps, explanations (thesis 4).
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>

#include "viewer/latest.h"
#include "viewer/workshop.h"

namespace sir::viewer {

/// One kind of result for each image and method, made in the background when first asked for and
/// again when picture or rendition changed. For one thread, the window's; no member waits. For
/// results of other ingredients, such as two renditions, there is Latest.
template <typename T>
class Derived {
 public:
  using Result = std::shared_ptr<const T>;

  /// As Latest::Make: another thread calls it, and errors are exceptions.
  using Make =
      std::function<Result(const Picture& picture, const Rendition& rendition, std::stop_token)>;

  /// `workshop` must outlive this.
  Derived(Workshop& workshop, Make make) : workshop_(workshop), make_(std::move(make)) {}

  /// The newest that is ready, or null. It asks for what is missing, the rendition included.
  Result get(std::size_t number, Method method) {
    auto& latest = latest_[{number, method}];
    const Workshop::Shown shown = workshop_.shown(number, method);
    if (!shown.current) return latest.newest();  // a result of this one would soon be replaced
    return latest.get(workshop_.worker(), {shown.picture, shown.rendition},
                      [make = make_, shown](std::stop_token stop) {
                        return make(*shown.picture, *shown.rendition, std::move(stop));
                      });
  }

  /// Whether get() would return the result of the present picture and rendition.
  bool is_current(std::size_t number, Method method) {
    const Workshop::Shown shown = workshop_.shown(number, method);
    return shown.current && latest_[{number, method}].is_current({shown.picture, shown.rendition});
  }

  /// Why the latest attempt gave nothing; "" where it gave something.
  std::string error(std::size_t number, Method method) { return latest_[{number, method}].error(); }

 private:
  Workshop& workshop_;
  Make make_;
  std::map<std::pair<std::size_t, Method>, Latest<T>> latest_;
};

}  // namespace sir::viewer
