#include "raster/format/sample_file.hpp"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/os/input_file.hpp"
#include "raster/format/envi.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

namespace {

// A header beside a file counts where neither the caller nor the file's extension says something else.
bool is_envi(const std::filesystem::path& path, const SampleFileHints& hints) {
  return !hints.format && hints.columns == 0 && !format_from_path(path) && has_envi_header(path);
}

}  // namespace

OpenedSampleFile SampleFile::open(const std::filesystem::path& path, const SampleFileHints& hints) {
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return {std::nullopt, {std::move(*problem)}};
  auto& file = std::get<core::InputFile>(opened);
  if (file.size() == 0)
    return {std::nullopt, {file_problem(path.string(), "the file is empty", {}, "samples", "make it anew")}};
  const Format* const format = is_envi(path, hints) ? &envi_format() : detect_format(file, hints, false);
  if (format == nullptr)
    return {std::nullopt,
            {file_problem(path.string(), "the format of the file is not known", {}, {},
                          "give the format; BINARY also needs the samples of a row and the A/D bits")}};
  OpenedReader result = format->reader->samples(std::move(file), *format, hints);
  if (result.reader) result.reader->set_format(*format);
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
