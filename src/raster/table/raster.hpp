#pragma once

#include <atomic>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/report/problem.hpp"
#include "core/task/parallel.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/image_places.hpp"
#include "raster/table/image_value.hpp"
#include "raster/table/image_window.hpp"
#include "raster/table/sink.hpp"
#include "raster/table/value_rule.hpp"

namespace sarsim::raster {

/// What a raster is, but for the number of its rows, which may grow.
struct RasterInfo {
  const Format* format = nullptr;  ///< Its row in the table; null where it comes from no file.
  std::filesystem::path path;      ///< Empty where it comes from no file.
  std::size_t columns = 0;
  ImageValue value = ImageValue::complex;
  bool counts = false;                                          ///< The numbers are A/D counts; otherwise volts.
  int bits = 0;                                                 ///< 0 where unknown.
  std::optional<double> lsb_v;                                  ///< Volts of a count, where known.
  std::optional<double> sample_rate_hz;                         ///< Where it is known.
  std::optional<FocusedPlaces> places;                          ///< Of images whose file says where their pixels are.
  std::vector<std::pair<std::string, std::string>> attributes;  ///< Everything else it says of itself: name, value.
};

/// The axes of a recording.
struct RasterAxes {
  std::vector<double> row_time_s;             ///< Send time of each row's (first) pulse.
  std::vector<double> row_carrier_hz;         ///< Its carrier.
  std::vector<double> column_range_m;         ///< One-way slant range of each column; of images `column_axis`.
  std::vector<RowPose> row_pose = {};         ///< The radar's platform then; empty where the file does not say.
  std::vector<double> row_m = {};             ///< Of images: place of each row, m; otherwise empty.
  std::string row_axis = {};                  ///< Name of that axis, see ImageAxes.
  std::string column_axis = "slant_range_m";  ///< Name of the axis of columns.
};

/// A table of samples of any size: a file, or what is computed. Any part of it can be read at any spacing; only what a
/// part needs is read, in bounded memory. Functions may be called from many threads at once.
///
/// Nothing is mapped into memory: a file that is cut off or a disk that fails meanwhile gives std::runtime_error
/// (std::system_error) with the file's name.
class Raster {
 public:
  explicit Raster(RasterInfo info) : info_(std::move(info)) {}
  Raster(const Raster&) = delete;
  Raster& operator=(const Raster&) = delete;
  virtual ~Raster() = default;

  [[nodiscard]] const RasterInfo& info() const { return info_; }
  /// Says by which format the file was opened.
  void set_format(const Format& format) { info_.format = &format; }
  /// Sets how the numbers of the file become samples; applied whenever samples are read.
  void set_value_rule(ValueRule rule) { rule_ = std::move(rule); }
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
  [[nodiscard]] virtual std::optional<RasterAxes> axes() const { return std::nullopt; }

  /// Reads the samples of a window, row by row: counts with their sign and without an offset, volts, levels, powers or,
  /// of colours, the luminance. Real values have no imaginary part; numbers beyond float are infinite.
  /// std::out_of_range for a window that is not inside, std::invalid_argument where `out` has another size; Interrupted
  /// where the stop flag is set. The number of threads changes nothing but the time.
  void read_window(const ImageWindow& window, std::span<std::complex<float>> out,
                   const core::WorkControl& control = {}) const;
  /// The same as colours; std::logic_error where the values are none.
  void read_rgb(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control = {}) const;
  /// Reads the whole rows [first, first + count), one after the other, count * columns samples, on the calling thread:
  /// counts as they are (exact up to 2^53), or volts. std::out_of_range for rows that are not there,
  /// std::invalid_argument where `out` has another size, std::runtime_error where the file has been changed meanwhile
  /// or the disk fails.
  void read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const;

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
  /// See `read_rows`; the arguments are checked already. By way of `read_samples` where a raster has nothing better,
  /// which suits those whose numbers are floats.
  virtual void read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const;

 private:
  RasterInfo info_;
  ValueRule rule_;
  mutable std::atomic<double> slowness_{1.0};  // Seconds that drafts took for each that was estimated.
};

/// A raster, or at least one error. Warnings and notes may come with either.
struct OpenedRaster {
  std::shared_ptr<Raster> raster;
  core::Problems problems;
  std::optional<RasterAxes> axes{};  ///< Those of the raster, where opening has read them: they need not be read again.
};

}  // namespace sarsim::raster
