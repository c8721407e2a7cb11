#include "raster/format/grid_raster.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <utility>
#include <vector>

namespace sarsim::raster {

namespace {

// Rows of samples of a fixed size.
class GridRaster : public Raster {
 public:
  // max_rows: rows that the file claims; more are never shown.
  GridRaster(RasterInfo info, core::InputFile file, const StoredGrid& grid, std::uint64_t max_rows)
      : Raster(std::move(info)), file_(std::move(file)), grid_(grid), max_rows_(max_rows) {
    rows_ = rows_in(file_.size());
  }

  [[nodiscard]] std::size_t rows() const override { return rows_.load(std::memory_order_acquire); }
  std::size_t refresh() override {
    rows_.store(rows_in(file_.current_size()), std::memory_order_release);
    return rows();
  }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override { return grid_cost_s(grid_, window); }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    read_grid(file_, grid_, window, out, control);
  }
  void read_whole_rows(std::size_t first, std::size_t, std::span<std::complex<double>> out) const override {
    read_grid_rows(file_, grid_, first, out);
  }
  [[nodiscard]] const core::InputFile& file() const { return file_; }
  [[nodiscard]] const StoredGrid& grid() const { return grid_; }

 private:
  [[nodiscard]] std::size_t rows_in(std::uint64_t bytes) const {
    const std::uint64_t present = bytes - std::min(bytes, grid_.offset);
    return static_cast<std::size_t>(std::min(max_rows_, present / grid_.row_bytes()));
  }

  core::InputFile file_;
  StoredGrid grid_;
  std::uint64_t max_rows_;
  std::atomic<std::size_t> rows_{0};
};

// Colours: luminances, or the colours themselves in the 24 bits of a float's mantissa, so that `read_grid` can carry
// them.
template <class Real, bool Packed>
void decode_rgb(const StoredGrid&, const std::byte* first, std::size_t stride, std::size_t count,
                std::complex<Real>* out) {
  for (std::size_t i = 0; i < count; ++i, first += stride) {
    const Rgb colour{std::to_integer<std::uint8_t>(first[0]), std::to_integer<std::uint8_t>(first[1]),
                     std::to_integer<std::uint8_t>(first[2])};
    const std::uint32_t packed = std::uint32_t{colour.red} << 16U | std::uint32_t{colour.green} << 8U | colour.blue;
    out[i] = {Packed ? static_cast<Real>(packed) : static_cast<Real>(luminance(colour)), Real{}};
  }
}

class ColourGridRaster final : public GridRaster {
 public:
  using GridRaster::GridRaster;

 protected:
  void read_colours(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control) const override {
    StoredGrid packed = grid();
    packed.decode.window = decode_rgb<float, true>;
    std::vector<std::complex<float>> values(out.size());
    read_grid(file(), packed, window, values, control);
    std::ranges::transform(values, out.begin(), [](const std::complex<float>& value) {
      const auto colour = static_cast<std::uint32_t>(value.real());
      return Rgb{static_cast<std::uint8_t>(colour >> 16U), static_cast<std::uint8_t>(colour >> 8U),
                 static_cast<std::uint8_t>(colour)};
    });
  }
};

// An array in Fortran order: its columns are the rows of the file.
class TransposedRaster final : public Raster {
 public:
  TransposedRaster(RasterInfo info, core::InputFile file, const StoredGrid& grid)
      : Raster(std::move(info)), file_(std::move(file)), grid_(grid) {}

  [[nodiscard]] std::size_t rows() const override { return grid_.columns; }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return grid_cost_s(grid_, turned(window));
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    std::vector<std::complex<float>> stored(out.size());
    read_grid(file_, grid_, turned(window), stored, control);
    for (std::size_t k = 0; k < window.cols; ++k)
      for (std::size_t i = 0; i < window.rows; ++i) out[i * window.cols + k] = stored[k * window.rows + i];
  }

  void read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    std::vector<std::byte> bytes(count * grid_.sample_bytes);
    std::vector<std::complex<double>> column(count);
    for (std::size_t k = 0; k < columns(); ++k) {
      file_.read_all_at(grid_.offset + std::uint64_t{k} * grid_.row_bytes() + first * grid_.sample_bytes, bytes);
      grid_.decode.rows(grid_, bytes.data(), grid_.sample_bytes, count, column.data());
      for (std::size_t i = 0; i < count; ++i) out[i * columns() + k] = column[i];
    }
  }

 private:
  static ImageWindow turned(const ImageWindow& window) {
    return {window.col0, window.cols, window.row0, window.rows, window.col_step, window.row_step};
  }

  core::InputFile file_;
  StoredGrid grid_;
};

}  // namespace

StoredGrid::Decoder rgb_decoder() { return {decode_rgb<float, false>, decode_rgb<double, false>}; }

RasterInfo info_of(const core::InputFile& file, std::size_t columns, const RasterHints& hints) {
  RasterInfo info;
  info.path = file.path();
  info.columns = columns;
  if (hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  return info;
}

std::shared_ptr<Raster> make_grid_raster(RasterInfo info, core::InputFile file, const StoredGrid& grid,
                                         std::uint64_t max_rows) {
  if (info.value == ImageValue::rgb)
    return std::make_shared<ColourGridRaster>(std::move(info), std::move(file), grid, max_rows);
  return std::make_shared<GridRaster>(std::move(info), std::move(file), grid, max_rows);
}

std::shared_ptr<Raster> make_transposed_raster(RasterInfo info, core::InputFile file, const StoredGrid& grid) {
  return std::make_shared<TransposedRaster>(std::move(info), std::move(file), grid);
}

}  // namespace sarsim::raster
