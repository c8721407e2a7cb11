#include "raster/format/open_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/text_start.hpp"
#include "raster/format/zarr_store.hpp"
#include "raster/table/file_problem.hpp"
#include "raster/table/formats.hpp"
#include "raster/table/raster_gate.hpp"
#include "scene/script/foreign_text.hpp"

namespace sarsim::raster {

namespace {

const Format* with_signature(const core::InputFile& file, bool pictures) {
  std::array<char, 8> begin{};
  const std::size_t got = file.read_at(0, std::as_writable_bytes(std::span(begin)));
  const std::string_view bytes(begin.data(), got);
  const auto found = std::ranges::find_if(formats(), [&](const Format& row) {
    return !row.signature.empty() && bytes.starts_with(row.signature) && (pictures || !row.picture);
  });
  return found == formats().end() ? nullptr : &*found;
}

const Format* in_style(TextStyle style) { return &*std::ranges::find(recording_formats(), style, &Format::text); }

// The format of files that have nothing but their numbers.
const Format* bare_numbers() {
  return &*std::ranges::find_if(recording_formats(),
                                [](const Format& row) { return !row.is_text() && row.signature.empty(); });
}

// The format of a file: that of the hints, otherwise that of its first bytes, otherwise that of its extension where
// this means samples or SICD and no text, otherwise the text that it looks like, otherwise BINARY where its shape is
// known, otherwise that of its extension. Null where nothing tells. `pictures`: look for pictures, too.
const Format* detect_format(const core::InputFile& file, const RasterHints& hints, bool pictures) {
  if (hints.format) return &format_of(*hints.format);
  if (const Format* const row = with_signature(file, pictures)) return row;
  const auto recording = format_from_path(file.path());
  const Format* const named = recording ? &format_of(*recording) : nullptr;
  if (named != nullptr && !named->is_text()) return named;
  if (row_from_path(file.path()) == &sicd_format()) return &sicd_format();
  if (const TextStyle style = style_of_text(file); style != TextStyle::none) return in_style(style);
  if (hints.columns > 0 && hints.bits > 0) return bare_numbers();
  return named;
}

// A header beside a file counts where neither the caller nor the file's extension says something else.
bool is_envi(const std::filesystem::path& path, const RasterHints& hints) {
  return !hints.format && hints.columns == 0 && !format_from_path(path) && has_envi_header(path);
}

const Format* format_of_file(const core::InputFile& file, const RasterHints& hints, Integrity integrity) {
  if (hints.raw) return &custom_format();
  const bool whole = integrity == Integrity::whole;
  if (whole && is_envi(file.path(), hints)) return &envi_format();
  return detect_format(file, hints, !whole);
}

// The format of a folder; null where it is none of any.
const Format* format_of_folder(const std::filesystem::path& path) {
  if (!looks_like_zarr(path)) return nullptr;
  return &*std::ranges::find_if(formats(), [](const Format& row) { return row.open_folder != nullptr; });
}

// The folder that a path means: a file of it means all of it, as dialogs offer files. Without the slash that a shell
// puts behind its name.
std::optional<std::filesystem::path> folder_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return path.has_filename() ? path : path.parent_path();
  const std::string name = path.filename().string();
  if (name != ".zgroup" && name != ".zattrs" && name != ".zmetadata" && name != ".zarray") return std::nullopt;
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

// What a file of an unknown format seems to be, in words; empty where nothing tells.
std::string guess_of(const core::InputFile& file) {
  std::string begin(std::size_t{1} << 12U, '\0');
  begin.resize(file.read_at(0, std::as_writable_bytes(std::span(begin))));
  const std::string kind = scene::guess_of_content(begin);
  return kind.empty() ? kind : "it seems to be " + kind;
}

// What the caller said of a file that says otherwise itself, which counts.
core::Problems contradicted_hints(const Raster& raster, const RasterHints& hints, const std::string& path) {
  core::Problems problems;
  if (hints.raw) return problems;
  const RasterInfo& info = raster.info();
  if (hints.columns > 0 && hints.columns != info.columns)
    problems.push_back(file_problem(path, "the file has another number of columns", fmt::format("{}", info.columns),
                                    fmt::format("{}, as was said", hints.columns),
                                    "leave the number out: the file contains it"));
  const auto compare = [&](const char* what, double found, double said) {
    constexpr double share = 1e-9;
    if (!info.counts || !(found > 0.0 && said > 0.0) || std::abs(found - said) <= share * said) return;
    problems.push_back(with_severity(
        file_problem(path, fmt::format("{} of the file is not that which was said; that of the file counts", what),
                     fmt::format("{:g}", found), fmt::format("{:g}", said), "leave it out, or correct the file"),
        core::Severity::warning));
  };
  compare("the LSB", info.lsb_v.value_or(0.0), hints.lsb_v);
  compare("the number of A/D bits", info.bits, hints.bits);
  return problems;
}

// Opening a file takes neither memory nor time that grows with it; longer axes are judged where they are used.
constexpr std::size_t max_looked_at = std::size_t{1} << 20U;

// The gate that every file of samples passes, whatever its format. What is only looked at is shown as it is.
OpenedRaster passed(OpenedRaster opened, const Format& format, const std::filesystem::path& path,
                    const RasterHints& hints, Integrity integrity) {
  if (!opened.raster) return opened;
  opened.raster->set_format(format);
  const bool looked_at = opened.raster->rows() <= max_looked_at && opened.raster->columns() <= max_looked_at;
  if (looked_at) opened.axes = opened.raster->axes();
  core::Problems found = problems_of_facts(*opened.raster, opened.axes ? &*opened.axes : nullptr, path.string());
  core::append(found, contradicted_hints(*opened.raster, hints, path.string()));
  for (core::Problem& problem : found) {
    if (integrity == Integrity::partial && problem.severity == core::Severity::error)
      problem.severity = core::Severity::warning;
    opened.problems.push_back(std::move(problem));
  }
  if (core::has_errors(opened.problems)) opened.raster.reset();
  return opened;
}

}  // namespace

OpenedRaster open_raster(Integrity integrity, const std::filesystem::path& path, const RasterHints& hints,
                         const core::StopFlag* stop) {
  if (const auto folder = folder_of(path))
    if (const Format* const format = format_of_folder(*folder); format != nullptr && hints.dataset.empty())
      return passed(format->open_folder(*folder, *format, hints, integrity, stop), *format, path, hints, integrity);
  const bool whole = integrity == Integrity::whole;
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return {nullptr, {std::move(*problem)}};
  auto& file = std::get<core::InputFile>(opened);
  if (file.size() == 0)
    return {nullptr, {file_problem(path.string(), "the file is empty", {}, "samples", whole ? "make it anew" : "")}};
  const Format* const format = format_of_file(file, hints, integrity);
  if (format == nullptr)
    return {nullptr,
            {file_problem(path.string(), "the format of the file is not known", guess_of(file), {},
                          whole ? "give the format; BINARY also needs the samples of a row and the A/D bits"
                                : "describe it as a custom file, or name the script that made it")}};
  if (!hints.dataset.empty() && !format->datasets)
    return {nullptr,
            {file_problem(path.string(), fmt::format("a dataset is named, but {} has none", word_of(*format)),
                          fmt::format("{:.60}", hints.dataset), {}, "leave it out: it is for HDF5 files")}};
  return passed(format->open(std::move(file), *format, hints, integrity, stop), *format, path, hints, integrity);
}

}  // namespace sarsim::raster
