#include "raster/sicd/sicd_writer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/letters.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t held_bytes = std::size_t{64} << 20U;
constexpr std::size_t min_held = 64;

float turned_bytes(float value) { return std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value))); }

// "20240401225942" of "2024-04-01T22:59:42.5Z".
std::string compact_date(const std::string& date) {
  std::string digits;
  for (const char c : date.substr(0, 19))
    if (core::is_digit(c)) digits += c;
  return digits;
}

}  // namespace

NitfContent nitf_content(const Sicd& image) {
  NitfContent content;
  content.rows = image.rows;
  content.columns = image.columns;
  content.date = compact_date(image.start);
  content.title = image.name;
  content.source = image.collector;
  for (std::size_t i = 0; i < image.corners.size(); ++i) {
    const radar::Geodetic& corner = image.corners[i];
    content.corners[i] = {core::deg_per_rad * corner.latitude_rad, core::deg_per_rad * corner.longitude_rad};
    const core::Vec3 ecf_m = radar::ecef_of({corner.latitude_rad, corner.longitude_rad, 0.0});
    content.corners_ecf_m[i] = {ecf_m.x, ecf_m.y, ecf_m.z};
  }
  content.schema = sicd_name_space;
  content.schema_title = "SICD Volume 1 Design & Implementation Description Document";
  content.schema_version = "1.3.0";
  content.schema_date = "2021-11-30T00:00:00Z";
  content.xml = sicd_xml(image);
  return content;
}

SicdWriter::SicdWriter(const std::filesystem::path& path, const Sicd& image, bool backwards, bool replace)
    : file_(path, replace),
      layout_(lay_out_nitf(nitf_content(image))),
      rows_(image.rows),
      columns_(image.columns),
      backwards_(backwards) {
  if (!file_.seekable())
    throw core::InvalidRequest(
        "'" + path.string() + "' is a pipe, and a SICD file is not written from its beginning to its end",
        "name a file");
  const std::size_t fitting = std::max(min_held, held_bytes / (rows_ * sizeof(std::complex<float>)));
  at_once_ = std::min(fitting, columns_);
  turned_.resize(rows_ * at_once_);
  file_.resize(layout_.size);
  for (const auto& [offset, text] : layout_.texts) file_.write_at(offset, std::as_bytes(std::span(text)));
}

void SicdWriter::append(std::span<const std::complex<float>> row) {
  CORE_EXPECT(row.size() == rows_);
  CORE_EXPECT(appended_ < columns_);
  const std::size_t place = backwards_ ? at_once_ - 1 - held_ : held_;
  for (std::size_t r = 0; r < rows_; ++r)
    turned_[r * at_once_ + place] = {turned_bytes(row[r].real()), turned_bytes(row[r].imag())};
  ++held_;
  ++appended_;
  if (held_ == at_once_ || appended_ == columns_) write_held();
}

void SicdWriter::write_held() {
  const std::size_t first = backwards_ ? columns_ - appended_ : appended_ - held_;
  const std::size_t from = backwards_ ? at_once_ - held_ : 0;
  for (const NitfRows& segment : layout_.segments)
    for (std::size_t i = 0; i < segment.count; ++i) {
      const auto stretch = std::span(turned_).subspan((segment.first + i) * at_once_ + from, held_);
      const std::uint64_t pixel = std::uint64_t{i} * columns_ + first;
      file_.write_at(segment.offset + pixel * sizeof(std::complex<float>), std::as_bytes(stretch));
    }
  held_ = 0;
}

void SicdWriter::finish() {
  if (appended_ != columns_) throw std::logic_error("rows of the image are missing");
  file_.secure();
  file_.commit();
}

}  // namespace sarsim::raster
