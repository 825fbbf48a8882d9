#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include "tracer/atomic_file.h"
#include "tracer/error.h"
#include "viewer/png_file.h"
#include "viewer/png_guard.h"

namespace sir::viewer {
namespace {

/// The file's bytes pass straight into an AtomicFile. An exception from there
/// must not cross libpng's C frames: it is kept, libpng is told of a failure,
/// and write() throws it again.
class PngWriter {
 public:
  explicit PngWriter(AtomicFile& file) : file_(file) {
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &reason_, on_png_error, on_png_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_write_struct(&png_, nullptr);
      throw FileError(file_.destination().string(), 0, "cannot be written: out of memory");
    }
    png_set_write_fn(png_, this, put, flush);
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

  template <class Step>
  void write(const Step& step) {
    const bool done = png_succeeds(png_, step);
    if (failure_) std::rethrow_exception(failure_);
    if (!done)
      throw FileError(file_.destination().string(), 0,
                      std::string("cannot be written: ") + reason_.text);
  }

 private:
  static void put(png_structp png, png_bytep bytes, std::size_t count) {
    auto* self = static_cast<PngWriter*>(png_get_io_ptr(png));
    try {
      self->file_.write(std::as_bytes(std::span(bytes, count)));
      return;
    } catch (...) {
      self->failure_ = std::current_exception();
    }
    png_error(png, "write error");
  }
  static void flush(png_structp) {}

  AtomicFile& file_;
  std::exception_ptr failure_;
  PngReason reason_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

void require_pixels(const AtomicFile& file, ImageSize size) {
  if (size.width < 1 || size.height < 1)
    throw FileError(file.destination().string(), 0, "an image without pixels cannot be a PNG");
}

void set_header(const PngWriter& file, ImageSize size, int colour_type) {
  png_set_user_limits(file.png(), PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(file.png(), file.info(), static_cast<png_uint_32>(size.width),
               static_cast<png_uint_32>(size.height), 8, colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
}

}  // namespace

void write_rgb_png(const std::filesystem::path& path, const Planes& planes) {
  AtomicFile file(path);
  write_rgb_png(file, planes);
  file.commit();
}

void write_rgb_png(AtomicFile& output, const Planes& planes) {
  require_pixels(output, planes.size);
  PngWriter file(output);
  const auto width = static_cast<std::size_t>(planes.size.width);
  std::vector<std::uint8_t> row(3 * width);
  file.write([&] {
    set_header(file, planes.size, PNG_COLOR_TYPE_RGB);
    png_write_info(file.png(), file.info());
    for (std::size_t first = 0; first < planes.size.pixels(); first += width) {
      for (std::size_t i = 0; i < width; ++i)
        for (std::size_t c = 0; c < 3; ++c) row[3 * i + c] = planes.channel[c][first + i];
      png_write_row(file.png(), row.data());
    }
    png_write_end(file.png(), nullptr);
  });
}

void write_indexed_png(const std::filesystem::path& path, const eltek::IndexedScreen& screen) {
  AtomicFile file(path);
  write_indexed_png(file, screen);
  file.commit();
}

void write_indexed_png(AtomicFile& output, const eltek::IndexedScreen& screen) {
  require_pixels(output, screen.size);
  PngWriter file(output);
  const auto width = static_cast<std::size_t>(screen.size.width);
  file.write([&] {
    set_header(file, screen.size, PNG_COLOR_TYPE_PALETTE);
    png_color palette[256];
    for (std::size_t i = 0; i < 256; ++i)
      palette[i] = {screen.palette[i].r, screen.palette[i].g, screen.palette[i].b};
    png_set_PLTE(file.png(), file.info(), palette, 256);
    const auto bits = [&](std::size_t c) { return static_cast<png_byte>(screen.dac.bits[c]); };
    const png_color_8 significant{bits(0), bits(1), bits(2), 0, 0};
    png_set_sBIT(file.png(), file.info(), &significant);
    png_write_info(file.png(), file.info());
    for (std::size_t first = 0; first < screen.size.pixels(); first += width)
      png_write_row(file.png(), &screen.indices[first]);
    png_write_end(file.png(), nullptr);
  });
}

}  // namespace sir::viewer
