#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "raster/table/raster.hpp"

namespace sarsim::raster {

/// A raster of a fixed shape whose samples a function gives: a product in memory, a part of another raster.
class ComputedRaster final : public Raster {
 public:
  /// Gives the samples of a window, row by row. Called from several threads at once; what it throws comes out of
  /// whatever asked for the samples.
  using Read = std::function<void(const ImageWindow&, std::span<std::complex<float>>)>;

  /// Either of rows and columns may be 0.
  ComputedRaster(std::size_t rows, std::size_t columns, Read read)
      : Raster(info_of(columns)), rows_(rows), read_(std::move(read)) {}

  /// The same of what is described like a file.
  ComputedRaster(RasterInfo info, std::size_t rows, std::optional<RasterAxes> axes, Read read)
      : Raster(std::move(info)), rows_(rows), axes_(std::move(axes)), read_(std::move(read)) {}

  [[nodiscard]] std::size_t rows() const override { return rows_; }
  [[nodiscard]] std::optional<RasterAxes> axes() const override { return axes_; }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return static_cast<double>(window.samples()) * 10e-9;
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl&) const override {
    read_(window, out);
  }

 private:
  static RasterInfo info_of(std::size_t columns) {
    RasterInfo info;
    info.columns = columns;
    return info;
  }

  std::size_t rows_;
  std::optional<RasterAxes> axes_;
  Read read_;
};

/// The first rows of a raster that may grow: as many as there are now, for what needs a fixed shape.
[[nodiscard]] inline std::shared_ptr<const Raster> first_rows(const std::shared_ptr<const Raster>& raster,
                                                              std::size_t rows) {
  return std::make_shared<ComputedRaster>(
      rows, raster->columns(),
      [raster](const ImageWindow& window, std::span<std::complex<float>> out) { raster->read_window(window, out); });
}

}  // namespace sarsim::raster
