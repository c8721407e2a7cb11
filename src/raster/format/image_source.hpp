#pragma once

#include <atomic>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "raster/format/custom_raw.hpp"
#include "raster/format/sample_reader.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/image_value.hpp"
#include "raster/table/image_window.hpp"

namespace sarsim::raster {

/// What an image is, but for the number of its rows, which may grow.
struct ImageInfo {
  const Format* format = nullptr;  ///< Its row in the table; never null once a file is open.
  std::filesystem::path path;
  std::size_t columns = 0;
  ImageValue value = ImageValue::complex;
  bool counts = false;                                          ///< The numbers are A/D counts.
  int bits = 0;                                                 ///< 0 where unknown.
  std::optional<double> lsb_v;                                  ///< Volts of a count, where known.
  std::optional<double> sample_rate_hz;                         ///< Where the file says it.
  std::vector<std::pair<std::string, std::string>> attributes;  ///< Everything else it says of itself: name, value.
};

/// What the caller knows of a file that does not describe itself.
struct ImageHints {
  SampleFileHints samples;       ///< Shape, bits and format of Sarsim's own formats; see `hints_from_scene`.
  std::optional<RawLayout> raw;  ///< Given, the file is read so, whatever it holds.
};

struct OpenedImage;

/// An open file of any size as a table of values, of which any part can be read at any spacing; only what a part needs
/// is read. Functions may be called from many threads at once.
///
/// Nothing is mapped into memory: a file that is cut off or a disk that fails meanwhile gives std::runtime_error
/// (std::system_error) with the file's name.
class ImageSource {
 public:
  /// Opens a file: by the layout of the hints, otherwise by its content, otherwise by its extension. No source and at
  /// least one error where it cannot be read; warnings and notes may come with either. Takes milliseconds for files of
  /// any size, except HDF5, which is tried in a child process first. Texts and run-length encoded pictures are looked
  /// through on a thread of their own, so that their rows come to be known little by little (`rows`, `indexed`).
  [[nodiscard]] static OpenedImage open(const std::filesystem::path& path, const ImageHints& hints = {});

  explicit ImageSource(ImageInfo info) : info_(std::move(info)) {}
  ImageSource(const ImageSource&) = delete;
  ImageSource& operator=(const ImageSource&) = delete;
  virtual ~ImageSource() = default;

  [[nodiscard]] const ImageInfo& info() const { return info_; }
  /// Says by which format the file was opened.
  void set_format(const Format& format) { info_.format = &format; }
  [[nodiscard]] std::size_t columns() const { return info_.columns; }
  /// Rows that can be read now.
  [[nodiscard]] virtual std::size_t rows() const = 0;
  /// Looks whether the file has grown and returns the rows that can be read now; those of a text follow while its new
  /// part is looked through.
  virtual std::size_t refresh() { return rows(); }
  /// How much of the file has been looked through, 0 to 1. Below 1, `rows` still grows.
  [[nodiscard]] virtual double indexed() const { return 1.0; }
  /// Waits until the whole file has been looked through; throws Interrupted where asked to stop.
  virtual void wait_until_indexed(const core::StopFlag*) const {}
  /// What has been found wrong since the file was opened: malformed text, rows of other lengths, pictures cut off.
  [[nodiscard]] virtual core::Problems problems() const { return {}; }
  /// Times, carriers and slant ranges, where the file carries all of them.
  [[nodiscard]] virtual std::optional<SampleAxes> axes() const { return std::nullopt; }

  /// Reads the samples of a window, row by row: counts with their sign and without an offset, volts, levels, powers or,
  /// of colours, the luminance. Real values have no imaginary part; numbers beyond float are infinite.
  /// std::out_of_range for a window that is not inside, std::invalid_argument where `out` has another size; Interrupted
  /// where the stop flag is set. The number of threads changes nothing but the time.
  void read_window(const ImageWindow& window, std::span<std::complex<float>> out,
                   const core::WorkControl& control = {}) const;
  /// The same as colours; std::logic_error where the values are none.
  void read_rgb(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control = {}) const;

  /// Estimated seconds to read a window from memory that the system holds; a disk takes longer.
  [[nodiscard]] virtual double read_cost_s(const ImageWindow& window) const = 0;
  /// A window read in about `seconds`: at the wanted spacing where `read_cost_s` allows it, otherwise at 2, 4, 8 ...
  /// times it in either direction, each sample standing for its neighbours. Learns from each call how much longer than
  /// estimated this file takes here. Returns the window that was really read.
  ImageWindow read_draft(const ImageWindow& window, double seconds, std::span<std::complex<float>> out,
                         const core::WorkControl& control = {}) const;

 protected:
  /// See `read_window`; the arguments are checked already.
  virtual void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                            const core::WorkControl& control) const = 0;
  virtual void read_colours(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control) const;

 private:
  ImageInfo info_;
  mutable std::atomic<double> slowness_{1.0};  // Seconds that drafts took for each that was estimated.
};

/// A source, or at least one error.
struct OpenedImage {
  std::shared_ptr<ImageSource> source;
  core::Problems problems;
};

}  // namespace sarsim::raster
