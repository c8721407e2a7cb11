#include <algorithm>
#include <array>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "raster/format/format_reader.hpp"
#include "raster/format/sun_raster.hpp"
#include "raster/format/sun_run_length.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/row_index.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t sun_chunk_bytes = std::size_t{48} << 10;  // A multiple of 8 pixels of any depth.

using RunIndex = RowIndex<SunRunDecoder::State>;

class SunPicture final : public Raster {
 public:
  SunPicture(RasterInfo info, core::InputFile file, SunPixels pixels)
      : Raster(std::move(info)),
        file_(std::move(file)),
        pixels_(std::move(pixels)),
        index_(mark_spacing(file_.size())) {
    if (packed()) index_.start(file_.path().string(), [this](RunIndex::Recorder& recorder) { look_through(recorder); });
  }

  [[nodiscard]] std::size_t rows() const override { return packed() ? index_.rows() : header().height; }
  [[nodiscard]] double indexed() const override { return packed() ? index_.done() : 1.0; }
  void wait_until_indexed(const core::StopFlag* stop) const override {
    if (packed()) index_.wait(stop);
  }
  [[nodiscard]] core::Problems problems() const override { return index_.problems(); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    const double extent =
        static_cast<double>(window.cols) * static_cast<double>(window.col_step) * header().depth / 8.0;
    return static_cast<double>(window.rows) * (extent * (packed() ? 1e-9 : 0.2e-9) + 1e-6) +
           static_cast<double>(window.samples()) * 5e-9;
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    const bool grey = pixels_.grey();
    read_pixels(window, control, [&](std::size_t index, Rgb colour) {
      out[index] = {grey ? static_cast<float>(colour.red) : luminance(colour), 0.0F};
    });
  }
  void read_colours(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control) const override {
    read_pixels(window, control, [&](std::size_t index, Rgb colour) { out[index] = colour; });
  }

 private:
  [[nodiscard]] const SunRasterHeader& header() const { return pixels_.header(); }
  [[nodiscard]] bool packed() const { return header().type == SunType::run_length; }

  void look_through(RunIndex::Recorder& recorder) {
    SunRunDecoder decoder(file_, {header().data_offset(), 0, {}});
    for (std::size_t row = 0; row < header().height && !recorder.stop_wanted(); ++row) {
      recorder.row_begins(row, decoder.state().offset, decoder.state());
      const std::uint64_t decoded = decoder.skip(header().row_bytes());
      // Some programs leave out the padding of the last row.
      if (decoded < (std::uint64_t{header().width} * header().depth + 7) / 8) {
        recorder.problem(
            with_severity(file_problem(file_.path().string(), "the file ends within the picture",
                                       fmt::format("{} rows", row), fmt::format("{} rows", header().height),
                                       "the file is cut off; the rows that are there are shown"),
                          core::Severity::warning));
        return;
      }
      recorder.rows_known(row + 1);
      recorder.part_done(static_cast<double>(row) / header().height);
    }
  }

  // Calls put(index in the window, colour) for every pixel of a window.
  template <class Put>
  void read_pixels(const ImageWindow& window, const core::WorkControl& control, const Put& put) const {
    if (window.samples() == 0) return;
    const std::size_t grain = std::max<std::size_t>(1, (std::size_t{1} << 16U) / window.cols);
    core::parallel_ranges(window.rows, grain, control, [&](std::size_t begin, std::size_t end) {
      packed() ? read_packed(window, begin, end, put) : read_plain(window, begin, end, put);
    });
  }

  // The bytes that hold the window's columns, in chunks of whole groups of 8 pixels: put_chunk(first byte, bytes).
  struct Extent {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
  };
  [[nodiscard]] Extent extent(const ImageWindow& window) const {
    const std::uint64_t depth = header().depth;
    return {window.col0 / 8 * depth, (std::uint64_t{window.column(window.cols - 1)} * depth + depth + 7) / 8};
  }

  template <class Put>
  void put_chunk(const ImageWindow& window, std::size_t row, std::uint64_t first, std::span<const std::byte> bytes,
                 std::size_t& next, const Put& put) const {
    const std::uint64_t end_column = (first + bytes.size()) * 8 / header().depth;
    for (; next < window.cols && window.column(next) < end_column; ++next)
      put(row * window.cols + next, pixels_.colour(bytes, first, window.column(next)));
  }

  template <class Put>
  void read_plain(const ImageWindow& window, std::size_t begin, std::size_t end, const Put& put) const {
    const Extent range = extent(window);
    std::vector<std::byte> buffer;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint64_t row_offset = header().data_offset() + window.row(i) * header().row_bytes();
      std::size_t next = 0;
      for (std::uint64_t at = range.first; at < range.last; at += sun_chunk_bytes) {
        buffer.resize(static_cast<std::size_t>(std::min<std::uint64_t>(sun_chunk_bytes, range.last - at)));
        file_.read_all_at(row_offset + at, buffer);
        put_chunk(window, i, at, buffer, next, put);
      }
    }
  }

  template <class Put>
  void read_packed(const ImageWindow& window, std::size_t begin, std::size_t end, const Put& put) const {
    const Extent range = extent(window);
    std::vector<std::byte> buffer;
    for (std::size_t i = begin; i < end;) {
      const auto [row, state] = index_.before(window.row(i));
      SunRunDecoder decoder(file_, state);
      std::uint64_t at_row = row;
      for (; i < end && (window.row_step == 1 || index_.before(window.row(i)).first == row); ++i) {
        skip(decoder, (window.row(i) - at_row) * header().row_bytes() + range.first);
        std::size_t next = 0;
        for (std::uint64_t at = range.first; at < range.last; at += sun_chunk_bytes) {
          buffer.resize(static_cast<std::size_t>(std::min<std::uint64_t>(sun_chunk_bytes, range.last - at)));
          if (decoder.take(buffer) < buffer.size()) fail();
          put_chunk(window, i, at, buffer, next, put);
        }
        // The last row may lack its padding; nothing follows it.
        (void)decoder.skip(header().row_bytes() - range.last);
        at_row = window.row(i) + 1;
      }
    }
  }

  void skip(SunRunDecoder& decoder, std::uint64_t bytes) const {
    if (decoder.skip(bytes) < bytes) fail();
  }
  [[noreturn]] void fail() const {
    throw std::runtime_error("cannot read " + file_.path().string() + ": it has become shorter");
  }

  core::InputFile file_;
  SunPixels pixels_;
  RunIndex index_;  // Last: its thread uses the others.
};

}  // namespace

OpenedRaster open_sun(core::InputFile file, const Format&, const RasterHints&, Integrity, const core::StopFlag*) {
  auto read = read_sun_header(file);
  if (auto* problem = std::get_if<core::Problem>(&read)) return {nullptr, {std::move(*problem)}};
  const SunRasterHeader& header = std::get<SunRasterHeader>(read);
  SunPixels pixels(file, header);
  core::Problems problems;
  if (header.map_length > 0 && (header.depth > 8 || header.map_type != 1))
    problems.push_back(
        with_severity(file_problem(file.path().string(), "the colour map is not used",
                                   fmt::format("type {} with {} bits of a pixel", header.map_type, header.depth)),
                      core::Severity::note));
  RasterInfo info;
  info.path = file.path();
  info.columns = header.width;
  info.value = pixels.grey() ? ImageValue::real : ImageValue::rgb;
  info.attributes = {{"type", fmt::format("{}", static_cast<unsigned>(header.type))},
                     {"depth", fmt::format("{}", header.depth)},
                     {"colour map", fmt::format("{} bytes", header.map_length)}};
  return {std::make_shared<SunPicture>(std::move(info), std::move(file), std::move(pixels)), std::move(problems)};
}

}  // namespace sarsim::raster
