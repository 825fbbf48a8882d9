#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "tracer/error.h"
#include "tracer/limits.h"
#include "viewer/png_file.h"
#include "viewer/png_guard.h"

namespace sir::viewer {
namespace {

/// What the header tells, and the palette with its opacity (255: opaque).
struct Header {
  png_uint_32 width = 0, height = 0;
  int colour_type = 0;
  int passes = 1;           ///< over all rows
  std::uint64_t bits = 0;   ///< a pixel's in the file
  std::size_t samples = 0;  ///< a pixel's bytes as read: 1 palette index, 3 RGB or 4 RGBA
  std::size_t entries = 0;
  std::array<png_color, 256> palette{};
  std::array<png_byte, 256> opacity{};
};

class PngReader {
 public:
  /// `file`, of so many `bytes` where that is known, may be null, errno then says why; it is closed
  /// at the end.
  PngReader(std::string name, std::FILE* file, std::optional<std::uintmax_t> bytes)
      : name_(std::move(name)), bytes_(bytes), file_(file, &std::fclose) {
    if (!file_) fail(std::string("cannot be read: ") + std::strerror(errno));
    check_signature();
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reason_, on_png_error, on_png_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      fail("cannot be read: out of memory");
    }
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Planes read() {
    attempt([&] { read_header(); });
    require_size();
    // Only now: this takes memory for rows.
    attempt([&] { png_read_update_info(png_, info_); });
    header_.samples = png_get_channels(png_, info_);
    const std::size_t row_bytes = header_.width * header_.samples;
    planes_.size = {static_cast<int>(header_.width), static_cast<int>(header_.height)};
    for (auto& plane : planes_.channel) plane.reserve(planes_.size.pixels());
    if (header_.passes > 1) read_interlaced(row_bytes);
    else read_rows(row_bytes);
    attempt([&] { png_read_end(png_, nullptr); });
    return std::move(planes_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(name_, 0, reason); }

  template <class Step>
  void attempt(const Step& step) {
    if (!png_succeeds(png_, step)) fail(std::string("is a damaged PNG file: ") + reason_.text);
  }

  // Refuses what is too large and what the file cannot hold: deflate, the compression of PNG, makes
  // 258 bytes of two bits at most.
  void require_size() const {
    constexpr std::uint64_t kDeflate = 1032;
    const std::uint64_t pixels = std::uint64_t{header_.width} * header_.height;
    const std::string size = std::to_string(header_.width) + "x" + std::to_string(header_.height);
    if (pixels > limits().pixels)
      fail("an image of " + size +
           " is too large: " + at_most(limits().pixels, "pixels", "--max-pixels"));
    if (bytes_ && pixels * header_.bits / 8 / kDeflate > *bytes_)
      fail("is a damaged PNG file: its " + std::to_string(*bytes_) + " bytes cannot hold " + size +
           " pixels");
  }

  void read_rows(std::size_t row_bytes) {
    pixels_ = std::make_unique_for_overwrite<png_byte[]>(row_bytes);
    for (png_uint_32 j = 0; j < header_.height; ++j) {
      attempt([&] { read_row(pixels_.get(), row_bytes); });
      keep(pixels_.get(), header_.width);
    }
  }

  // With its last row libpng unpacks all that is behind, which a forged file makes gigabytes of.
  // Runs under png_succeeds.
  void read_row(png_bytep row, std::size_t row_bytes) {
    constexpr std::size_t kAhead = std::size_t{1} << 16;  // libpng's buffer and some small chunks
    input_.left = 2 * row_bytes + kAhead;
    png_read_row(png_, row, nullptr);
    input_.left = kNoLimit;
  }

  // Interlaced rows come in several passes, each of which refines them all.
  void read_interlaced(std::size_t row_bytes) {
    // Not zeroed: a forged header must not cost memory that no pixel fills.
    pixels_ = std::make_unique_for_overwrite<png_byte[]>(row_bytes * header_.height);
    // Without a list of rows, whose length a forged header would say.
    attempt([&] {
      for (int pass = 0; pass < header_.passes; ++pass)
        for (std::size_t j = 0; j < header_.height; ++j)
          read_row(&pixels_[j * row_bytes], row_bytes);
    });
    keep(pixels_.get(), planes_.size.pixels());
  }

  void check_signature() {
    std::array<png_byte, 8> signature;
    const std::size_t count = std::fread(signature.data(), 1, signature.size(), file_.get());
    if (std::ferror(file_.get()) != 0) fail(std::string("cannot be read: ") + std::strerror(errno));
    if (count == 0) fail("is empty");
    if (count < signature.size() || png_sig_cmp(signature.data(), 0, signature.size()) != 0)
      fail("is not a PNG file");
  }

  static void get(png_structp png, png_bytep bytes, std::size_t count) {
    auto* input = static_cast<Input*>(png_get_io_ptr(png));
    if (count > input->left) png_error(png, "there is more behind the pixels than they take");
    input->left -= count;
    if (std::fread(bytes, 1, count, input->file) != count)
      png_error(png, "the file ends too early");
  }

  // Runs under png_succeeds: owns nothing. The transformations yield 8 bits a
  // sample; palette indices stay, because libpng would take one that the
  // palette lacks for black.
  void read_header() {
    png_set_read_fn(png_, &input_, get);
    png_set_sig_bytes(png_, 8);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // Texts and profiles would be unpacked, for nothing.
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_read_info(png_, info_);
    int bits = 0;
    png_get_IHDR(png_, info_, &header_.width, &header_.height, &bits, &header_.colour_type, nullptr,
                 nullptr, nullptr);
    header_.bits = static_cast<std::uint64_t>(bits) * png_get_channels(png_, info_);
    const bool transparency = png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
    if (header_.colour_type == PNG_COLOR_TYPE_PALETTE) {
      read_palette(transparency);
      png_set_packing(png_);
    } else {
      png_set_expand_gray_1_2_4_to_8(png_);
      if (transparency) png_set_tRNS_to_alpha(png_);
      png_set_scale_16(png_);
      png_set_gray_to_rgb(png_);
    }
    header_.passes = png_set_interlace_handling(png_);
  }

  void read_palette(bool transparency) {
    png_colorp colours = nullptr;
    int count = 0;
    png_get_PLTE(png_, info_, &colours, &count);
    header_.entries = static_cast<std::size_t>(count);
    std::memcpy(header_.palette.data(), colours, header_.entries * sizeof *colours);
    header_.opacity.fill(255);
    png_bytep alpha = nullptr;
    int alphas = 0;
    if (transparency) png_get_tRNS(png_, info_, &alpha, &alphas, nullptr);
    if (alpha != nullptr)
      std::memcpy(header_.opacity.data(), alpha, static_cast<std::size_t>(alphas));
  }

  // The next pixels of the image.
  void keep(const png_byte* sample, std::size_t count) {
    const std::size_t first = planes_.channel[0].size();
    for (auto& plane : planes_.channel) plane.resize(first + count);
    const bool indexed = header_.colour_type == PNG_COLOR_TYPE_PALETTE;
    for (std::size_t i = first; i < first + count; ++i, sample += header_.samples)
      planes_.set(i, indexed ? entry(*sample, i) : colour(sample, i));
  }

  Rgb8 entry(png_byte index, std::size_t pixel) const {
    if (index >= header_.entries)
      fail("is a damaged PNG file: the pixel at " + place(pixel) + " has index " +
           std::to_string(index) + ", the palette " + std::to_string(header_.entries) + " entries");
    require_opaque(header_.opacity[index], pixel);
    const png_color& colour = header_.palette[index];
    return {colour.red, colour.green, colour.blue};
  }

  Rgb8 colour(const png_byte* sample, std::size_t pixel) const {
    if (header_.samples == 4) require_opaque(sample[3], pixel);
    return {sample[0], sample[1], sample[2]};
  }

  void require_opaque(png_byte opacity, std::size_t pixel) const {
    if (opacity != 255)
      fail("has a transparent pixel at " + place(pixel) + ": only opaque images can be read");
  }

  std::string place(std::size_t pixel) const {
    return "column " + std::to_string(pixel % header_.width) + ", row " +
           std::to_string(pixel / header_.width);
  }

  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  struct Input {
    std::FILE* file;
    std::size_t left = kNoLimit;  // bytes that may be read
  };

  std::string name_;
  std::optional<std::uintmax_t> bytes_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  Input input_{file_.get()};
  PngReason reason_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  Header header_;
  std::unique_ptr<png_byte[]> pixels_;  // of a row, or of all
  Planes planes_;
};

}  // namespace

Planes read_png(const std::filesystem::path& path) {
  std::error_code unknown;  // as of a pipe
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return PngReader(path.string(), std::fopen(path.c_str(), "rb"),
                   unknown ? std::nullopt : std::optional(bytes))
      .read();
}

Planes parse_png(const std::string& name, std::span<const std::uint8_t> bytes) {
  // A stream of the system's, so that both ways read alike; it is never written to.
  auto* start = const_cast<std::uint8_t*>(bytes.data());
  return PngReader(name, ::fmemopen(start, bytes.size(), "rb"), bytes.size()).read();
}

}  // namespace sir::viewer
