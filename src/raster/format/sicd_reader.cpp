#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/xml/xml.hpp"
#include "raster/format/format_reader.hpp"
#include "raster/format/grid_raster.hpp"
#include "raster/format/raw_decode.hpp"
#include "raster/sicd/nitf.hpp"
#include "raster/sicd/sicd.hpp"
#include "raster/table/file_problem.hpp"

namespace sarsim::raster {

namespace {

// Rows of an image that lie together in the file.
struct SicdRows {
  std::size_t first = 0;
  std::size_t count = 0;
  StoredGrid grid;
};

// Amplitude and phase become I and Q.
class Polar {
 public:
  explicit Polar(std::vector<float> amplitudes) : amplitudes_(std::move(amplitudes)) {}

  template <class Real>
  void apply(std::span<std::complex<Real>> samples) const {
    for (std::complex<Real>& sample : samples) {
      const auto level = static_cast<std::size_t>(sample.real());
      const double amplitude =
          static_cast<double>(amplitudes_.empty() ? static_cast<float>(level) : amplitudes_[level]);
      const double phase = 2.0 * core::pi / 256.0 * static_cast<double>(sample.imag());
      sample = {static_cast<Real>(amplitude * std::cos(phase)), static_cast<Real>(amplitude * std::sin(phase))};
    }
  }

 private:
  std::vector<float> amplitudes_;
};

class SicdRaster final : public Raster {
 public:
  SicdRaster(RasterInfo info, core::InputFile file, std::vector<SicdRows> parts, std::optional<Polar> polar)
      : Raster(std::move(info)), file_(std::move(file)), parts_(std::move(parts)), polar_(std::move(polar)) {}

  [[nodiscard]] std::size_t rows() const override { return parts_.back().first + parts_.back().count; }
  [[nodiscard]] double read_cost_s(const ImageWindow& window) const override {
    return grid_cost_s(parts_.front().grid, window);
  }

 protected:
  void read_samples(const ImageWindow& window, std::span<std::complex<float>> out,
                    const core::WorkControl& control) const override {
    for (std::size_t i = 0; i < window.rows;) {
      const SicdRows& part = part_of(window.row(i));
      ImageWindow piece = window;
      piece.row0 = window.row(i) - part.first;
      piece.rows = std::min(window.rows - i, (part.count - 1 - piece.row0) / window.row_step + 1);
      read_grid(file_, part.grid, piece, out.subspan(i * window.cols, piece.rows * window.cols), control);
      i += piece.rows;
    }
    if (polar_) polar_->apply(out);
  }
  void read_whole_rows(std::size_t first, std::size_t count, std::span<std::complex<double>> out) const override {
    for (std::size_t i = 0; i < count;) {
      const SicdRows& part = part_of(first + i);
      const std::size_t from = first + i - part.first;
      const std::size_t rows = std::min(count - i, part.count - from);
      read_grid_rows(file_, part.grid, from, out.subspan(i * columns(), rows * columns()));
      i += rows;
    }
    if (polar_) polar_->apply(out);
  }

 private:
  [[nodiscard]] const SicdRows& part_of(std::size_t row) const {
    return *std::prev(std::ranges::upper_bound(parts_, row, {}, &SicdRows::first));
  }

  core::InputFile file_;
  std::vector<SicdRows> parts_;
  std::optional<Polar> polar_;
};

struct PixelForm {
  const char* kind;
  std::size_t bits;
  StoredGrid::Decoder decoder;
};

PixelForm form_of(SicdPixel pixel) {
  switch (pixel) {
    case SicdPixel::complex_int16: return {"SI", 16, raw_decoder<std::int16_t>(true, true, false)};
    case SicdPixel::polar_uint8: return {"INT", 8, raw_decoder<std::uint8_t>(true, true, false)};
    case SicdPixel::complex_float: break;
  }
  return {"R", 32, raw_decoder<float>(true, true, false)};
}

std::optional<core::Problem> problem_of_segment(const std::string& file, const NitfImage& image, std::size_t number,
                                                const SicdDescription& wanted) {
  const PixelForm form = form_of(wanted.pixel);
  const auto problem = [&](const char* what, std::string found, std::string expected) {
    return file_problem(file, fmt::format("image segment {}: {}", number + 1, what), std::move(found),
                        std::move(expected));
  };
  if (image.compression != "NC") return problem("its pixels are compressed or masked (IC)", image.compression, "NC");
  if (image.mode != 'P' || !image.one_block)
    return problem("its pixels lie in blocks or bands (IMODE, NBPR, NBPC)", std::string(1, image.mode),
                   "P in one block");
  if (image.kind != form.kind || image.bits != form.bits || image.bands != 2)
    return problem("its pixels are not those of the XML text",
                   fmt::format("{} x {} {}", image.bands, image.bits, image.kind),
                   fmt::format("2 x {} {}", form.bits, form.kind));
  if (image.columns != wanted.columns)
    return problem("its columns are not those of the XML text", fmt::format("{}", image.columns),
                   fmt::format("{}", wanted.columns));
  const auto bytes = checked_product(image.rows, image.columns, bytes_of(wanted.pixel));
  if (image.rows == 0 || !bytes || *bytes != image.length)
    return problem("its length does not fit its rows", fmt::format("{} bytes, {} rows", image.length, image.rows),
                   bytes ? fmt::format("{} bytes", *bytes) : std::string());
  return std::nullopt;
}

std::variant<std::vector<SicdRows>, core::Problem> segments_of(const std::string& file, const NitfFile& nitf,
                                                               const SicdDescription& wanted) {
  std::vector<SicdRows> parts;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < nitf.images.size(); ++i) {
    const NitfImage& image = nitf.images[i];
    if (!image.id.starts_with("SICD")) continue;  // A picture for the eye.
    if (auto problem = problem_of_segment(file, image, i, wanted)) return *std::move(problem);
    parts.push_back(
        {rows, image.rows, {image.offset, wanted.columns, bytes_of(wanted.pixel), form_of(wanted.pixel).decoder}});
    rows += image.rows;
  }
  if (rows != wanted.rows)
    return file_problem(file, "the rows of the image segments are not those of the XML text", fmt::format("{}", rows),
                        fmt::format("{}", wanted.rows));
  return parts;
}

std::variant<SicdDescription, core::Problem> description_of(const core::InputFile& file, const NitfFile& nitf) {
  const std::string name = file.path().string();
  for (const NitfExtension& extension : nitf.extensions) {
    const bool old = extension.id == "SICD_XML";
    if (!old && (extension.id != "XML_DATA_CONTENT" || !extension.schema.starts_with("urn:SICD:"))) continue;
    if (extension.length > core::longest_xml)
      return file_problem(name, "its XML text is too long", fmt::format("{} bytes", extension.length),
                          fmt::format("{} or fewer", core::longest_xml));
    std::string text(static_cast<std::size_t>(extension.length), '\0');
    file.read_all_at(extension.offset, std::as_writable_bytes(std::span(text)));
    return read_sicd_xml(text, name);
  }
  return file_problem(name, "it is a NITF file, but not a SICD one: it has no XML text of SICD",
                      fmt::format("{} data extensions", nitf.extensions.size()), "one of urn:SICD:1",
                      "other images in NITF: 'gdal_translate -of ENVI' makes an image that can be read");
}

// Whether the file is as long as its header says.
core::Problems diagnose_length(const core::InputFile& file, const NitfFile& nitf) {
  core::Problems remarks;
  const auto remark = [&](const char* message, std::uint64_t expected) {
    remarks.push_back(with_severity(file_problem(file.path().string(), message, fmt::format("{} bytes", file.size()),
                                                 fmt::format("{} bytes", expected),
                                                 "the header belongs to another file, or bytes were added or lost"),
                                    core::Severity::warning));
  };
  if (nitf.end < file.size())
    remark("bytes are left over behind the last segment that the header names", nitf.end);
  else if (nitf.length && *nitf.length != file.size())
    remark("the file is not as long as its header says (FL)", *nitf.length);
  return remarks;
}

}  // namespace

OpenedRaster open_sicd(core::InputFile file, const Format&, const RasterHints& hints, Integrity,
                       const core::StopFlag*) {
  const std::string name = file.path().string();
  auto nitf = read_nitf(file);
  if (auto* problem = std::get_if<core::Problem>(&nitf)) return {nullptr, {std::move(*problem)}};
  auto described = description_of(file, std::get<NitfFile>(nitf));
  if (auto* problem = std::get_if<core::Problem>(&described)) return {nullptr, {std::move(*problem)}};
  SicdDescription& description = std::get<SicdDescription>(described);
  auto parts = segments_of(name, std::get<NitfFile>(nitf), description);
  if (auto* problem = std::get_if<core::Problem>(&parts)) return {nullptr, {std::move(*problem)}};
  core::Problems remarks = diagnose_length(file, std::get<NitfFile>(nitf));
  RasterInfo info = info_of(file, description.columns, hints);
  info.places = std::move(description.places);
  info.attributes = std::move(description.facts);
  std::optional<Polar> polar;
  if (description.pixel == SicdPixel::polar_uint8) polar.emplace(std::move(description.amplitudes));
  return {std::make_shared<SicdRaster>(std::move(info), std::move(file),
                                       std::move(std::get<std::vector<SicdRows>>(parts)), std::move(polar)),
          std::move(remarks)};
}

}  // namespace sarsim::raster
