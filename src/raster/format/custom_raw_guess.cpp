#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include <fmt/format.h>

#include "core/maths/fft.hpp"
#include "raster/format/custom_raw.hpp"
#include "raster/format/raw_decode.hpp"

namespace sarsim::raster {

namespace {

constexpr std::size_t max_bytes = std::size_t{4} << 20;
constexpr std::size_t max_samples = std::size_t{1} << 19;
constexpr std::size_t statistics_samples = std::size_t{1} << 16;
constexpr std::size_t narrowest_row = 8;
constexpr std::size_t max_guesses = 10;

// Bytes from the middle of a file or, of a short one, all but its beginning, where a header may be. Data reach to the
// end of a file more often than they begin at its start, so the part is aligned to the end.
std::vector<std::byte> middle_of(const core::InputFile& file) {
  constexpr std::uint64_t alignment = 16;  // Of the largest sample.
  const std::uint64_t present = file.size() - file.size() / 4;
  const std::uint64_t size = std::min<std::uint64_t>(present, max_bytes) / alignment * alignment;
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  if (size == 0) return bytes;
  const std::uint64_t behind = (present - size) / 2 / alignment * alignment;
  bytes.resize(file.read_at(file.size() - behind - size, bytes));
  return bytes;
}

std::vector<std::complex<float>> samples_of(const std::vector<std::byte>& bytes, const RawLayout& layout,
                                            std::size_t most) {
  const StoredGrid grid = grid_of(layout);
  std::vector<std::complex<float>> samples(std::min(most, bytes.size() / grid.sample_bytes));
  grid.decode.window(grid, bytes.data(), grid.sample_bytes, samples.size(), samples.data());
  return samples;
}

// A type of numbers and how well the bytes fit it.
struct TypeGuess {
  RawNumber number = RawNumber::uint8;
  bool big_endian = false;
  double offset = 0.0;
  double score = 0.0;  // 0 to 1.
  bool negative = false;
  double headroom_bits = 0.0;
  std::string reason = {};
};

RawLayout real_layout(RawNumber number, bool big_endian) {
  RawLayout layout;
  layout.number = number;
  layout.big_endian = big_endian;
  layout.value = ImageValue::real;
  return layout;
}

// Numbers that were measured or computed lie within some tens of powers of two of each other; other bytes read as
// floating point do not.
TypeGuess judge_float(const std::vector<std::byte>& bytes, RawNumber number, bool big_endian) {
  const RawLayout layout = real_layout(number, big_endian);
  double plausible = 0.0;
  double used = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  TypeGuess guess{number, big_endian};
  const auto values = samples_of(bytes, layout, statistics_samples);
  for (const std::complex<float>& sample : values) {
    const double magnitude = std::abs(static_cast<double>(sample.real()));
    if (magnitude == 0.0) {
      plausible += 1.0;
      continue;
    }
    if (!(magnitude > 1e-30 && magnitude < 1e30)) continue;
    plausible += 1.0;
    used += 1.0;
    sum += std::log2(magnitude);
    squares += std::log2(magnitude) * std::log2(magnitude);
    guess.negative = guess.negative || sample.real() < 0.0F;
  }
  if (values.empty() || used < 0.01 * static_cast<double>(values.size())) return guess;
  const double part = plausible / static_cast<double>(values.size());
  const double spread = std::sqrt(std::max(0.0, squares / used - sum / used * (sum / used)));
  guess.score = std::pow(part, 16.0) * std::clamp((14.0 - spread) / 8.0, 0.0, 1.0);
  guess.reason = fmt::format("{:.0f} % are plausible floating-point numbers, spread over a factor of 2^{:.1f}",
                             100.0 * part, spread);
  return guess;
}

// The offset of an A/D converter whose counts are stored without a sign: 2^k - 1 in the middle of the values.
double converter_offset(double mean, double deviation, double highest) {
  for (int k = 7; k <= 31; ++k) {
    const double centre = std::exp2(k) - 1.0;
    if (std::abs(mean - centre) < 0.25 * deviation + 0.5 && highest <= 2.0 * centre + 1.0) return centre;
  }
  return 0.0;
}

// Integers use a part of their range only: read with the right size, sign and byte order they leave more bits unused
// than read otherwise.
TypeGuess judge_integer(const std::vector<std::byte>& bytes, RawNumber number, bool big_endian) {
  TypeGuess guess{number, big_endian};
  const auto values = samples_of(bytes, real_layout(number, big_endian), statistics_samples);
  if (values.empty()) return guess;
  double mean = 0.0;
  double highest = 0.0;
  for (const auto& sample : values) {
    const double value = static_cast<double>(sample.real());
    mean += value / static_cast<double>(values.size());
    highest = std::max(highest, value);
    guess.negative = guess.negative || value < 0.0;
  }
  double variance = 0.0;
  for (const auto& sample : values)
    variance += std::pow(static_cast<double>(sample.real()) - mean, 2.0) / static_cast<double>(values.size());
  const double full = std::exp2(8.0 * static_cast<double>(bytes_of(number)));
  const double uniform = full / std::sqrt(12.0);
  guess.headroom_bits = std::log2(uniform / std::max(std::sqrt(variance), 0.3));
  guess.score = std::clamp(0.3 + 0.15 * guess.headroom_bits, 0.05, 0.8);
  const bool is_signed = number == RawNumber::int8 || number == RawNumber::int16 || number == RawNumber::int32;
  if (!is_signed) guess.offset = converter_offset(mean, std::sqrt(variance), highest);
  guess.reason =
      fmt::format("integers that leave {:.1f} bits of their range unused", std::max(0.0, guess.headroom_bits));
  if (guess.offset > 0.0) guess.reason += fmt::format(", centred on {:.0f}", guess.offset);
  return guess;
}

bool is_better(const TypeGuess& one, const TypeGuess& other) {
  const bool wider = bytes_of(one.number) > bytes_of(other.number);
  return one.headroom_bits > other.headroom_bits + (wider ? 1.0 : 0.01);
}

// The best type of integers, and the best one with a sign or byte order that differs from it.
std::vector<TypeGuess> integer_types(const std::vector<std::byte>& bytes) {
  std::vector<TypeGuess> all;
  for (const RawNumber number :
       {RawNumber::uint8, RawNumber::int8, RawNumber::uint16, RawNumber::int16, RawNumber::uint32, RawNumber::int32})
    for (const bool big_endian : {false, true})
      if (bytes_of(number) > 1 || !big_endian) all.push_back(judge_integer(bytes, number, big_endian));
  std::size_t best = 0;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (is_better(all[i], all[best])) best = i;
  std::vector<TypeGuess> result{all[best]};
  for (const TypeGuess& other : all)
    if (&other != &all[best] && bytes_of(other.number) == bytes_of(result[0].number) &&
        other.headroom_bits > result[0].headroom_bits - 1.0) {
      result.push_back(other);
      result.back().score *= 0.7;
    }
  return result;
}

std::vector<TypeGuess> type_guesses(const std::vector<std::byte>& bytes) {
  std::vector<TypeGuess> guesses;
  for (const RawNumber number : {RawNumber::float64, RawNumber::float32})
    for (const bool big_endian : {false, true}) {
      TypeGuess guess = judge_float(bytes, number, big_endian);
      if (guess.score > 0.3) guesses.push_back(std::move(guess));
    }
  const bool floats = !guesses.empty();
  for (TypeGuess& guess : integer_types(bytes)) {
    if (floats) guess.score *= 0.3;
    guesses.push_back(std::move(guess));
  }
  std::ranges::stable_sort(guesses, std::greater<>(), &TypeGuess::score);
  if (guesses.size() > 3) guesses.resize(3);
  return guesses;
}

double correlation_at(std::span<const std::complex<float>> samples, std::size_t lag) {
  double mean = 0.0;
  for (const auto& sample : samples) mean += static_cast<double>(sample.real()) / static_cast<double>(samples.size());
  double product = 0.0;
  double power = 0.0;
  for (std::size_t i = 0; i + lag < samples.size(); ++i) {
    const double a = static_cast<double>(samples[i].real()) - mean;
    product += a * (static_cast<double>(samples[i + lag].real()) - mean);
    power += a * a;
  }
  return power > 0.0 ? product / power : 0.0;
}

struct ValueGuess {
  ImageValue value;
  std::string reason;
};

// Neighbouring numbers of an image agree; of I, Q, I, Q it is every second one that does.
ValueGuess value_of(const std::vector<std::byte>& bytes, const TypeGuess& type) {
  const auto values = samples_of(bytes, real_layout(type.number, type.big_endian), statistics_samples);
  const double next = correlation_at(values, 1);
  const double second = correlation_at(values, 2);
  const bool alike = next > 0.1 && next > 0.7 * second;
  const bool one_sided = !type.negative && type.offset == 0.0;
  if (one_sided)
    return {alike || std::abs(second) < 0.1 || next > 0.5 * second ? ImageValue::magnitude : ImageValue::complex,
            "none is negative"};
  if (alike) return {ImageValue::real, fmt::format("neighbours agree ({:.2f})", next)};
  return {ImageValue::complex, fmt::format("neighbours differ ({:.2f}), as I and Q do", next)};
}

// |autocorrelation| of a sequence at lags 0 to half its length, 1 at lag 0.
std::vector<double> autocorrelation(std::span<const std::complex<double>> values) {
  const std::size_t size = core::good_fft_size(2 * values.size());
  std::vector<std::complex<double>> spectrum(values.begin(), values.end());
  spectrum.resize(size);
  const core::Fft fft(size);
  fft.forward(spectrum);
  for (auto& value : spectrum) value = std::norm(value);
  fft.inverse(spectrum);
  std::vector<double> result(values.size() / 2);
  const double power = spectrum[0].real();
  for (std::size_t lag = 0; lag < result.size() && power > 0.0; ++lag)
    result[lag] =
        std::abs(spectrum[lag]) / power * static_cast<double>(values.size()) / static_cast<double>(values.size() - lag);
  return result;
}

// Of what can agree from row to row: the samples themselves, or their magnitudes where phases change.
std::vector<double> agreement(std::span<const std::complex<float>> samples) {
  std::vector<std::complex<double>> values(samples.size());
  std::vector<std::complex<double>> magnitudes(samples.size());
  std::complex<double> mean = 0.0;
  double mean_magnitude = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto sample = std::complex<double>(samples[i]);
    values[i] = std::isfinite(std::norm(sample)) ? sample : 0.0;
    magnitudes[i] = std::abs(values[i]);
    mean += values[i] / static_cast<double>(samples.size());
    mean_magnitude += magnitudes[i].real() / static_cast<double>(samples.size());
  }
  for (auto& value : values) value -= mean;
  for (auto& value : magnitudes) value -= mean_magnitude;
  std::vector<double> result = autocorrelation(values);
  const std::vector<double> other = autocorrelation(magnitudes);
  for (std::size_t lag = 0; lag < result.size(); ++lag) result[lag] = std::max(result[lag], other[lag]);
  return result;
}

struct WidthGuess {
  std::size_t width = 0;
  double score = 0.0;
  std::string reason;
};

// The smallest spacing at which the agreement rises nearly as high as anywhere behind its first fall.
std::optional<WidthGuess> width_by_agreement(const std::vector<double>& alike, std::size_t samples) {
  std::size_t begin = narrowest_row;
  while (begin + 1 < alike.size() && alike[begin + 1] < alike[begin]) ++begin;
  if (begin + 2 >= alike.size()) return std::nullopt;
  const auto first = alike.begin() + static_cast<std::ptrdiff_t>(begin);
  const double best = *std::max_element(first, alike.end());
  const double noise = 1.0 / std::sqrt(static_cast<double>(samples));
  if (best < 8.0 * noise) return std::nullopt;
  for (std::size_t lag = begin + 1; lag + 1 < alike.size(); ++lag) {
    if (alike[lag] < 0.9 * best || alike[lag] < alike[lag - 1] || alike[lag] < alike[lag + 1]) continue;
    // Its surroundings may rise to a higher peak within some samples.
    std::size_t peak = lag;
    for (std::size_t near = lag; near < std::min(lag + lag / 8, alike.size()); ++near)
      if (alike[near] > alike[peak]) peak = near;
    return WidthGuess{peak, std::clamp(0.5 + alike[peak], 0.5, 0.95),
                      fmt::format("samples {} apart agree most ({:.2f})", peak, alike[peak])};
  }
  return std::nullopt;
}

std::uint64_t whole_samples(std::uint64_t file_bytes, std::size_t sample_bytes) { return file_bytes / sample_bytes; }

// Common widths of which the file holds whole rows, the one nearest to a square first.
std::vector<WidthGuess> widths_by_size(std::uint64_t samples) {
  std::vector<WidthGuess> guesses;
  for (std::size_t width = 64; width <= 65536; width *= 2)
    for (const std::size_t candidate : {width, width + width / 4, width + width / 2})
      if (samples % candidate == 0 && samples / candidate >= 2)
        guesses.push_back({candidate, 0.25, fmt::format("the file holds whole rows of {}", candidate)});
  const auto from_square = [&](const WidthGuess& guess) {
    const auto width = static_cast<double>(guess.width);
    return std::abs(std::log(width * width / static_cast<double>(samples)));
  };
  std::ranges::stable_sort(guesses, {}, from_square);
  if (guesses.size() > 3) guesses.resize(3);
  for (std::size_t i = 0; i < guesses.size(); ++i) guesses[i].score -= 0.05 * static_cast<double>(i);
  return guesses;
}

// A peak that is a sample off where rows are shifted against each other is moved to where the file holds whole rows.
void settle_on_whole_rows(WidthGuess& guess, std::uint64_t samples) {
  if (samples % guess.width == 0) {
    guess.reason += ", and the file holds whole rows of them";
    return;
  }
  for (const std::size_t width : {guess.width + 1, guess.width - 1})
    if (width >= narrowest_row && samples % width == 0) {
      guess.reason += fmt::format(", and the file holds whole rows of {}", width);
      guess.width = width;
      return;
    }
  guess.score *= 0.9;
}

void add_widths(std::vector<RawGuess>& guesses, const RawLayout& layout, const TypeGuess& type, const std::string& why,
                const std::vector<std::byte>& bytes, std::uint64_t file_bytes) {
  const std::size_t sample_bytes = layout.sample_bytes();
  const std::uint64_t samples = whole_samples(file_bytes, sample_bytes);
  std::vector<WidthGuess> widths;
  const auto part = samples_of(bytes, layout, max_samples);
  if (auto width = width_by_agreement(agreement(part), part.size())) {
    settle_on_whole_rows(*width, samples);
    widths.push_back(std::move(*width));
  }
  for (WidthGuess& width : widths_by_size(samples))
    if (std::ranges::find(widths, width.width, &WidthGuess::width) == widths.end()) widths.push_back(std::move(width));
  if (widths.empty() && samples > 0)
    widths.push_back(
        {static_cast<std::size_t>(std::min<std::uint64_t>(samples, 1024)), 0.05, "nothing tells the width"});
  for (const WidthGuess& width : widths) {
    RawGuess guess{layout, type.score * width.score, {}};
    guess.layout.width = width.width;
    guess.layout.header_bytes = file_bytes % (std::uint64_t{width.width} * sample_bytes);
    guess.reason = type.reason + "; " + why + "; " + width.reason;
    if (guess.layout.header_bytes > 0)
      guess.reason +=
          fmt::format("; {} bytes that make no whole row are taken for a header", guess.layout.header_bytes);
    guesses.push_back(std::move(guess));
  }
}

}  // namespace

std::variant<std::vector<RawGuess>, core::Problem> guess_raw_layout(const std::filesystem::path& path) {
  auto opened = core::InputFile::open(path);
  if (auto* problem = std::get_if<core::Problem>(&opened)) return std::move(*problem);
  const auto& file = std::get<core::InputFile>(opened);
  const std::vector<std::byte> bytes = middle_of(file);
  std::vector<RawGuess> guesses;
  if (bytes.empty()) return guesses;
  for (const TypeGuess& type : type_guesses(bytes)) {
    const ValueGuess value = value_of(bytes, type);
    RawLayout layout;
    layout.number = type.number;
    layout.big_endian = type.big_endian;
    layout.value = value.value;
    layout.offset = value.value == ImageValue::complex ? type.offset : 0.0;
    add_widths(guesses, layout, type, value.reason, bytes, file.size());
  }
  std::ranges::stable_sort(guesses, std::greater<>(), &RawGuess::likelihood);
  if (guesses.size() > max_guesses) guesses.resize(max_guesses);
  return guesses;
}

}  // namespace sarsim::raster
