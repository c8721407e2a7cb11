#pragma once

#include <atomic>
#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "picture/echo/echo_window.hpp"
#include "simulate/plan/plan.hpp"
#include "simulate/run/sampled_rows.hpp"

namespace sarsim::picture {

/// Which samples of a recording a picture shows, and where.
struct SamplePlaces {
  simulate::SampleSelection selection;
  std::vector<std::size_t> row;              ///< Of the recording, for each row of the selection; ascending.
  std::vector<std::size_t> column;           ///< Of the recording, for each column of the selection; ascending.
  std::vector<std::size_t> row_of_pixel;     ///< Row of the selection for each row of pixels, from the top.
  std::vector<std::size_t> column_of_pixel;  ///< Column of the selection for each column of pixels.
};

/// For each pixel the sample nearest to it in time and range (docs/guide/simulation-window.md). With more samples or
/// pulses than pixels that is a subset of the recording's; with PixelRule::peak the samples in between belong to the
/// nearest pixel, as those of one pulse do in any case where data are compressed: their peaks may be one sample wide.
/// Columns of a synthetic range profile, whose ranges overlap, are spread evenly.
[[nodiscard]] SamplePlaces place_samples(const simulate::Plan& plan, const PlotSize& size, PixelRule rule);

/// Room for samples that is used again: a new matrix at every step of a drag would otherwise spend longer on fresh
/// memory than on its echoes. Safe to use from several threads.
class SampleRoom {
 public:
  /// Any `count` values.
  [[nodiscard]] std::vector<std::complex<double>> take(std::size_t count);
  /// Keeps the room of at most two matrices.
  void give_back(std::vector<std::complex<double>> samples);

 private:
  std::mutex lock_;
  std::vector<std::vector<std::complex<double>>> kept_;
};

/// The echo matrix of a window while it is computed: written row by row by worker threads, read by anybody. A row may
/// be read as soon as it is ready and does not change any more.
class EchoMatrix {
 public:
  /// @param window  as asked for; its sampling may differ from the plan's
  /// @param room    where the samples come from and go to; may be null
  EchoMatrix(std::shared_ptr<const simulate::Plan> plan, EchoWindow window, const PlotSize& size,
             std::shared_ptr<SampleRoom> room = nullptr);
  ~EchoMatrix();
  EchoMatrix(const EchoMatrix&) = delete;
  EchoMatrix& operator=(const EchoMatrix&) = delete;

  [[nodiscard]] const simulate::Plan& plan() const { return *plan_; }
  [[nodiscard]] const EchoWindow& window() const { return window_; }
  [[nodiscard]] const PlotSize& size() const { return size_; }
  [[nodiscard]] const SamplePlaces& places() const { return places_; }

  [[nodiscard]] std::size_t rows() const { return places_.row.size(); }
  [[nodiscard]] std::size_t columns() const { return places_.column.size(); }
  [[nodiscard]] bool ready(std::size_t row) const { return ready_[row].load(std::memory_order_acquire); }
  [[nodiscard]] std::size_t ready_rows() const { return ready_rows_.load(std::memory_order_acquire); }
  [[nodiscard]] bool complete() const { return ready_rows() == rows(); }
  /// Samples in volts; of a row that is ready.
  [[nodiscard]] std::span<const std::complex<double>> row(std::size_t row) const {
    return std::span(samples_).subspan(row * columns(), columns());
  }
  /// Of a row that is ready.
  [[nodiscard]] const SampleStatistics& row_statistics(std::size_t row) const { return statistics_[row]; }
  /// For each row the nearest one that is ready by now, itself where it is; empty where none is.
  [[nodiscard]] std::vector<std::size_t> nearest_ready() const;

  [[nodiscard]] std::int64_t pulse(std::size_t row) const {
    return plan_->acquisition.timing.first_pulse_of_row(places_.row[row]);
  }
  [[nodiscard]] double time_s(std::size_t row) const {
    return plan_->acquisition.link.repetition.send_time_s(pulse(row));
  }
  [[nodiscard]] double carrier_hz(std::size_t row) const {
    return plan_->acquisition.link.carrier.carrier_hz(pulse(row));
  }
  [[nodiscard]] double range_m(std::size_t column) const {
    return plan_->acquisition.reception.column_range_m[places_.column[column]];
  }

  /// For those who compute: all samples, and word, once for each row, that it is complete.
  [[nodiscard]] std::span<std::complex<double>> samples() { return samples_; }
  /// The samples of a row are all there; measures them.
  void set_ready(std::size_t row);

 private:
  std::shared_ptr<const simulate::Plan> plan_;
  EchoWindow window_;
  PlotSize size_;
  SamplePlaces places_;
  std::shared_ptr<SampleRoom> room_;
  std::vector<std::complex<double>> samples_;
  std::vector<SampleStatistics> statistics_;  // of each row
  std::vector<std::atomic<bool>> ready_;
  std::atomic<std::size_t> ready_rows_{0};
};

}  // namespace sarsim::picture
