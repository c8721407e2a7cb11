#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/os/input_file.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/grid_raster.hpp"
#include "raster/format/npy_array.hpp"
#include "raster/format/sigmf.hpp"
#include "raster/table/described_product.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

constexpr std::uint64_t longest_meta_bytes = std::uint64_t{1} << 30U;
constexpr std::string_view own_prefix = "sarsim:";

const nlohmann::json& sigmf_member(const nlohmann::json& object, const char* name) {
  static const nlohmann::json none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

// What the metadata of a recording say, as far as it is read.
struct SigmfMeta {
  std::string datatype;
  std::uint64_t columns = 0;  // 0: not said.
  std::optional<double> sample_rate_hz;
  FileAttributes attributes;
  std::vector<double> range_m;  // Empty where they do not say.
  std::vector<std::uint64_t> starts;
  std::vector<double> time_s;      // Of each capture; shorter where one says none.
  std::vector<double> carrier_hz;  // The same.
};

void take_global(const nlohmann::json& global, SigmfMeta& meta) {
  for (const auto& [name, value] : global.items()) {
    if (!name.starts_with(own_prefix)) continue;
    const std::string own = name.substr(own_prefix.size());
    if (value.is_string()) meta.attributes.emplace_back(own, value.get<std::string>());
    if (value.is_number_integer()) meta.attributes.emplace_back(own, value.dump());
    if (value.is_number_float()) meta.attributes.emplace_back(own, core::format_number(value.get<double>()));
  }
  if (const auto& type = sigmf_member(global, "core:datatype"); type.is_string())
    meta.datatype = type.get<std::string>();
  if (const auto& rate = sigmf_member(global, "core:sample_rate"); rate.is_number())
    meta.sample_rate_hz = rate.get<double>();
  if (const auto& columns = sigmf_member(global, "sarsim:samples_per_pulse"); columns.is_number_unsigned())
    meta.columns = columns.get<std::uint64_t>();
  if (const auto& ranges = sigmf_member(global, "sarsim:slant_range_m"); ranges.is_array())
    for (const auto& range : ranges)
      if (range.is_number()) meta.range_m.push_back(range.get<double>());
}

void take_captures(const nlohmann::json& captures, SigmfMeta& meta) {
  for (const auto& capture : captures) {
    if (!capture.is_object()) continue;
    const auto& start = sigmf_member(capture, "core:sample_start");
    const auto& time = sigmf_member(capture, "sarsim:pulse_time_s");
    const auto& carrier = sigmf_member(capture, "core:frequency");
    if (start.is_number_unsigned()) meta.starts.push_back(start.get<std::uint64_t>());
    if (time.is_number()) meta.time_s.push_back(time.get<double>());
    if (carrier.is_number()) meta.carrier_hz.push_back(carrier.get<double>());
  }
  // Captures as long as one another are pulses.
  if (meta.columns > 0 || meta.starts.size() < 2 || meta.starts.front() != 0) return;
  const std::uint64_t step = meta.starts[1];
  bool equal = step > 0;
  for (std::size_t i = 1; i < meta.starts.size(); ++i) equal = equal && meta.starts[i] - meta.starts[i - 1] == step;
  if (equal) meta.columns = step;
}

std::variant<SigmfMeta, core::Problem> read_meta(const std::filesystem::path& path) {
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
  const auto& file = std::get<core::InputFile>(opened);
  if (file.size() > longest_meta_bytes)
    return file_problem(path.string(), "the metadata are too long", core::bytes_text(static_cast<double>(file.size())));
  std::string text(static_cast<std::size_t>(file.size()), '\0');
  file.read_all_at(0, std::as_writable_bytes(std::span(text)));
  try {
    const nlohmann::json tree = nlohmann::json::parse(text);
    if (!tree.is_object() || !sigmf_member(tree, "global").is_object())
      return file_problem(path.string(), "the metadata have no object 'global'", {}, "those of SigMF");
    SigmfMeta meta;
    take_global(sigmf_member(tree, "global"), meta);
    if (const auto& captures = sigmf_member(tree, "captures"); captures.is_array()) take_captures(captures, meta);
    return meta;
  } catch (const nlohmann::json::exception& error) {
    return file_problem(path.string(), "this is not JSON", error.what());
  }
}

// NumPy's word for the numbers of a type, I and Q after one another; empty for those that are not read.
std::string numpy_type(const std::string& datatype) {
  if (datatype == "cf32_le") return "<c8";
  if (datatype == "cf64_le") return "<c16";
  if (datatype == "ci16_le") return "<i2";
  if (datatype == "ci32_le") return "<i4";
  return datatype == "ci8" ? "<i1" : "";
}

class SigmfRaster final : public Raster {
 public:
  SigmfRaster(RasterInfo info, std::shared_ptr<Raster> samples, SigmfMeta meta)
      : Raster(std::move(info)), samples_(std::move(samples)), meta_(std::move(meta)) {}

  [[nodiscard]] std::size_t rows() const override { return samples_->rows(); }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override { return samples_->read_cost_s(window); }
  [[nodiscard]] std::optional<RasterAxes> axes() const override {
    const bool known =
        meta_.time_s.size() == rows() && meta_.carrier_hz.size() == rows() && meta_.range_m.size() == columns();
    return known ? std::optional(RasterAxes{meta_.time_s, meta_.carrier_hz, meta_.range_m}) : std::nullopt;
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
};

// The places of samples in the file of them, or what is wrong with it.
std::variant<StoredGrid, core::Problem> grid_of(const core::InputFile& data, const SigmfMeta& meta,
                                                const std::filesystem::path& name, const RasterHints& hints) {
  const NpyType* const type = npy_type_of({numpy_type(meta.datatype), false, {}, 0});
  if (type == nullptr)
    return file_problem(name.string(), "samples of this type are not read", meta.datatype,
                        "cf32_le, cf64_le, ci8, ci16_le or ci32_le");
  StoredGrid grid;
  const std::uint64_t columns = meta.columns > 0 ? meta.columns : hints.columns;
  if (columns == 0)
    return file_problem(name.string(), "it is not known how many samples make a row", {},
                        "captures of equal length, or sarsim:samples_per_pulse", "give --columns");
  grid.columns = static_cast<std::size_t>(columns);
  grid.sample_bytes = 2 * type->bytes;
  grid.decode = type->decoder(true, false, false);
  const auto row_bytes = checked_product(columns, grid.sample_bytes);
  if (!row_bytes || data.size() == 0 || data.size() % *row_bytes != 0)
    return file_problem(data.path().string(), "the samples are no whole number of rows",
                        fmt::format("{} bytes", data.size()),
                        fmt::format("rows of {} samples of {} bytes", columns, grid.sample_bytes),
                        "the file is cut off, or belongs to other metadata");
  return grid;
}

}  // namespace

OpenedRaster open_sigmf(core::InputFile file, const Format&, const RasterHints& hints, Integrity) {
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
  const auto& grid = std::get<StoredGrid>(placed);
  RasterInfo info = info_of(data, grid.columns, hints);
  info.path = file.path();
  info.attributes = meta.attributes;
  take_known_attributes(info);
  if (info.bits == 0) info.bits = std::max(hints.bits, 0);
  if (!info.lsb_v && hints.lsb_v > 0.0) info.lsb_v = hints.lsb_v;
  if (!info.sample_rate_hz) info.sample_rate_hz = meta.sample_rate_hz;
  info.counts = meta.datatype.starts_with("ci");
  RasterInfo plain = info;
  auto samples = make_grid_raster(std::move(plain), std::move(data), grid, any_rows);
  if (hints.rows > 0 && hints.rows != samples->rows())
    return refused(file_problem(files.front().string(), "the recording has another number of rows",
                                fmt::format("{}", samples->rows()), fmt::format("{}", hints.rows)));
  return {std::make_shared<SigmfRaster>(std::move(info), std::move(samples), std::move(meta)), {}};
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
  const std::uint64_t rows = file.size() / grid.row_bytes();
  std::string type = numpy_type(meta.datatype);
  if (type == "<i1") type = "|i1";
  std::vector<StoredArray> arrays{{.name = "samples",
                                   .type = std::move(type),
                                   .item_bytes = pairs ? grid.sample_bytes / 2 : grid.sample_bytes,
                                   .shape = {rows, grid.columns},
                                   .dimensions = {"pulse", "sample"},
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
