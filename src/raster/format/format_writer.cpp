#include "raster/format/format_writer.hpp"

#include <array>
#include <span>

#include "core/report/expect.hpp"
#include "raster/format/npy_header.hpp"
#include "raster/table/count_range.hpp"
#include "raster/table/formats.hpp"

namespace sarsim::raster {

namespace {

double rows_of(const Product& product) { return static_cast<double>(product.rows); }
double columns_of(const Product& product) { return static_cast<double>(product.columns); }
double samples_of(const Product& product) { return rows_of(product) * columns_of(product); }

double offset_of(const Encoding& encoding) { return static_cast<double>(CountRange{encoding.bits}.offset()); }

// Mean number of digits of the whole numbers 0 to `highest`.
double mean_digits(double highest) {
  double digits = 1.0;
  for (double power = 10.0; power <= highest; power *= 10.0) digits += (highest + 1.0 - power) / (highest + 1.0);
  return digits;
}

// Mean length of a count with its sign.
double mean_signed_length(const Encoding& encoding) {
  const double offset = offset_of(encoding);
  return mean_digits(offset + 1.0) + offset / (2.0 * offset + 2.0);
}

double ascii_bytes(const Product& product, const Encoding& encoding, bool) {
  return samples_of(product) * (2.0 * mean_signed_length(encoding) + 2.0) + rows_of(product);
}

double bracket_bytes(const Product& product, const Encoding& encoding, bool) {
  return samples_of(product) * (2.0 * mean_signed_length(encoding) + 4.0) + rows_of(product);
}

double csv_bytes(const Product& product, const Encoding& encoding, bool header) {
  const double columns = columns_of(product);
  const double line = header ? columns * (2.0 * mean_digits(columns - 1.0) + 4.0) : 0.0;
  return samples_of(product) * (2.0 * mean_digits(2.0 * offset_of(encoding) + 1.0) + 2.0) + line;
}

std::string csv_preamble(const Product& product, const Encoding&, bool header) {
  return header ? csv_header(product.columns) : std::string();
}

double binary_bytes(const Product& product, const Encoding& encoding, bool) {
  return samples_of(product) * 2.0 * static_cast<double>(binary_component_bytes(encoding));
}

std::string npy_preamble(const Product& product, const Encoding& encoding, bool) {
  const std::array<std::size_t, 3> shape{product.rows, product.columns, 2};
  if (!encoding.counts) return npy_header_text(encoding.doubles ? "<c16" : "<c8", std::span(shape).first(2));
  return npy_header_text(array_component_bytes(encoding) == 8 ? "<i8" : "<i4", shape);
}

double npy_bytes(const Product& product, const Encoding& encoding, bool header) {
  return samples_of(product) * 2.0 * static_cast<double>(array_component_bytes(encoding)) +
         static_cast<double>(npy_preamble(product, encoding, header).size());
}

}  // namespace

const FormatWriter ascii_writer{.encode = encode_ascii, .expected_bytes = ascii_bytes};
const FormatWriter bracket_writer{.encode = encode_bracket, .expected_bytes = bracket_bytes};
const FormatWriter csv_writer{.encode = encode_csv, .preamble = csv_preamble, .expected_bytes = csv_bytes};
const FormatWriter binary_writer{
    .encode = encode_binary, .component_bytes = binary_component_bytes, .expected_bytes = binary_bytes};
const FormatWriter npy_writer{.encode = encode_array,
                              .component_bytes = array_component_bytes,
                              .preamble = npy_preamble,
                              .expected_bytes = npy_bytes};

std::size_t component_bytes(const Encoding& encoding) {
  const FormatWriter& writer = *format_of(encoding.format).writer;
  return writer.component_bytes == nullptr ? 0 : writer.component_bytes(encoding);
}

std::vector<std::byte> encode_rows(const Encoding& encoding, const Block& block) {
  CORE_EXPECT(encoding.bits >= 1 && encoding.bits <= 64);
  return format_of(encoding.format).writer->encode(encoding, block);
}

}  // namespace sarsim::raster
