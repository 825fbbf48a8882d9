// Mostra sólido (thesis 3.2.2.9) while a person works on it: shaded, coarse first, and given up as
// soon as anything changes. The thesis's modeler shows lines, on demand.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "modeler/guides.h"
#include "modeler/node.h"
#include "tracer/planes.h"
#include "tracer/scene.h"

namespace sir::modeler {

/// What is to be seen.
struct PreviewRequest {
  NodePtr solid;  ///< null: the background alone
  CameraFile camera;
  std::optional<Lighting> lighting;  ///< none: made up, as scene_of() does
  std::vector<Surface> surfaces;     ///< numbers that are not among them have made-up looks
  ImageSize size;
  bool ghosts = false;            ///< what differences take away, translucent (see ghosts.h)
  bool silhouette = false;        ///< white lines as silhouette() has them, over the whole picture
  std::vector<GuideLine> guides;  ///< lines over the picture, faint behind the solid
};

/// The scene that is traced for a request with a solid; render() makes the same picture of it as
/// the preview does where neither ghosts, lines nor guides are asked for.
Scene preview_scene(const PreviewRequest& request);

/// A picture on the way or at the end of it.
struct PreviewPicture {
  Planes planes;
  std::uint64_t request = 0;  ///< what request() returned
  int block = 1;              ///< side of its squares of one colour, in pixels
  bool whole = false;         ///< the last one of its request
};

/// Traces one request at a time in a thread of its own (and those of the tracer). The members are
/// for one other thread; none of them waits but the destructor, for 256 pixels of each thread.
class Preview {
 public:
  /// `wake` is called by the preview's thread when there is a new picture or an error, not after
  /// the preview is gone; it must return soon. `threads` of the tracer; 0: as many as cores.
  explicit Preview(std::function<void()> wake, int threads = 0);
  ~Preview();
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// Replaces the request that is under way. Returns its number; they count from 1.
  std::uint64_t request(PreviewRequest wanted);

  /// Gives up what is under way.
  void cancel();

  /// The newest picture, coarse ones first; of an earlier request until the latest has one; null
  /// where there has been none.
  std::shared_ptr<const PreviewPicture> take() const;

  /// Why the latest request gave no picture; "" where it did, or is under way.
  std::string error() const;

  /// Whether a request waits or is under way.
  bool busy() const;

 private:
  void run(const std::stop_token& stop);
  void trace(const PreviewRequest& request, std::uint64_t number, const std::stop_token& stop);
  void publish(std::shared_ptr<const PreviewPicture> picture, const std::stop_token& stop);

  std::function<void()> wake_;
  int threads_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<PreviewRequest> wanted_;
  std::uint64_t number_ = 0;
  bool tracing_ = false;
  std::stop_source current_;
  std::shared_ptr<const PreviewPicture> newest_;
  std::string error_;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace sir::modeler
