#include "raster/format/text_raster.hpp"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t max_listed_rows = 10;
constexpr double byte_s = 8e-9;  // Of reading numbers, measured.

// Puts the numbers of a row where a window wants them.
template <class Real>
class WindowRow {
 public:
  WindowRow(const TextSamples& samples, const ImageWindow& window)
      : samples_(samples),
        before_(window.col0 * samples.components),
        between_((window.col_step - 1) * samples.components),
        stride_(samples.components == 2 ? 1 : 2) {}

  // The next row; empty: none of its samples is wanted.
  void begin(std::span<std::complex<Real>> out) {
    at_ = reinterpret_cast<Real*>(out.data());  // Numbers of a complex array lie as those of an array.
    end_ = at_ + 2 * out.size();
    skip_ = before_;
    left_ = samples_.components;
  }
  void put(const TextNumber& number) {
    if (at_ == end_) return;
    if (skip_ > 0) {
      --skip_;
      return;
    }
    *at_ = samples_.decoded<Real>(number);
    at_ += stride_;
    if (between_ == 0 || --left_ > 0) return;
    left_ = samples_.components;
    skip_ = between_;
  }

 private:
  const TextSamples& samples_;
  std::size_t before_;  // Numbers before the first sample that is wanted, and between two of them.
  std::size_t between_;
  std::ptrdiff_t stride_;
  Real* at_ = nullptr;
  Real* end_ = nullptr;
  std::size_t skip_ = 0;  // Numbers that are not wanted now.
  std::size_t left_ = 0;  // Numbers of the sample that are still to come.
};

class TextRaster final : public Raster {
 public:
  // A whole text.
  TextRaster(RasterInfo info, core::InputFile file, const TextSamples& samples, std::unique_ptr<TextIndex> index)
      : Raster(std::move(info)),
        file_(std::move(file)),
        samples_(samples),
        whole_(true),
        row_bytes_(file_.size() / std::max<std::size_t>(index->rows(), 1)),
        index_(std::move(index)) {}
  // One that may grow.
  TextRaster(RasterInfo info, core::InputFile file, const TextSamples& samples, TextMark begin, std::uint64_t row_bytes)
      : Raster(std::move(info)),
        file_(std::move(file)),
        samples_(samples),
        row_bytes_(row_bytes),
        resume_{begin},
        index_(std::make_unique<TextIndex>(mark_spacing(file_.size()))) {
    begin_index(file_.size());
  }

  [[nodiscard]] std::size_t rows() const override { return index_->rows(); }
  std::size_t refresh() override {
    if (whole_) return rows();
    const std::scoped_lock hold(refresh_lock_);
    const std::uint64_t size = file_.current_size();
    if (size > indexed_bytes_ && !index_->running() && !damaged_) begin_index(size);
    return rows();
  }
  [[nodiscard]] double indexed() const override { return index_->done(); }
  void wait_until_indexed(const core::StopFlag* stop) const override { index_->wait(stop); }
  [[nodiscard]] core::Problems problems() const override { return index_->problems(); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return static_cast<double>(window.rows) * static_cast<double>(row_bytes_) * byte_s;
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    if (window.samples() == 0) return;
    const std::size_t grain = std::max<std::size_t>(1, (std::size_t{1} << 14U) / columns());
    core::parallel_ranges(window.rows, grain, control, [&](std::size_t begin, std::size_t end) {
      read_range(window, begin, end, out.subspan(begin * window.cols, (end - begin) * window.cols));
    });
  }
  void read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    read_range({first, count, 0, columns()}, 0, count, out);
  }

 private:
  using Recorder = TextIndex::Recorder;

  // Where the last row that was looked at begins.
  struct Resume {
    TextMark mark;
    std::size_t row = 0;
  };

  void begin_index(std::uint64_t size) {
    indexed_bytes_ = size;
    index_->start(file_.path().string(), [this, size](Recorder& recorder) { look_through(recorder, size); });
  }

  void look_through(Recorder& recorder, std::uint64_t size) {
    std::size_t row = resume_.row;
    TextScanner scanner(file_, resume_.mark.offset, resume_.mark.line);
    std::optional<double> misfit;
    TextRowParser parser(scanner, samples_.layout, [&](const TextNumber& number) {
      if (!misfit && samples_.misfits(number)) misfit = number.value;
    });
    while (!recorder.stop_wanted()) {
      scanner.skip_white_space();
      misfit.reset();
      const TextMark mark{scanner.offset(), scanner.line()};
      const TextRow found = parser.parse();
      scanner.skip_white_space();
      const bool last = scanner.peek() == TextScanner::end;
      if (found.values == 0 && !found.malformed) break;
      resume_ = {mark, row};
      if (last && (found.malformed || found.values < samples_.values)) break;  // Cut off, or still being written.
      if (found.malformed) {
        core::Problem problem = *found.malformed;
        problem.place.file = file_.path().string();
        problem.hint = "the rows before it are shown";
        recorder.problem(std::move(problem));
        damaged_ = true;
        break;
      }
      if (misfit) {
        report_misfit(recorder, mark, *misfit);
        break;
      }
      if (found.values != samples_.values) report_uneven(recorder, found, row);
      recorder.row_begins(row, mark.offset, mark);
      recorder.rows_known(++row);
      recorder.part_done(static_cast<double>(scanner.offset()) / static_cast<double>(std::max<std::uint64_t>(size, 1)));
      if (last) break;
    }
  }

  void report_misfit(Recorder& recorder, const TextMark& mark, double value) {
    core::Problem problem = file_problem(
        file_.path().string(), "a value is not that of an A/D converter with an offset", fmt::format("{}", value),
        fmt::format("0 to {}, as in the first row", samples_.offset->highest_stored()),
        "omit the A/D bits to read the values unchanged; the rows before it are shown");
    problem.place.line = mark.line;
    recorder.problem(std::move(problem));
    damaged_ = true;
  }

  void report_uneven(Recorder& recorder, const TextRow& found, std::size_t row) {
    if (++uneven_rows_ > max_listed_rows) return;
    core::Problem problem = with_severity(
        file_problem(file_.path().string(), fmt::format("row {} has another length", row + 1),
                     fmt::format("{} numbers", found.values), fmt::format("{}, as in the first row", samples_.values),
                     "what is missing is shown as 0, what is too much is left out"),
        core::Severity::warning);
    problem.place.line = found.line;
    problem.place.column = found.column;
    recorder.problem(std::move(problem));
  }

  // Rows [begin, end) of a window.
  template <class Real>
  void read_range(const ImageWindow& window, std::size_t begin, std::size_t end,
                  std::span<std::complex<Real>> out) const {
    WindowRow<Real> target(samples_, window);
    const auto put = [&](const TextNumber& number) { target.put(number); };
    for (std::size_t i = begin; i < end;) {
      // As far as one mark leads; the next rows may have a nearer one.
      auto [row, mark] = index_->before(window.row(i));
      const std::size_t marked = row;
      TextScanner scanner(file_, mark.offset, mark.line);
      TextRowParser parser(scanner, samples_.layout, put);
      for (; i < end && (window.row_step == 1 || index_->before(window.row(i)).first == marked); ++i, ++row) {
        target.begin({});
        for (; row < window.row(i); ++row) expect_row(parser.parse());
        const auto wanted = out.subspan((i - begin) * window.cols, window.cols);
        if (!whole_) std::ranges::fill(wanted, std::complex<Real>());
        target.begin(wanted);
        expect_row(parser.parse());
      }
    }
  }

  void expect_row(const TextRow& found) const {
    if (found.malformed || found.values == 0 || (whole_ && found.values != samples_.values))
      throw std::runtime_error("cannot read " + file_.path().string() + ": it has been changed");
  }

  core::InputFile file_;
  TextSamples samples_;
  bool whole_ = false;
  std::uint64_t row_bytes_;
  std::mutex refresh_lock_;
  std::uint64_t indexed_bytes_ = 0;
  Resume resume_;  // Of the thread of the index.
  std::size_t uneven_rows_ = 0;
  bool damaged_ = false;
  std::unique_ptr<TextIndex> index_;  // Last: its thread uses the others.
};

}  // namespace

std::shared_ptr<Raster> make_whole_text(RasterInfo info, core::InputFile file, const TextSamples& samples,
                                        std::unique_ptr<TextIndex> index) {
  return std::make_shared<TextRaster>(std::move(info), std::move(file), samples, std::move(index));
}

std::shared_ptr<Raster> make_growing_text(RasterInfo info, core::InputFile file, const TextSamples& samples,
                                          TextMark begin, std::uint64_t row_bytes) {
  return std::make_shared<TextRaster>(std::move(info), std::move(file), samples, begin, row_bytes);
}

}  // namespace sarsim::raster
