// Commands that are told of when they are done, and done again (the thesis has none, 3.2).
#include <utility>

#include "modeler/arguments.h"
#include "modeler/command_error.h"
#include "modeler/command_line.h"
#include "modeler/interpreter.h"
#include "modeler/look_files.h"
#include "modeler/look_text.h"
#include "tracer/atomic_file.h"
#include "tracer/scene_file.h"

namespace sir::modeler {
namespace {

// Sets a value, and gives it back the one that it had.
template <typename T>
class Meanwhile {
 public:
  Meanwhile(T& place, T value) : place_(place), before_(std::exchange(place, value)) {}
  ~Meanwhile() { place_ = before_; }
  Meanwhile(const Meanwhile&) = delete;
  Meanwhile& operator=(const Meanwhile&) = delete;

 private:
  T& place_;
  T before_;
};

}  // namespace

Reply Interpreter::execute(std::string_view line) {
  if (!keeping_.done || within_ || repeated_ != nullptr) return obey(line);
  const Meanwhile within(within_, true);
  Deed deed;
  deed.in_hand = camera_history_.in_hand();
  if (!same(made_up_camera_, told_camera_)) deed.made_up = made_up_camera_;
  changed_ = false;
  reads_.clear();
  Reply reply = obey(line);
  if (!changed_) return reply;
  deed.command = without_comment(line);
  deed.files = std::move(reads_);
  deed.undoable = undoable();
  told_camera_ = made_up_camera_;
  if (std::string trouble = keeping_.done(deed); !trouble.empty())
    reply.warnings.push_back(std::move(trouble));
  return reply;
}

void Interpreter::repeat(const Deed& deed) {
  const Meanwhile repeated(repeated_, &deed);
  next_read_ = 0;
  if (deed.made_up) made_up_camera_ = *deed.made_up;
  camera_history_.take_in_hand(deed.in_hand);
  obey(deed.command);
  told_camera_ = made_up_camera_;
}

void Interpreter::clear() {
  Interpreter empty(outlet_);
  empty.watchful_ = watchful_;
  empty.keeping_ = std::move(keeping_);
  empty.within_ = within_;
  *this = std::move(empty);
}

TextFile Interpreter::read(const std::filesystem::path& file, std::string_view suffix) {
  return read([&] { return file_to_read(file, suffix); });
}

TextFile Interpreter::read(const std::function<TextFile()>& open) {
  if (repeated_ != nullptr) {
    if (next_read_ == repeated_->files.size()) throw CommandError("what it read has not been kept");
    const TextRead& then = repeated_->files[next_read_++];
    return {then.file, then.text};
  }
  TextFile file = open();
  if (within_) reads_.push_back({file.name(), file.whole()});
  return file;
}

void Interpreter::write(const std::filesystem::path& file, std::string_view text) const {
  if (repeated_ == nullptr) write_file_atomically(file, text);
}

bool Interpreter::looks_unsaved() const {
  return (looks_.lighting && light_line(looks_.lighting) != saved_light_) ||
         (!looks_.surfaces.empty() && surfaces_text(looks_.surface_list()) != saved_surfaces_);
}

Reply Interpreter::recover(Arguments& words) {
  if (!keeping_.recover || repeated_ != nullptr)
    throw CommandError("only at the prompt and in the window is there something to recover");
  std::vector<std::string> given;
  while (words.left() > 0) given.push_back(words.next());
  if (given.size() > 2 || (given.size() == 2 && !given[0].starts_with("--"))) words.fail();
  Reply reply = keeping_.recover(given);
  changed_ = false;  // it is kept already
  return reply;
}

}  // namespace sir::modeler
