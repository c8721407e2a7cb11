#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/hash/sha512.hpp"
#include "core/os/input_file.hpp"
#include "core/task/stop_points.hpp"
#include "core/text/number_text.hpp"
#include "core/text/quoted_word.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/grid_raster.hpp"
#include "raster/format/npy_array.hpp"
#include "raster/format/sigmf.hpp"
#include "raster/table/described_product.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/sigmf_meta.hpp"

namespace sarsim::raster {

namespace {

constexpr std::uint64_t longest_meta_bytes = std::uint64_t{1} << 30U;

std::variant<SigmfMeta, core::Problem> read_meta(const std::filesystem::path& path) {
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
  const auto& file = std::get<core::InputFile>(opened);
  if (file.size() > longest_meta_bytes)
    return file_problem(path.string(), "the metadata are too long", core::bytes_text(static_cast<double>(file.size())));
  std::string text(static_cast<std::size_t>(file.size()), '\0');
  file.read_all_at(0, std::as_writable_bytes(std::span(text)));
  auto meta = parse_sigmf_meta(text, sigmf_files(path).back());
  if (auto* problem = std::get_if<core::Problem>(&meta)) problem->place.file = path.string();
  return meta;
}

// NumPy's word for the numbers of a type, I and Q after one another; empty for those that are not read.
std::string numpy_type(const std::string& datatype) {
  if (datatype == "cf32_le") return "<c8";
  if (datatype == "cf64_le") return "<c16";
  if (datatype == "ci16_le") return "<i2";
  if (datatype == "ci32_le") return "<i4";
  return datatype == "ci8" ? "<i1" : "";
}

// Bytes of samples in the file of them.
std::uint64_t sample_bytes_of(const core::InputFile& data, const SigmfMeta& meta) {
  const std::uint64_t behind = data.size() - std::min(data.size(), meta.header_bytes);
  return behind - std::min(behind, meta.trailing_bytes);
}

// What the file of samples has to be, byte by byte.
std::optional<core::Problem> problem_of_checksum(const core::InputFile& data, const SigmfMeta& meta,
                                                 const core::StopFlag* stop) {
  if (meta.sha512.empty()) return std::nullopt;
  constexpr std::size_t at_once = std::size_t{1} << 20U;
  core::Sha512 sum;
  std::vector<std::byte> bytes(at_once);
  for (std::uint64_t at = 0; at < data.size(); at += at_once) {
    core::end_if_asked(stop);
    const auto part =
        std::span(bytes).first(static_cast<std::size_t>(std::min<std::uint64_t>(at_once, data.size() - at)));
    data.read_all_at(at, part);
    sum.add(part);
  }
  const std::string found = sum.digest();
  if (found == meta.sha512) return std::nullopt;
  return file_problem(data.path().string(), "the samples have not the checksum of the metadata (core:sha512)",
                      found.substr(0, 16) + "...", meta.sha512.substr(0, 16) + "...",
                      "the file is damaged, or belongs to other metadata");
}

class SigmfRaster final : public Raster {
 public:
  // @param unproved  file of samples whose checksum is still to be compared; empty where there is nothing to compare
  SigmfRaster(RasterInfo info, std::shared_ptr<Raster> samples, SigmfMeta meta, std::filesystem::path unproved)
      : Raster(std::move(info)), samples_(std::move(samples)), meta_(std::move(meta)), unproved_(std::move(unproved)) {}

  [[nodiscard]] std::size_t rows() const override { return samples_->rows(); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override { return samples_->read_cost_s(window); }
  [[nodiscard]] std::optional<RasterAxes> axes() const override {
    const bool known =
        meta_.time_s.size() == rows() && meta_.carrier_hz.size() == rows() && meta_.range_m.size() == columns();
    return known ? std::optional(RasterAxes{meta_.time_s, meta_.carrier_hz, meta_.range_m}) : std::nullopt;
  }
  // Reads the file of samples through, for those who want to know that it is sound.
  void wait_until_indexed(const core::StopFlag* stop) const override {
    const std::lock_guard lock(proving_);
    if (unproved_.empty()) return;
    auto opened = core::InputFile::open(unproved_);
    if (auto* problem = std::get_if<core::Problem>(&opened))
      found_.push_back(std::move(*problem));
    else if (auto other = problem_of_checksum(std::get<core::InputFile>(opened), meta_, stop))
      found_.push_back(std::move(*other));
    unproved_.clear();
  }
  [[nodiscard]] core::Problems problems() const override {
    const std::lock_guard lock(proving_);
    return found_;
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    samples_->read_window(window, out, control);
  }
  void read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    samples_->read_rows(first, count, out);
  }

 private:
  std::shared_ptr<Raster> samples_;
  SigmfMeta meta_;
  mutable std::mutex proving_;
  mutable std::filesystem::path unproved_;
  mutable core::Problems found_;
};

// The places of samples in the file of them, or what is wrong with it.
std::variant<StoredGrid, core::Problem> grid_of(const core::InputFile& data, const SigmfMeta& meta,
                                                const std::filesystem::path& name, const RasterHints& hints) {
  const NpyType* const type = npy_type_of({numpy_type(meta.datatype), false, {}, 0});
  if (type == nullptr)
    return file_problem(name.string(), "samples of this type are not read", core::quoted_word(meta.datatype),
                        "cf32_le, cf64_le, ci8, ci16_le or ci32_le");
  StoredGrid grid;
  const std::uint64_t columns = meta.columns > 0 ? meta.columns : hints.columns;
  if (columns == 0)
    return file_problem(name.string(), "it is not known how many samples make a row", {},
                        "captures of equal length, or sarsim:samples_per_pulse", "give --columns");
  grid.columns = static_cast<std::size_t>(columns);
  grid.sample_bytes = 2 * type->bytes;
  grid.decode = type->decoder(true, false, false);
  grid.offset = meta.header_bytes;
  const std::uint64_t bytes = sample_bytes_of(data, meta);
  const auto row_bytes = checked_product(columns, grid.sample_bytes);
  if (!row_bytes || bytes == 0 || bytes % *row_bytes != 0)
    return file_problem(data.path().string(), "the samples are no whole number of rows",
                        meta.header_bytes + meta.trailing_bytes > 0
                            ? fmt::format("{} bytes without the {} of core:header_bytes and core:trailing_bytes", bytes,
                                          meta.header_bytes + meta.trailing_bytes)
                            : fmt::format("{} bytes", bytes),
                        fmt::format("rows of {} samples of {} bytes", columns, grid.sample_bytes),
                        "the file is cut off, or belongs to other metadata");
  if (auto problem = misfit_of_meta(meta, bytes / *row_bytes, columns)) {
    problem->place.file = name.string();
    return std::move(*problem);
  }
  return grid;
}

// Our own recordings say the rate twice; that of the name space `sarsim` counts.
core::Problems contradiction_of_rates(const RasterInfo& info, const SigmfMeta& meta, const std::string& name) {
  constexpr double share = 1e-9;
  if (!info.sample_rate_hz || !meta.sample_rate_hz) return {};
  if (std::abs(*info.sample_rate_hz - *meta.sample_rate_hz) <= share * *info.sample_rate_hz) return {};
  return {with_severity(file_problem(name, "core:sample_rate contradicts sarsim:sample_rate_hz, which counts",
                                     core::format_number(*meta.sample_rate_hz),
                                     core::format_number(*info.sample_rate_hz), "one of them was changed: correct it"),
                        core::Severity::warning)};
}

}  // namespace

OpenedRaster open_sigmf(core::InputFile file, const Format&, const RasterHints& hints, Integrity integrity,
                        const core::StopFlag* stop) {
  const auto files = sigmf_files(file.path());
  const auto refused = [](core::Problem problem) { return OpenedRaster{nullptr, {std::move(problem)}}; };
  auto read = read_meta(files.front());
  if (auto* problem = std::get_if<core::Problem>(&read)) return refused(std::move(*problem));
  auto& meta = std::get<SigmfMeta>(read);
  auto opened = core::InputFile::open(files.back());
  if (auto* problem = std::get_if<core::Problem>(&opened)) return refused(std::move(*problem));
  auto& data = std::get<core::InputFile>(opened);
  auto placed = grid_of(data, meta, files.front(), hints);
  if (auto* problem = std::get_if<core::Problem>(&placed)) return refused(std::move(*problem));
  const bool whole = integrity == Integrity::whole;
  if (whole)
    if (auto problem = problem_of_checksum(data, meta, stop)) return refused(std::move(*problem));
  std::filesystem::path unproved = whole || meta.sha512.empty() ? std::filesystem::path() : data.path();
  const auto& grid = std::get<StoredGrid>(placed);
  const std::uint64_t rows = sample_bytes_of(data, meta) / grid.row_bytes();
  RasterInfo info = info_of(data, grid.columns, hints);
  info.path = file.path();
  info.attributes = meta.attributes;
  take_known_attributes(info);
  if (info.bits == 0) info.bits = std::max(hints.bits, 0);
  if (!info.lsb_v && hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  core::Problems problems = contradiction_of_rates(info, meta, files.front().string());
  if (!info.sample_rate_hz) info.sample_rate_hz = meta.sample_rate_hz;
  info.counts = meta.datatype.starts_with("ci");
  RasterInfo plain = info;
  auto samples = make_grid_raster(std::move(plain), std::move(data), grid, rows);
  if (hints.rows > 0 && hints.rows != samples->rows())
    return refused(file_problem(files.front().string(), "the recording has another number of rows",
                                fmt::format("{}", samples->rows()), fmt::format("{}", hints.rows)));
  return {std::make_shared<SigmfRaster>(std::move(info), std::move(samples), std::move(meta), std::move(unproved)),
          std::move(problems)};
}

StoredArrays arrays_of_sigmf(const core::InputFile& file, const RasterHints& hints) {
  const auto name = sigmf_files(file.path()).front();
  auto read = read_meta(name);
  if (auto* problem = std::get_if<core::Problem>(&read)) return std::move(*problem);
  auto& meta = std::get<SigmfMeta>(read);
  auto placed = grid_of(file, meta, name, hints);
  if (auto* problem = std::get_if<core::Problem>(&placed)) return std::move(*problem);
  const auto& grid = std::get<StoredGrid>(placed);
  const bool pairs = meta.datatype.starts_with("ci");
  const std::uint64_t rows = sample_bytes_of(file, meta) / grid.row_bytes();
  std::string type = numpy_type(meta.datatype);
  if (type == "<i1") type = "|i1";
  std::vector<StoredArray> arrays{{.name = "samples",
                                   .type = std::move(type),
                                   .item_bytes = pairs ? grid.sample_bytes / 2 : grid.sample_bytes,
                                   .shape = {rows, grid.columns},
                                   .dimensions = {"pulse", "sample"},
                                   .offset = grid.offset,
                                   .facts = {{"units", pairs ? "count" : "V"}, {"long_name", "complex envelope"}}}};
  if (pairs) {
    arrays.front().shape.push_back(2);
    arrays.front().dimensions.emplace_back("iq");
    arrays.push_back(pair_names());
  }
  if (meta.time_s.size() == rows) {
    arrays.front().dimensions[0] = "pulse_time_s";
    arrays.push_back(axis_here("pulse_time_s", std::move(meta.time_s), "s", "send time"));
  }
  if (meta.range_m.size() == grid.columns) {
    arrays.front().dimensions[1] = "slant_range_m";
    arrays.push_back(axis_here("slant_range_m", std::move(meta.range_m), "m", "one-way slant range"));
  }
  return arrays;
}

}  // namespace sarsim::raster
