// The only user of libedit.
#include <histedit.h>
#include <langinfo.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <memory>
#include <string_view>

#include "cli/input_wait.h"
#include "cli/interrupt.h"
#include "cli/line_reader.h"
#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "viewer/terminal.h"

namespace sir::cli {
namespace {

constexpr int kKept = 2000;  // lines of history

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
  }));
}

class EditingReader : public LineReader {
 public:
  explicit EditingReader(const LineOptions& options)
      : options_(options),
        editor_(el_init("sir", stdin, stdout, stderr)),
        history_(history_init()) {
    if (editor_ == nullptr || history_ == nullptr) return;
    HistEvent event;
    ::history(history_, &event, H_SETSIZE, kKept);
    ::history(history_, &event, H_SETUNIQUE, 1);
    if (!options_.history.empty()) ::history(history_, &event, H_LOAD, options_.history.c_str());
    el_set(editor_, EL_CLIENTDATA, this);
    el_set(editor_, EL_PROMPT, &EditingReader::prompt);
    el_set(editor_, EL_GETCFN, &EditingReader::read_character);
    el_set(editor_, EL_EDITOR, "emacs");
    el_set(editor_, EL_HIST, &::history, history_);
    el_set(editor_, EL_ADDFN, "sir-complete", "complete the word", &EditingReader::complete);
    el_set(editor_, EL_BIND, "^I", "sir-complete", nullptr);
    // Ctrl-C is a key while a line is edited, and a signal while a command works.
    el_set(editor_, EL_SETTY, "-d", "-isig", nullptr);
    el_set(editor_, EL_BIND, "^C", "em-kill-line", nullptr);
    el_set(editor_, EL_BIND, "^R", "em-inc-search-prev", nullptr);
  }
  ~EditingReader() override {
    if (history_ != nullptr && !options_.history.empty()) save_history();
    if (editor_ != nullptr) el_end(editor_);
    if (history_ != nullptr) history_end(history_);
  }

  bool ready() const { return editor_ != nullptr && history_ != nullptr; }

  std::optional<std::string> read() override {
    int size = 0;
    const char* text = el_gets(editor_, &size);
    if (text == nullptr || size <= 0 || interrupted()) return std::nullopt;
    std::string line(text, static_cast<std::size_t>(size));
    HistEvent event;
    if (line.find_first_not_of(" \t\r\n") != line.npos)
      ::history(history_, &event, H_ENTER, line.c_str());
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    return line;
  }

 private:
  // libedit writes in place, and only to a stream that has a descriptor. The session is over and
  // did what it should, whatever becomes of its history.
  void save_history() noexcept {
    try {
      const std::unique_ptr<std::FILE, int (*)(std::FILE*)> memory(
          ::fdopen(::memfd_create("history", MFD_CLOEXEC), "w+"), &std::fclose);
      HistEvent event;
      if (!memory || ::history(history_, &event, H_SAVE_FP, memory.get()) < 0 ||
          std::fflush(memory.get()) != 0)
        throw FileError(options_.history.string(), 0, "cannot be made");
      std::rewind(memory.get());
      AtomicFile file(options_.history, S_IRUSR | S_IWUSR);  // what one types is one's own
      std::array<char, 4096> chunk;
      while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), memory.get()))
        file.write(std::string_view(chunk.data(), got));
      file.commit();
    } catch (const std::exception& failure) {
      std::fprintf(stderr, "sir: %s\n", failure.what());
    }
  }

  static EditingReader& of(EditLine* editor) {
    void* self = nullptr;
    el_get(editor, EL_CLIENTDATA, &self);
    return *static_cast<EditingReader*>(self);
  }

  // A character of UTF-8, as libedit wants it: 1, or 0 at the end of input, or -1.
  static int read_character(EditLine*, wchar_t* character) {
    std::mbstate_t state{};
    for (;;) {
      if (!wait_for_input(STDIN_FILENO)) return -1;
      char byte = 0;
      const ssize_t got = ::read(STDIN_FILENO, &byte, 1);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return static_cast<int>(got);
      const bool within = std::mbsinit(&state) == 0;
      std::size_t used = std::mbrtowc(character, &byte, 1, &state);
      if (used == static_cast<std::size_t>(-1) && within) {
        // What came before was no character; this byte may well be one.
        state = {};
        used = std::mbrtowc(character, &byte, 1, &state);
      }
      if (used == static_cast<std::size_t>(-2)) continue;  // there is more to it
      if (used != static_cast<std::size_t>(-1)) return 1;
      state = {};  // no character: passed over
    }
  }

  static char* prompt(EditLine* editor) { return of(editor).options_.prompt.data(); }

  static unsigned char complete(EditLine* editor, int) {
    const LineInfo* info = el_line(editor);
    const std::string_view line(info->buffer,
                                static_cast<std::size_t>(info->cursor - info->buffer));
    const modeler::Completion found = of(editor).options_.complete(line);
    if (found.words.empty()) return CC_ERROR;
    const std::string_view typed = line.substr(found.begin);
    std::string word = modeler::common_start(found.words);
    const bool only = found.words.size() == 1;
    if (only && !word.ends_with('/')) word += ' ';
    if (word.size() > typed.size() || (only && word != typed)) {
      el_deletestr(editor, static_cast<int>(characters(typed)));
      el_insertstr(editor, word.c_str());
      return CC_REFRESH;
    }
    list(found);
    return CC_REDISPLAY;
  }

  // Below the line, in columns; no more than fit on a screen or so.
  static void list(const modeler::Completion& found) {
    std::vector<std::string> words = found.words;
    for (std::size_t i = 0; i < found.notes.size(); ++i) words[i] += "  " + found.notes[i];
    constexpr std::size_t kMost = 200;
    std::size_t widest = 1;
    for (const std::string& word : words) widest = std::max(widest, characters(word) + 2);
    const auto columns =
        static_cast<std::size_t>(std::max(viewer::terminal_columns(STDOUT_FILENO).value_or(80), 1));
    const std::size_t a_line = std::max<std::size_t>(columns / widest, 1);
    std::string text = "\n";
    for (std::size_t i = 0; i < std::min(words.size(), kMost); ++i) {
      text += words[i];
      const bool ends = i % a_line == a_line - 1 || i + 1 == words.size();
      text += ends ? "\n" : std::string(widest - characters(words[i]), ' ');
    }
    if (words.size() > kMost) text += "and " + std::to_string(words.size() - kMost) + " more\n";
    std::fputs(text.c_str(), stdout);
  }

  LineOptions options_;
  EditLine* editor_;
  History* history_;
};

}  // namespace

std::unique_ptr<LineReader> make_editing_reader(const LineOptions& options) {
  const char* terminal = std::getenv("TERM");
  const std::string_view kind = terminal == nullptr ? "" : terminal;
  if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDOUT_FILENO) != 1 || kind.empty() || kind == "dumb")
    return nullptr;
  // libedit reads characters by the locale; ours are UTF-8 whatever it says.
  std::setlocale(LC_CTYPE, "");
  if (std::string_view(nl_langinfo(CODESET)) != "UTF-8") std::setlocale(LC_CTYPE, "C.UTF-8");
  auto reader = std::make_unique<EditingReader>(options);
  if (!reader->ready()) return nullptr;
  return reader;
}

}  // namespace sir::cli
