#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "core/text/quoted_word.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/grid_raster.hpp"
#include "raster/format/npy_array.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

core::Problem wrong_type(const std::string& name, const NpyHeader& header) {
  if (!header.fields.empty())
    return file_problem(name, "the array holds structures, not samples",
                        fmt::format("{} fields, the first is '{}'", header.fields.size(),
                                    core::quoted_word(header.fields.front().name)),
                        npy_sample_types(), "store one of its fields: numpy.save('a.npy', array['NAME'])");
  if (header.type.starts_with('>'))
    return file_problem(name, "the array is big-endian", header.type, npy_sample_types(),
                        "store it with array.astype(array.dtype.newbyteorder('<'))");
  return file_problem(name, "the array's type is not one of samples", header.type, npy_sample_types());
}

core::Problem shape_problem(const std::string& name, const NpyHeader& header) {
  return file_problem(name,
                      header.fortran_order ? "the array's shape cannot be shown in Fortran order"
                                           : "the array's shape is not one of an image",
                      shape_text(header.shape),
                      "(rows, columns), (rows, columns, 2) for I and Q, or 3 bytes for colours");
}

// An array in its file.
struct NpyLayout {
  NpyPlane plane;
  StoredGrid grid;            // Of the order in which it is stored.
  std::uint64_t bytes = 0;    // Of the whole array; 0 where they are too many to be counted.
  std::uint64_t present = 0;  // Of it in the file.
};

NpyLayout layout_of(const core::InputFile& file, const NpyHeader& header, const NpyType& type, const NpyPlane& plane) {
  NpyLayout layout{plane, {}, 0, file.size() - std::min<std::uint64_t>(file.size(), header.data_offset)};
  StoredGrid& grid = layout.grid;
  grid.offset = header.data_offset;
  grid.columns = static_cast<std::size_t>(header.fortran_order ? plane.rows : plane.columns);
  grid.sample_bytes = type.bytes * (type.pair ? 2U : 1U) * static_cast<std::size_t>(plane.components);
  grid.decode = plane.value == ImageValue::rgb
                    ? rgb_decoder()
                    : type.decoder(plane.value == ImageValue::complex, header.type.starts_with('>'), false);
  layout.bytes = checked_product(plane.rows, plane.columns, grid.sample_bytes).value_or(0);
  return layout;
}

core::Problem cut_off(const std::string& name, const NpyHeader& header, const NpyLayout& layout, std::string hint) {
  return file_problem(name, "the file ends within the array", fmt::format("{} bytes", layout.present),
                      fmt::format("{} bytes for the shape {}", layout.bytes, shape_text(header.shape)),
                      std::move(hint));
}

core::Problem left_over(const std::string& name, const NpyLayout& layout, core::Severity severity) {
  return with_severity(file_problem(name, "what follows the array is not read",
                                    fmt::format("{} bytes more", layout.present - layout.bytes)),
                       severity);
}

// A layout, or what is wrong.
using NpyReading = std::pair<std::optional<NpyLayout>, core::Problems>;

// Of a whole file.
NpyReading read_whole_npy(const core::InputFile& file, const NpyHeader& header, const RasterHints& hints) {
  const std::string name = file.path().string();
  const auto refused = [](core::Problem problem) { return NpyReading{std::nullopt, {std::move(problem)}}; };
  if (header.fortran_order)
    return refused(file_problem(name, "the array is in Fortran order", "fortran_order: True", "fortran_order: False",
                                "store it with numpy.ascontiguousarray(array)"));
  const NpyType* const type = npy_sample_type_of(header);
  if (type == nullptr) return refused(wrong_type(name, header));
  const auto plane = npy_plane_of(header, *type);
  const bool samples = plane && plane->value == ImageValue::complex;
  const NpyLayout layout = samples ? layout_of(file, header, *type, *plane) : NpyLayout{};
  if (layout.bytes == 0)
    return refused(file_problem(name, "the array's shape is not one of samples", shape_text(header.shape),
                                type->pair ? "(rows, columns)" : "(rows, columns, 2)"));
  if (layout.present < layout.bytes) return refused(cut_off(name, header, layout, "the file is cut off"));
  if (hints.rows > 0 && hints.rows != plane->rows)
    return refused(file_problem(name, "the file has another number of rows", fmt::format("{}", plane->rows),
                                fmt::format("{}", hints.rows)));
  if (layout.present == layout.bytes) return {layout, {}};
  return {layout, {left_over(name, layout, core::Severity::warning)}};
}

// Of a file that may be cut off or still growing.
NpyReading read_partial_npy(const core::InputFile& file, const NpyHeader& header) {
  const std::string name = file.path().string();
  const auto refused = [](core::Problem problem) { return NpyReading{std::nullopt, {std::move(problem)}}; };
  const NpyType* const type = npy_type_of(header);
  if (type == nullptr && !header.fields.empty()) return refused(wrong_type(name, header));
  if (type == nullptr)
    return refused(file_problem(name, "the array's type is not one of numbers", header.type,
                                "c8, c16, f4, f8, i1 to i8 or u1 to u8, of either byte order"));
  const auto plane = npy_plane_of(header, *type);
  if (!plane) return refused(shape_problem(name, header));
  const NpyLayout layout = layout_of(file, header, *type, *plane);
  const std::uint64_t row_bytes = plane->columns * layout.grid.sample_bytes;
  if (layout.bytes == 0 || row_bytes > layout.present || (header.fortran_order && layout.bytes > layout.present))
    return refused(file_problem(name, "the file ends within the array", fmt::format("{} bytes", layout.present),
                                fmt::format("{} of {} bytes each", shape_text(header.shape), type->bytes),
                                "the file is cut off"));
  if (layout.present < layout.bytes)
    return {layout, {with_severity(cut_off(name, header, layout, "what is there is shown"), core::Severity::warning)}};
  if (layout.present > layout.bytes) return {layout, {left_over(name, layout, core::Severity::note)}};
  return {layout, {}};
}

}  // namespace

OpenedRaster open_npy(core::InputFile file, const Format&, const RasterHints& hints, Integrity integrity,
                      const core::StopFlag*) {
  auto parsed = read_npy_header(file);
  if (auto* problem = std::get_if<core::Problem>(&parsed)) {
    problem->place.file = file.path().string();
    return {nullptr, {std::move(*problem)}};
  }
  const NpyHeader& header = std::get<NpyHeader>(parsed);
  auto [layout, problems] =
      integrity == Integrity::whole ? read_whole_npy(file, header, hints) : read_partial_npy(file, header);
  if (!layout) return {nullptr, std::move(problems)};
  RasterInfo info = info_of(file, static_cast<std::size_t>(layout->plane.columns), hints);
  info.value = layout->plane.value;
  info.counts = npy_type_of(header)->counts && info.value == ImageValue::complex;
  info.bits = info.counts ? std::max(hints.bits, 0) : 0;
  info.attributes = {{"descr", header.type}};
  if (header.fortran_order)
    return {make_transposed_raster(std::move(info), std::move(file), layout->grid), std::move(problems)};
  return {make_grid_raster(std::move(info), std::move(file), layout->grid, layout->plane.rows), std::move(problems)};
}

StoredArrays arrays_of_npy(const core::InputFile& file, const RasterHints&) {
  auto parsed = read_npy_header(file);
  if (auto* problem = std::get_if<core::Problem>(&parsed)) return std::move(*problem);
  const NpyHeader& header = std::get<NpyHeader>(parsed);
  const NpyType* const type = npy_sample_type_of(header);
  const auto plane = type == nullptr || header.fortran_order ? std::nullopt : npy_plane_of(header, *type);
  if (!plane) return wrong_type({}, header);
  StoredArray samples{.name = "samples", .type = header.type, .shape = {plane->rows, plane->columns}};
  samples.item_bytes = type->bytes * (type->pair ? 2U : 1U);
  samples.dimensions = {"pulse", "sample"};
  samples.offset = header.data_offset;
  samples.facts = {{"units", type->counts ? "count" : "V"}, {"long_name", "complex envelope"}};
  if (type->pair) return std::vector{std::move(samples)};
  samples.shape.push_back(2);
  samples.dimensions.emplace_back("iq");
  return std::vector{std::move(samples), pair_names()};
}

}  // namespace sarsim::raster
