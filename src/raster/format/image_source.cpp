#include "raster/format/image_source.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/report/expect.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/image_openers.hpp"
#include "raster/format/sample_file.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t longest_hdf5_row = std::size_t{1} << 26;  // A whole row is read at a time: 1 GB.

void check_window(const ImageSource& source, const ImageWindow& window, std::size_t room) {
  const std::size_t rows = source.rows();
  if (!fits(window.row0, window.rows, window.row_step, rows) ||
      !fits(window.col0, window.cols, window.col_step, source.columns()))
    throw std::out_of_range(fmt::format("{} x {} samples from row {} and column {}, {} and {} apart, of {} x {}",
                                        window.rows, window.cols, window.row0, window.col0, window.row_step,
                                        window.col_step, rows, source.columns()));
  if (checked_product(window.rows, window.cols) != room)
    throw std::invalid_argument(fmt::format("room for {} samples instead of {} x {}", room, window.rows, window.cols));
}

// Files that SampleFile reads by whole rows.
class SampleFileImage final : public ImageSource {
 public:
  SampleFileImage(ImageInfo info, SampleFile file) : ImageSource(std::move(info)), file_(std::move(file)) {}

  [[nodiscard]] std::size_t rows() const override { return file_.info().rows; }
  [[nodiscard]] std::optional<SampleAxes> axes() const override { return file_.axes(); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return static_cast<double>(window.rows) * (20e-6 + static_cast<double>(columns()) * 6e-9);
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    constexpr std::size_t most_at_once = std::size_t{1} << 18;
    const std::size_t at_once = window.row_step > 1 ? 1 : std::max<std::size_t>(1, most_at_once / columns());
    std::vector<std::complex<double>> rows;
    for (std::size_t i = 0; i < window.rows; i += at_once) {
      if (control.stop != nullptr && control.stop->requested()) throw core::Interrupted();
      const std::size_t count = std::min(at_once, window.rows - i);
      rows.resize(count * columns());
      file_.read_rows(window.row(i), count, rows);
      for (std::size_t r = 0; r < count; ++r)
        for (std::size_t k = 0; k < window.cols; ++k)
          out[(i + r) * window.cols + k] = std::complex<float>(rows[r * columns() + window.column(k)]);
    }
  }

 private:
  SampleFile file_;
};

OpenedImage open_file(core::InputFile file, const ImageHints& hints) {
  const Format* const format = hints.raw ? &custom_format() : detect_format(file, hints.samples, true);
  if (format == nullptr)
    return {nullptr,
            {file_problem(file.path().string(), "the format of the file is not known", {}, {},
                          "describe it as a custom file, or name the script that made it")}};
  OpenedImage opened = format->reader->image(std::move(file), *format, hints);
  if (opened.source) opened.source->set_format(*format);
  return opened;
}

// One direction of a window at a wider spacing.
std::size_t coarse_count(std::size_t count, std::size_t factor) { return (count + factor - 1) / factor; }

ImageWindow coarser(const ImageWindow& window, std::size_t row_factor, std::size_t col_factor) {
  ImageWindow result = window;
  result.rows = coarse_count(window.rows, row_factor);
  result.cols = coarse_count(window.cols, col_factor);
  result.row_step *= row_factor;
  result.col_step *= col_factor;
  return result;
}

}  // namespace

OpenedImage ImageSource::open(const std::filesystem::path& path, const ImageHints& hints) {
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return {nullptr, {std::move(*problem)}};
  auto& file = std::get<core::InputFile>(opened);
  if (file.size() == 0) return {nullptr, {file_problem(path.string(), "the file is empty", {}, "samples")}};
  return open_file(std::move(file), hints);
}

OpenedImage open_sample_image(const std::filesystem::path& path, const SampleFileHints& hints) {
  OpenedSampleFile opened = SampleFile::open(path, hints);
  OpenedImage result{nullptr, std::move(opened.problems)};
  if (!opened.file) return result;
  const SampleFileInfo& known = opened.file->info();
  if (known.columns > longest_hdf5_row) {
    result.problems.push_back(file_problem(path.string(), "the rows are too long to be shown",
                                           fmt::format("{} samples", known.columns),
                                           fmt::format("at most {}", longest_hdf5_row), "convert the file to NPY"));
    return result;
  }
  ImageInfo info;
  info.path = path;
  info.columns = known.columns;
  info.counts = known.counts;
  info.bits = known.bits;
  info.lsb_v = known.lsb_v;
  info.sample_rate_hz = known.sample_rate_hz;
  info.attributes = known.attributes;
  result.source = std::make_shared<SampleFileImage>(std::move(info), std::move(*opened.file));
  return result;
}

void ImageSource::read_window(const ImageWindow& window, std::span<std::complex<float>> out,
                              const core::WorkControl& control) const {
  check_window(*this, window, out.size());
  if (!out.empty()) read_samples(window, out, control);
}

void ImageSource::read_rgb(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control) const {
  if (info_.value != ImageValue::rgb) throw std::logic_error("an image without colours was asked for them");
  check_window(*this, window, out.size());
  if (!out.empty()) read_colours(window, out, control);
}

void ImageSource::read_colours(const ImageWindow&, std::span<Rgb>, const core::WorkControl&) const {
  throw std::logic_error("an image without colours was asked for them");
}

ImageWindow ImageSource::read_draft(const ImageWindow& window, double seconds, std::span<std::complex<float>> out,
                                    const core::WorkControl& control) const {
  CORE_EXPECT(seconds >= 0.0);
  check_window(*this, window, out.size());
  if (out.empty()) return window;
  seconds /= slowness_.load(std::memory_order_relaxed);
  std::size_t row_factor = 1;
  std::size_t col_factor = 1;
  while (read_cost_s(coarser(window, row_factor, col_factor)) > seconds) {
    const bool rows_left = row_factor < window.rows;
    const bool cols_left = col_factor < window.cols;
    if (!rows_left && !cols_left) break;
    const double fewer_rows = read_cost_s(coarser(window, 2 * row_factor, col_factor));
    const double fewer_cols = read_cost_s(coarser(window, row_factor, 2 * col_factor));
    // What saves more; of equals, what keeps the blocks square.
    const bool by_rows = fewer_rows < 0.9 * fewer_cols || (fewer_rows < 1.1 * fewer_cols && row_factor <= col_factor);
    (rows_left && (by_rows || !cols_left) ? row_factor : col_factor) *= 2;
  }
  const ImageWindow coarse = coarser(window, row_factor, col_factor);
  const bool exact = coarse == window;
  std::vector<std::complex<float>> samples(exact ? 0 : coarse.samples());
  const auto begin = std::chrono::steady_clock::now();
  read_window(coarse, exact ? out : std::span(samples), control);
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  // One slow call is no rule, and times far below a millisecond are none either.
  const double old = slowness_.load(std::memory_order_relaxed);
  if (taken > 1e-3) slowness_.store(std::clamp(std::sqrt(old * taken / read_cost_s(coarse)), 0.25, 1000.0));
  if (exact) return window;
  for (std::size_t i = 0; i < window.rows; ++i)
    for (std::size_t k = 0; k < window.cols; ++k)
      out[i * window.cols + k] = samples[i / row_factor * coarse.cols + k / col_factor];
  return coarse;
}

}  // namespace sarsim::raster
