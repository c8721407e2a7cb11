#include "raster/format/encoder.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "raster/format/decimal_digits.hpp"
#include "raster/table/count_range.hpp"

namespace sarsim::raster {

namespace {

static_assert(std::endian::native == std::endian::little, "the encoders store numbers as they are in memory");

[[noreturn]] void throw_out_of_range(std::int64_t count, int bits) {
  throw std::out_of_range(fmt::format("count {} does not fit into {} bits", count, bits));
}

std::size_t digits_of(std::uint64_t value) {
  std::size_t digits = 1;
  for (; value >= 10; value /= 10) ++digits;
  return digits;
}

// A component that is negative and rounds to zero; the programs of 1998 wrote it as "-0".
bool is_minus_zero(std::int64_t count, double volts) { return count == 0 && volts < 0.0; }

// Writes numbers one after the other into a buffer that is large enough by construction.
class TextWriter {
 public:
  TextWriter(std::size_t capacity, CountRange range)
      : bytes_(capacity + DecimalDigits::slack),
        next_(reinterpret_cast<char*>(bytes_.data())),
        range_(range),
        highest_(range.with_offset(range.highest())),
        digits_(decimal_digits()) {}

  void put(char c) { *next_++ = c; }
  void put_signed(std::int64_t count) {
    if (range_.with_offset(count) > highest_) throw_out_of_range(count, range_.bits);
    next_ = digits_.put_signed(next_, count);
  }
  void put_with_offset(std::int64_t count) {
    const std::uint64_t stored = range_.with_offset(count);
    if (stored > highest_) throw_out_of_range(count, range_.bits);
    next_ = digits_.put(next_, stored);
  }
  std::vector<std::byte> take() {
    bytes_.resize(static_cast<std::size_t>(next_ - reinterpret_cast<char*>(bytes_.data())));
    return std::move(bytes_);
  }

 private:
  std::vector<std::byte> bytes_;
  char* next_;
  CountRange range_;
  std::uint64_t highest_;
  const DecimalDigits& digits_;
};

// Longest pair in each text format: two numbers with sign and what stands around them, and the row's end.
TextWriter writer_for(const Block& block, CountRange range) {
  const std::size_t number = 1 + digits_of(range.highest_stored());
  return {block.rows * block.columns * (2 * number + 4) + block.rows, range};
}

// Where the volts are given, a small negative component keeps its sign.
std::vector<std::byte> encode_lines(const Block& block, CountRange range, const std::complex<double>* volts) {
  TextWriter writer = writer_for(block, range);
  const std::int64_t* count = block.counts.data();
  for (std::size_t row = 0; row < block.rows; ++row) {
    for (std::size_t column = 0; column < block.columns; ++column, count += 2) {
      if (volts != nullptr && is_minus_zero(count[0], volts->real())) writer.put('-');
      writer.put_signed(count[0]);
      writer.put(' ');
      if (volts != nullptr && is_minus_zero(count[1], volts->imag())) writer.put('-');
      writer.put_signed(count[1]);
      writer.put('\n');
      if (volts != nullptr) ++volts;
    }
    writer.put('\n');
  }
  return writer.take();
}

std::vector<std::byte> encode_pairs(const Block& block, CountRange range, const std::complex<double>* volts) {
  TextWriter writer = writer_for(block, range);
  const std::int64_t* count = block.counts.data();
  for (std::size_t row = 0; row < block.rows; ++row) {
    for (std::size_t column = 0; column < block.columns; ++column, count += 2) {
      writer.put('(');
      if (volts != nullptr && is_minus_zero(count[0], volts->real())) writer.put('-');
      writer.put_signed(count[0]);
      writer.put(',');
      if (volts != nullptr && is_minus_zero(count[1], volts->imag())) writer.put('-');
      writer.put_signed(count[1]);
      writer.put(')');
      writer.put(' ');
      if (volts != nullptr) ++volts;
    }
    writer.put('\n');
  }
  return writer.take();
}

std::vector<std::byte> encode_table(const Block& block, CountRange range) {
  TextWriter writer = writer_for(block, range);
  const std::int64_t* count = block.counts.data();
  for (std::size_t row = 0; row < block.rows; ++row) {
    for (std::size_t i = 0; i < 2 * block.columns; ++i, ++count) {
      if (i > 0) writer.put(',');
      writer.put_with_offset(*count);
    }
    writer.put('\n');
  }
  return writer.take();
}

template <std::size_t Bytes>
std::vector<std::byte> encode_bytes(std::span<const std::int64_t> counts, CountRange range) {
  std::vector<std::byte> bytes(counts.size() * Bytes);
  std::byte* next = bytes.data();
  for (const std::int64_t count : counts) {
    if (!range.contains(count)) throw_out_of_range(count, range.bits);
    const std::uint64_t stored = range.with_offset(count);
    std::memcpy(next, &stored, Bytes);
    next += Bytes;
  }
  return bytes;
}

std::vector<std::byte> encode_bytes(std::span<const std::int64_t> counts, CountRange range) {
  switch (range.component_bytes()) {
    case 1: return encode_bytes<1>(counts, range);
    case 2: return encode_bytes<2>(counts, range);
    case 3: return encode_bytes<3>(counts, range);
    case 4: return encode_bytes<4>(counts, range);
    case 5: return encode_bytes<5>(counts, range);
    case 6: return encode_bytes<6>(counts, range);
    case 7: return encode_bytes<7>(counts, range);
    default: return encode_bytes<8>(counts, range);
  }
}

template <class Integer>
std::vector<std::byte> encode_integers(std::span<const std::int64_t> counts, CountRange range) {
  std::vector<std::byte> bytes(counts.size() * sizeof(Integer));
  std::byte* next = bytes.data();
  for (const std::int64_t count : counts) {
    if (!range.contains(count)) throw_out_of_range(count, range.bits);
    const auto stored = static_cast<Integer>(count);
    std::memcpy(next, &stored, sizeof stored);
    next += sizeof stored;
  }
  return bytes;
}

template <class Real>
std::vector<std::byte> encode_volts(std::span<const std::complex<double>> volts) {
  std::vector<std::byte> bytes(volts.size() * 2 * sizeof(Real));
  std::byte* next = bytes.data();
  for (const std::complex<double>& value : volts) {
    const std::array<Real, 2> stored{static_cast<Real>(value.real()), static_cast<Real>(value.imag())};
    std::memcpy(next, stored.data(), sizeof stored);
    next += sizeof stored;
  }
  return bytes;
}

void require_size(std::size_t found, std::size_t expected, const char* what) {
  if (found != expected)
    throw std::invalid_argument(fmt::format("a block holds {} {} instead of {}", found, what, expected));
}

void require_counts(const Block& block) { require_size(block.counts.size(), 2 * block.rows * block.columns, "counts"); }

// The volts whose signs the zeros among the counts keep, where they are wanted and there.
const std::complex<double>* signed_zeros_of(const Encoding& encoding, const Block& block) {
  return encoding.minus_zero && block.volts.size() == block.rows * block.columns ? block.volts.data() : nullptr;
}

}  // namespace

std::size_t binary_component_bytes(const Encoding& encoding) { return CountRange{encoding.bits}.component_bytes(); }

std::size_t array_component_bytes(const Encoding& encoding) {
  return (encoding.counts ? encoding.bits > 31 : encoding.doubles) ? 8 : 4;
}

std::vector<std::byte> encode_ascii(const Encoding& encoding, const Block& block) {
  require_counts(block);
  return encode_lines(block, CountRange{encoding.bits}, signed_zeros_of(encoding, block));
}

std::vector<std::byte> encode_bracket(const Encoding& encoding, const Block& block) {
  require_counts(block);
  return encode_pairs(block, CountRange{encoding.bits}, signed_zeros_of(encoding, block));
}

std::vector<std::byte> encode_csv(const Encoding& encoding, const Block& block) {
  require_counts(block);
  return encode_table(block, CountRange{encoding.bits});
}

std::vector<std::byte> encode_binary(const Encoding& encoding, const Block& block) {
  require_counts(block);
  return encode_bytes(block.counts, CountRange{encoding.bits});
}

std::vector<std::byte> encode_array(const Encoding& encoding, const Block& block) {
  if (!encoding.counts) {
    require_size(block.volts.size(), block.rows * block.columns, "samples");
    return encoding.doubles ? encode_volts<double>(block.volts) : encode_volts<float>(block.volts);
  }
  require_counts(block);
  const CountRange range{encoding.bits};
  return array_component_bytes(encoding) == 8 ? encode_integers<std::int64_t>(block.counts, range)
                                              : encode_integers<std::int32_t>(block.counts, range);
}

std::string csv_header(std::size_t columns) {
  std::string line;
  for (std::size_t column = 0; column < columns; ++column)
    line += fmt::format("{}I{},Q{}", column > 0 ? "," : "", column, column);
  return line + '\n';
}

}  // namespace sarsim::raster
