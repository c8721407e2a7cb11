#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include <fmt/format.h>

#include "raster/format/image_openers.hpp"
#include "raster/format/npy_array.hpp"
#include "raster/table/count_range.hpp"

namespace sarsim::raster {

namespace {

// Rows of samples of a fixed size.
class GridImage : public ImageSource {
 public:
  // most_rows: rows that the file claims; more are never shown.
  GridImage(ImageInfo info, core::InputFile file, const StoredGrid& grid, std::uint64_t most_rows)
      : ImageSource(std::move(info)), file_(std::move(file)), grid_(grid), most_rows_(most_rows) {
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
  [[nodiscard]] const core::InputFile& file() const { return file_; }
  [[nodiscard]] const StoredGrid& grid() const { return grid_; }

 private:
  [[nodiscard]] std::size_t rows_in(std::uint64_t bytes) const {
    const std::uint64_t present = bytes - std::min(bytes, grid_.offset);
    return static_cast<std::size_t>(std::min(most_rows_, present / grid_.row_bytes()));
  }

  core::InputFile file_;
  StoredGrid grid_;
  std::uint64_t most_rows_;
  std::atomic<std::size_t> rows_{0};
};

constexpr std::uint64_t any_rows = INT64_MAX;

template <std::size_t Bytes>
void decode_counts(const StoredGrid& grid, const std::byte* first, std::size_t stride, std::size_t count,
                   std::complex<float>* out) {
  const auto value = [&](const std::byte* bytes) {
    std::uint64_t stored = 0;
    std::memcpy(&stored, bytes, Bytes);
    return static_cast<float>(std::bit_cast<std::int64_t>(stored - grid.count_offset));
  };
  for (std::size_t i = 0; i < count; ++i, first += stride) out[i] = {value(first), value(first + Bytes)};
}

constexpr std::array<StoredGrid::Decode, 8> count_decoders{decode_counts<1>, decode_counts<2>, decode_counts<3>,
                                                           decode_counts<4>, decode_counts<5>, decode_counts<6>,
                                                           decode_counts<7>, decode_counts<8>};

// Colours: luminances, or the colours themselves in the 24 bits of a float's mantissa, so that `read_grid` can carry
// them.
template <bool Packed>
void decode_rgb(const StoredGrid&, const std::byte* first, std::size_t stride, std::size_t count,
                std::complex<float>* out) {
  for (std::size_t i = 0; i < count; ++i, first += stride) {
    const Rgb colour{std::to_integer<std::uint8_t>(first[0]), std::to_integer<std::uint8_t>(first[1]),
                     std::to_integer<std::uint8_t>(first[2])};
    const std::uint32_t packed = std::uint32_t{colour.red} << 16U | std::uint32_t{colour.green} << 8U | colour.blue;
    out[i] = {Packed ? static_cast<float>(packed) : luminance(colour), 0.0F};
  }
}

class ColourGridImage final : public GridImage {
 public:
  using GridImage::GridImage;

 protected:
  void read_colours(const ImageWindow& window, std::span<Rgb> out, const core::WorkControl& control) const override {
    StoredGrid packed = grid();
    packed.decode = decode_rgb<true>;
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
class TransposedImage final : public ImageSource {
 public:
  TransposedImage(ImageInfo info, core::InputFile file, const StoredGrid& grid)
      : ImageSource(std::move(info)), file_(std::move(file)), grid_(grid) {}

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

 private:
  static ImageWindow turned(const ImageWindow& window) {
    return {window.col0, window.cols, window.row0, window.rows, window.col_step, window.row_step};
  }

  core::InputFile file_;
  StoredGrid grid_;
};

OpenedImage refused(core::Problem problem) { return {nullptr, {std::move(problem)}}; }

ImageInfo info_of(const core::InputFile& file, std::size_t columns) {
  ImageInfo info;
  info.path = file.path();
  info.columns = columns;
  return info;
}

core::Problem shape_problem(const std::string& name, const NpyHeader& header) {
  return file_problem(name,
                      header.fortran_order ? "the array's shape cannot be shown in Fortran order"
                                           : "the array's shape is not one of an image",
                      shape_text(header.shape),
                      "(rows, columns), (rows, columns, 2) for I and Q, or 3 bytes for colours");
}

OpenedImage make_npy(core::InputFile file, const NpyHeader& header, const NpyType& type, const NpyPlane& plane,
                     const SampleFileHints& hints) {
  const std::string name = file.path().string();
  ImageInfo info = info_of(file, static_cast<std::size_t>(plane.columns));
  info.value = plane.value;
  info.counts = type.counts && plane.value == ImageValue::complex;
  info.bits = info.counts ? std::max(hints.bits, 0) : 0;
  if (hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  info.attributes = {{"descr", header.type}};
  StoredGrid grid;
  grid.offset = header.data_offset;
  grid.columns = info.columns;
  grid.sample_bytes = type.bytes * (type.pair ? 2U : 1U) * static_cast<std::size_t>(plane.components);
  grid.decode = plane.value == ImageValue::rgb
                    ? decode_rgb<false>
                    : type.decoder(plane.value == ImageValue::complex, header.type.starts_with('>'), false);
  const std::uint64_t present = file.size() - std::min<std::uint64_t>(file.size(), header.data_offset);
  const auto whole = checked_product(plane.rows, plane.columns, grid.sample_bytes);
  if (!whole || grid.row_bytes() > present || (header.fortran_order && *whole > present))
    return refused(file_problem(name, "the file ends within the array", fmt::format("{} bytes", present),
                                fmt::format("{} of {} bytes each", shape_text(header.shape), type.bytes),
                                "the file is cut off"));
  core::Problems problems;
  if (present < *whole)
    problems.push_back(
        with_severity(file_problem(name, "the file ends within the array", fmt::format("{} bytes", present),
                                   fmt::format("{} bytes for the shape {}", *whole, shape_text(header.shape)),
                                   "what is there is shown"),
                      core::Severity::warning));
  if (present > *whole)
    problems.push_back(with_severity(
        file_problem(name, "what follows the array is not read", fmt::format("{} bytes more", present - *whole)),
        core::Severity::note));
  if (header.fortran_order) {
    grid.columns = static_cast<std::size_t>(plane.rows);
    return {std::make_shared<TransposedImage>(std::move(info), std::move(file), grid), std::move(problems)};
  }
  if (plane.value == ImageValue::rgb)
    return {std::make_shared<ColourGridImage>(std::move(info), std::move(file), grid, plane.rows), std::move(problems)};
  return {std::make_shared<GridImage>(std::move(info), std::move(file), grid, plane.rows), std::move(problems)};
}

}  // namespace

OpenedImage open_raw_image(core::InputFile file, const RawLayout& layout) {
  OpenedImage opened{nullptr, check_raw_layout(layout, file.path().string(), file.size())};
  if (core::has_errors(opened.problems)) return opened;
  ImageInfo info = info_of(file, layout.width);
  info.value = layout.value;
  info.attributes = {{"layout", to_string(layout)}};
  const std::uint64_t most = layout.height > 0 ? layout.height : any_rows;
  opened.source = std::make_shared<GridImage>(std::move(info), std::move(file), grid_of(layout), most);
  return opened;
}

OpenedImage open_binary_image(core::InputFile file, const SampleFileHints& hints) {
  const std::string name = file.path().string();
  if (hints.columns == 0 || hints.bits < 1 || hints.bits > 64)
    return refused(file_problem(name, "a BINARY file does not say its own shape",
                                fmt::format("{} samples of a row, {} A/D bits", hints.columns, hints.bits),
                                "the samples of a row and 1 to 64 A/D bits",
                                "name the script that made it, or describe it as a custom file"));
  const CountRange range{hints.bits};
  StoredGrid grid;
  grid.columns = hints.columns;
  grid.sample_bytes = 2 * range.component_bytes();
  grid.decode = count_decoders[range.component_bytes() - 1];
  grid.count_offset = range.offset();
  const auto row = checked_product(grid.columns, grid.sample_bytes);
  if (!row || *row > file.size())
    return refused(file_problem(name, "the file does not hold a single row", fmt::format("{} bytes", file.size()),
                                fmt::format("{} samples x 2 x {} bytes", hints.columns, range.component_bytes()),
                                "check the samples of a row and the A/D bits"));
  core::Problems problems;
  if (file.size() % *row != 0)
    problems.push_back(with_severity(
        file_problem(name, "the file does not hold a whole number of rows", fmt::format("{} bytes", file.size()),
                     fmt::format("a multiple of {} bytes", *row),
                     "check the samples of a row and the A/D bits; the file may be cut off or still growing"),
        core::Severity::warning));
  if (hints.rows > 0 && file.size() / *row != hints.rows)
    problems.push_back(with_severity(file_problem(name, "the file has another number of rows",
                                                  fmt::format("{}", file.size() / *row), fmt::format("{}", hints.rows)),
                                     core::Severity::warning));
  ImageInfo info = info_of(file, hints.columns);
  info.counts = true;
  info.bits = hints.bits;
  if (hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  return {std::make_shared<GridImage>(std::move(info), std::move(file), grid, any_rows), std::move(problems)};
}

OpenedImage open_npy_image(core::InputFile file, const SampleFileHints& hints) {
  const std::string name = file.path().string();
  auto parsed = read_npy_header(file);
  if (auto* problem = std::get_if<core::Problem>(&parsed)) {
    problem->place.file = name;
    return refused(std::move(*problem));
  }
  const NpyHeader& header = std::get<NpyHeader>(parsed);
  const NpyType* const type = npy_type_of(header);
  if (type == nullptr)
    return refused(file_problem(name, "the array's type is not one of numbers", header.type,
                                "c8, c16, f4, f8, i1 to i8 or u1 to u8, of either byte order"));
  const auto plane = npy_plane_of(header, *type);
  if (!plane) return refused(shape_problem(name, header));
  return make_npy(std::move(file), header, *type, *plane, hints);
}

}  // namespace sarsim::raster
