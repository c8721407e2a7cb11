#include "raster/format/sample_file.hpp"

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "raster/format/array_reader.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/envi_reader.hpp"
#include "raster/format/load_hdf5.hpp"
#include "raster/format/text_reader.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

namespace {

constexpr std::string_view npy_signature = "\x93NUMPY";
constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

// A header beside a file counts where neither the caller nor the file's extension says something else.
bool is_envi(const std::filesystem::path& path, const SampleFileHints& hints) {
  return !hints.format && hints.columns == 0 && !format_from_path(path) && has_envi_header(path);
}

std::optional<scene::FileFormat> detect_format(const core::InputFile& file, const SampleFileHints& hints) {
  if (hints.format) return hints.format;
  std::array<char, 8> begin{};
  const std::size_t got = file.read_at(0, std::as_writable_bytes(std::span(begin)));
  const std::string_view text(begin.data(), got);
  if (text.starts_with(npy_signature)) return scene::FileFormat::npy;
  if (text.starts_with(hdf5_signature)) return scene::FileFormat::hdf5;
  const auto named = format_from_path(file.path());
  if (named == scene::FileFormat::binary || named == scene::FileFormat::hdf5 || named == scene::FileFormat::npy)
    return named;
  if (const auto found = detect_text_format(file)) return found;
  if (hints.columns > 0 && hints.bits > 0) return scene::FileFormat::binary;
  return named;
}

OpenedReader open_as(scene::FileFormat format, core::InputFile file, const SampleFileHints& hints) {
  switch (format) {
    case scene::FileFormat::binary: return open_binary(std::move(file), hints);
    case scene::FileFormat::npy: return open_npy(std::move(file), hints);
    case scene::FileFormat::hdf5: {
      const std::filesystem::path path = file.path();
      const std::uint64_t size = file.size();
      return hdf5_module(path).open(path, size, hints);
    }
    case scene::FileFormat::ascii:
    case scene::FileFormat::bracket:
    case scene::FileFormat::csv: break;
  }
  return open_text(std::move(file), format, hints);
}

}  // namespace

OpenedSampleFile SampleFile::open(const std::filesystem::path& path, const SampleFileHints& hints) {
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return {std::nullopt, {std::move(*problem)}};
  auto& file = std::get<core::InputFile>(opened);
  if (file.size() == 0)
    return {std::nullopt, {file_problem(path.string(), "the file is empty", {}, "samples", "make it anew")}};
  const bool envi = is_envi(path, hints);
  const auto format = envi ? std::nullopt : detect_format(file, hints);
  if (!envi && !format)
    return {std::nullopt,
            {file_problem(path.string(), "the format of the file is not known", {}, {},
                          "give the format; BINARY also needs the samples of a row and the A/D bits")}};
  OpenedReader result = envi ? open_envi(path) : open_as(*format, std::move(file), hints);
  OpenedSampleFile answer{std::nullopt, std::move(result.problems)};
  if (result.reader) answer.file = SampleFile(std::move(result.reader));
  return answer;
}

void SampleFile::read_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const {
  const SampleFileInfo& known = info();
  if (first > known.rows || count > known.rows - first)
    throw std::out_of_range(fmt::format("rows {} to {} of a file of {} rows", first, first + count, known.rows));
  if (out.size() % known.columns != 0 || out.size() / known.columns != count)
    throw std::invalid_argument(
        fmt::format("room for {} samples instead of {} rows of {}", out.size(), count, known.columns));
  if (count > 0) reader_->read_rows(first, count, out);
}

}  // namespace sarsim::raster
