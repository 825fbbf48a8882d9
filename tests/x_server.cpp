#include "x_server.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <span>
#include <vector>

namespace sir::test {
namespace {

// What Xvfb says once it listens: the number of its display; empty where it says nothing.
std::string read_line(int file) {
  std::string line;
  for (char letter = 0; ::read(file, &letter, 1) == 1 && letter != '\n';) line += letter;
  return line;
}

struct Freed {
  void operator()(void* memory) const { ::XFree(memory); }
  void operator()(XImage* image) const { XDestroyImage(image); }
};

}  // namespace

struct XServer::Connection {
  explicit Connection(const std::string& display) : to(::XOpenDisplay(display.c_str())) {}
  ~Connection() {
    if (to != nullptr) ::XCloseDisplay(to);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  ::Window root() const { return DefaultRootWindow(to); }

  ::Display* to;
};

std::unique_ptr<XServer> XServer::start(ImageSize screen) {
  int ends[2];
  if (::pipe(ends) != 0) return nullptr;
  const std::string file = std::to_string(ends[1]);
  const std::string size =
      std::to_string(screen.width) + "x" + std::to_string(screen.height) + "x24";
  const pid_t process = ::fork();
  if (process == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    ::close(ends[0]);
    ::execlp("Xvfb", "Xvfb", "-displayfd", file.c_str(), "-screen", "0", size.c_str(), "-nolisten",
             "tcp", "-noreset", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(ends[1]);
  const std::string number = process > 0 ? read_line(ends[0]) : std::string();
  ::close(ends[0]);
  if (process < 0) return nullptr;
  std::unique_ptr<XServer> server(new XServer(process, ":" + number));
  if (number.empty() || server->connection_->to == nullptr) return nullptr;
  return server;
}

XServer::XServer(pid_t process, std::string display)
    : process_(process),
      display_(std::move(display)),
      connection_(std::make_unique<Connection>(display_)) {}

XServer::~XServer() {
  connection_.reset();
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

eltek::Area XServer::largest_area() const {
  ::Window root = 0, parent = 0, *list = nullptr;
  unsigned count = 0;
  ::XQueryTree(connection_->to, connection_->root(), &root, &parent, &list, &count);
  const std::unique_ptr<::Window, Freed> owner(list);
  eltek::Area largest;
  for (const ::Window window : std::span(list, count)) {
    XWindowAttributes of{};
    if (::XGetWindowAttributes(connection_->to, window, &of) == 0) continue;
    const eltek::Area area{of.x, of.y, {of.width, of.height}};
    if (of.map_state == IsViewable && area.size.pixels() > largest.size.pixels()) largest = area;
  }
  return largest;
}

eltek::Screen XServer::largest_window() const {
  const eltek::Area area = largest_area();
  const int screen = DefaultScreen(connection_->to);
  const ImageSize size{DisplayWidth(connection_->to, screen),
                       DisplayHeight(connection_->to, screen)};
  eltek::Screen seen{area.size, {}};
  // A window that reaches beyond the screen cannot be seen whole.
  if (area.size.pixels() == 0 || area.column < 0 || area.row < 0 ||
      area.column + area.size.width > size.width || area.row + area.size.height > size.height)
    return {};
  const std::unique_ptr<XImage, Freed> image(
      ::XGetImage(connection_->to, connection_->root(), area.column, area.row,
                  static_cast<unsigned>(area.size.width), static_cast<unsigned>(area.size.height),
                  AllPlanes, ZPixmap));
  if (image == nullptr) return {};
  for (int y = 0; y < area.size.height; ++y)
    for (int x = 0; x < area.size.width; ++x) {
      const unsigned long word = XGetPixel(image.get(), x, y);
      const auto byte = [&](int shift) { return static_cast<std::uint8_t>(word >> shift & 0xFF); };
      seen.pixels.push_back({byte(16), byte(8), byte(0)});
    }
  return seen;
}

void XServer::point(viewer::Place at) const {
  const eltek::Area area = largest_area();
  ::XWarpPointer(connection_->to, None, connection_->root(), 0, 0, 0, 0, area.column + at.x,
                 area.row + at.y);
  ::XSync(connection_->to, False);
}

}  // namespace sir::test
