#include "signal/measure/image_quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"

namespace sarsim::signal {

namespace {

using Complex = std::complex<double>;

// A sample of the image.
struct Sample {
  std::ptrdiff_t row = 0;
  std::ptrdiff_t column = 0;
};

// Samples first ... last (not included) of an axis within `search_m` of a coordinate.
struct Span {
  std::ptrdiff_t first = 0;
  std::ptrdiff_t last = 0;
};

Span span_of(const ImageAxis& axis, double centre_m, double search_m) {
  const double reach = std::abs(search_m / axis.step_m);
  const double centre = axis.index_of(centre_m);
  const auto count = static_cast<double>(axis.count);
  const double first = std::clamp(std::floor(centre - reach), 0.0, count);
  const double last = std::clamp(std::ceil(centre + reach) + 1.0, first, count);
  return {static_cast<std::ptrdiff_t>(first), static_cast<std::ptrdiff_t>(last)};
}

// The largest sample of an area that is no smaller than its neighbours, those beside the area included: what only rises
// towards a stronger response next to the area is not in it. Where there is none, the largest.
std::optional<Sample> largest_sample(const FocusedImage& image, const ImageReader& reader, const ImagePlace& expected,
                                     double search_m) {
  const Span rows = span_of(image.azimuth, expected.azimuth_m, search_m);
  const Span columns = span_of(image.range, expected.range_m, search_m);
  if (rows.first >= rows.last || columns.first >= columns.last) return std::nullopt;
  const auto widened = [](const Span& span, const ImageAxis& axis) {
    return Span{std::max<std::ptrdiff_t>(span.first - 1, 0),
                std::min(span.last + 1, static_cast<std::ptrdiff_t>(axis.count))};
  };
  const Span all_rows = widened(rows, image.azimuth);
  const Span all_columns = widened(columns, image.range);
  const auto width = static_cast<std::size_t>(all_columns.last - all_columns.first);
  std::vector<std::complex<float>> values(width);
  std::vector<float> powers;
  for (std::ptrdiff_t row = all_rows.first; row < all_rows.last; ++row) {
    reader(static_cast<std::size_t>(row), static_cast<std::size_t>(all_columns.first), values);
    for (const std::complex<float> value : values) powers.push_back(std::norm(value));
  }
  const auto power = [&](std::ptrdiff_t row, std::ptrdiff_t column) {
    row = std::clamp(row, all_rows.first, all_rows.last - 1);
    column = std::clamp(column, all_columns.first, all_columns.last - 1);
    return powers[static_cast<std::size_t>(row - all_rows.first) * width +
                  static_cast<std::size_t>(column - all_columns.first)];
  };
  const auto is_peak = [&](const Sample& at) {
    for (std::ptrdiff_t row = at.row - 1; row <= at.row + 1; ++row)
      for (std::ptrdiff_t column = at.column - 1; column <= at.column + 1; ++column)
        if (power(row, column) > power(at.row, at.column)) return false;
    return true;
  };
  std::optional<Sample> largest, peak;
  for (std::ptrdiff_t row = rows.first; row < rows.last; ++row)
    for (std::ptrdiff_t column = columns.first; column < columns.last; ++column) {
      const Sample at{row, column};
      if (!(power(row, column) > 0.0F)) continue;
      if (!largest || power(row, column) > power(largest->row, largest->column)) largest = at;
      if ((!peak || power(row, column) > power(peak->row, peak->column)) && is_peak(at)) peak = at;
    }
  return peak ? peak : largest;
}

// A square piece of an image as the sum of its spectrum: u and v are rows and columns from the piece's middle.
class Chip {
 public:
  Chip(const FocusedImage& image, const ImageReader& reader, const Sample& middle, std::size_t size)
      : size_(size), spectrum_(size * size) {
    load(image, reader, middle);
    transform();
    row_hz_ = frequencies(image.azimuth);
    column_hz_ = frequencies(image.range);
  }

  [[nodiscard]] std::size_t size() const { return size_; }

  /// The value and its derivatives: I, I_u, I_v, I_uu, I_uv, I_vv.
  [[nodiscard]] std::array<Complex, 6> jet(double u, double v) const {
    std::array<Complex, 6> sums{};
    const std::vector<Complex> turns = turns_at(column_hz_, v);
    for (std::size_t k = 0; k < size_; ++k) {
      std::array<Complex, 3> row{};
      for (std::size_t l = 0; l < size_; ++l) {
        const Complex term = spectrum_[k * size_ + l] * turns[l];
        const Complex slope(0.0, 2.0 * core::pi * column_hz_[l]);
        row[0] += term;
        row[1] += slope * term;
        row[2] += slope * slope * term;
      }
      const Complex turn = std::polar(1.0, 2.0 * core::pi * row_hz_[k] * u);
      const Complex slope(0.0, 2.0 * core::pi * row_hz_[k]);
      sums[0] += turn * row[0];
      sums[1] += turn * slope * row[0];
      sums[2] += turn * row[1];
      sums[3] += turn * slope * slope * row[0];
      sums[4] += turn * slope * row[1];
      sums[5] += turn * row[2];
    }
    return sums;
  }

  /// Values at (u, v) + i (du, dv), i = -half ... half.
  [[nodiscard]] std::vector<Complex> line(double u, double v, double du, double dv, std::ptrdiff_t half) const {
    std::vector<Complex> values(static_cast<std::size_t>(2 * half + 1));
    if (dv == 0.0) {
      const std::vector<Complex> turns = turns_at(column_hz_, v);
      for (std::size_t k = 0; k < size_; ++k) {
        Complex sum;
        for (std::size_t l = 0; l < size_; ++l) sum += spectrum_[k * size_ + l] * turns[l];
        add_tone(values, sum, row_hz_[k], u, du, half);
      }
      return values;
    }
    if (du == 0.0) {
      const std::vector<Complex> turns = turns_at(row_hz_, u);
      for (std::size_t l = 0; l < size_; ++l) {
        Complex sum;
        for (std::size_t k = 0; k < size_; ++k) sum += spectrum_[k * size_ + l] * turns[k];
        add_tone(values, sum, column_hz_[l], v, dv, half);
      }
      return values;
    }
    fill_oblique(values, u, v, du, dv, half);
    return values;
  }

 private:
  void load(const FocusedImage& image, const ImageReader& reader, const Sample& middle) {
    const auto half = static_cast<std::ptrdiff_t>(size_ / 2);
    const auto rows = static_cast<std::ptrdiff_t>(image.azimuth.count);
    const auto columns = static_cast<std::ptrdiff_t>(image.range.count);
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(middle.column - half, 0);
    const std::ptrdiff_t last = std::min(middle.column - half + static_cast<std::ptrdiff_t>(size_), columns);
    std::vector<std::complex<float>> values(static_cast<std::size_t>(last - first));
    for (std::size_t k = 0; k < size_; ++k) {
      const std::ptrdiff_t row = middle.row - half + static_cast<std::ptrdiff_t>(k);
      if (row < 0 || row >= rows) continue;
      reader(static_cast<std::size_t>(row), static_cast<std::size_t>(first), values);
      const auto skipped = static_cast<std::size_t>(first - (middle.column - half));
      for (std::size_t i = 0; i < values.size(); ++i) spectrum_[k * size_ + skipped + i] = Complex(values[i]);
    }
  }

  void transform() {
    const core::Fft fft(size_);
    const double scale = 1.0 / (static_cast<double>(size_) * static_cast<double>(size_));
    std::vector<Complex> column(size_);
    for (std::size_t k = 0; k < size_; ++k) fft.forward(std::span(spectrum_).subspan(k * size_, size_));
    for (std::size_t l = 0; l < size_; ++l) {
      for (std::size_t k = 0; k < size_; ++k) column[k] = spectrum_[k * size_ + l];
      fft.forward(column);
      // The middle of the piece is the origin.
      for (std::size_t k = 0; k < size_; ++k)
        spectrum_[k * size_ + l] = ((k + l) % 2 == 0 ? scale : -scale) * column[k];
    }
  }

  // Of the bins, in cycles per sample, within half a cycle of the spectrum's centre.
  [[nodiscard]] std::vector<double> frequencies(const ImageAxis& axis) const {
    const double centre = axis.spectrum_centre_per_m * axis.step_m;
    std::vector<double> hz(size_);
    for (std::size_t k = 0; k < size_; ++k) {
      const double base = static_cast<double>(k) / static_cast<double>(size_);
      hz[k] = base + std::floor(centre - base + 0.5);
    }
    return hz;
  }

  static std::vector<Complex> turns_at(const std::vector<double>& hz, double x) {
    std::vector<Complex> turns(hz.size());
    for (std::size_t k = 0; k < hz.size(); ++k) turns[k] = std::polar(1.0, 2.0 * core::pi * hz[k] * x);
    return turns;
  }

  static void add_tone(std::vector<Complex>& values, Complex tone, double hz, double x, double dx,
                       std::ptrdiff_t half) {
    Complex term = tone * std::polar(1.0, 2.0 * core::pi * hz * (x - static_cast<double>(half) * dx));
    const Complex step = std::polar(1.0, 2.0 * core::pi * hz * dx);
    for (Complex& value : values) {
      value += term;
      term *= step;
    }
  }

  // A slanting line, magnitudes only: its values at every sixteenth place, without the carrier, fix those between.
  void fill_oblique(std::vector<Complex>& values, double u, double v, double du, double dv, std::ptrdiff_t half) const {
    constexpr std::ptrdiff_t fineness = 16;
    const std::ptrdiff_t coarse_half = half / fineness;
    const auto count = static_cast<std::size_t>(2 * coarse_half);
    std::vector<Complex> coarse(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto step = static_cast<double>((static_cast<std::ptrdiff_t>(i) - coarse_half) * fineness);
      coarse[i] = value(u + step * du, v + step * dv);
    }
    core::Fft(count).forward(coarse);
    std::vector<Complex> fine(count * fineness);
    for (std::size_t k = 0; k < count; ++k)
      fine[2 * k < count ? k : fine.size() - count + k] = coarse[k] / static_cast<double>(count);
    core::Fft(fine.size()).inverse(fine);
    const auto first = static_cast<std::size_t>(half - coarse_half * fineness);
    std::copy_n(fine.begin(), std::min(fine.size(), values.size() - first),
                values.begin() + static_cast<std::ptrdiff_t>(first));
  }

  // Frequencies without the whole cycles and the centre that they were given.
  [[nodiscard]] static std::vector<double> about_zero(std::vector<double> hz) {
    const double centre = 0.5 * (std::ranges::min(hz) + std::ranges::max(hz));
    for (double& value : hz) value -= centre;
    return hz;
  }

  // The value without its carrier.
  [[nodiscard]] Complex value(double u, double v) const {
    const std::vector<Complex> rows = turns_at(about_zero(row_hz_), u);
    const std::vector<Complex> columns = turns_at(about_zero(column_hz_), v);
    double real = 0.0;
    double imag = 0.0;
    for (std::size_t k = 0; k < size_; ++k) {
      double row_real = 0.0;
      double row_imag = 0.0;
      for (std::size_t l = 0; l < size_; ++l) {
        const Complex s = spectrum_[k * size_ + l];
        const Complex t = columns[l];
        row_real += s.real() * t.real() - s.imag() * t.imag();
        row_imag += s.real() * t.imag() + s.imag() * t.real();
      }
      real += row_real * rows[k].real() - row_imag * rows[k].imag();
      imag += row_real * rows[k].imag() + row_imag * rows[k].real();
    }
    return {real, imag};
  }

  std::size_t size_;
  std::vector<Complex> spectrum_;
  std::vector<double> row_hz_;
  std::vector<double> column_hz_;
};

struct Peak {
  double u = 0.0;
  double v = 0.0;
  Complex value;
};

// Logarithm of the power with halves of its derivatives.
struct LogPower {
  Complex value;
  double pu = 0.0, pv = 0.0;
  double puu = 0.0, puv = 0.0, pvv = 0.0;

  [[nodiscard]] double power() const { return std::norm(value); }
  [[nodiscard]] double determinant() const { return puu * pvv - puv * puv; }
  [[nodiscard]] bool concave() const { return determinant() > 0.0 && puu < 0.0; }
};

LogPower log_power_at(const Chip& chip, double u, double v) {
  const auto [i, iu, iv, iuu, iuv, ivv] = chip.jet(u, v);
  LogPower at{.value = i};
  const double power = std::norm(i);
  if (!(power > 0.0)) return at;
  const auto share = [power](Complex a, Complex b) { return (std::conj(a) * b).real() / power; };
  at.pu = share(i, iu);
  at.pv = share(i, iv);
  at.puu = share(i, iuu) + share(iu, iu) - 2.0 * at.pu * at.pu;
  at.puv = share(i, iuv) + share(iu, iv) - 2.0 * at.pu * at.pv;
  at.pvv = share(i, ivv) + share(iv, iv) - 2.0 * at.pv * at.pv;
  return at;
}

// Newton's step where the logarithm is concave, no longer than what would gain so much of it; else a quarter of a
// sample uphill.
std::pair<double, double> step_of(const LogPower& at) {
  constexpr double max_gain = 0.5;  // nepers of power in the quadratic model: within a main lobe
  if (!at.concave()) {
    const double slope = std::hypot(at.pu, at.pv);
    return slope > 0.0 ? std::pair(0.25 * at.pu / slope, 0.25 * at.pv / slope) : std::pair(0.0, 0.0);
  }
  const double du = -(at.pvv * at.pu - at.puv * at.pv) / at.determinant();
  const double dv = -(at.puu * at.pv - at.puv * at.pu) / at.determinant();
  const double gain = at.pu * du + at.pv * dv;
  const double part = gain > max_gain ? std::sqrt(max_gain / gain) : 1.0;
  return {part * du, part * dv};
}

// The maximum of |I|^2 near the middle of a chip: Newton's method on its logarithm, which is concave over a whole main
// lobe, whereas |I|^2 is so only within 0.4 of a cell of the peak. The way may be many samples long: where the beam
// squints, the main lobe is a ridge across rows and columns, along which the power changes little from one sample to
// the next.
Peak peak_of(const Chip& chip) {
  constexpr int max_steps = 60;
  const double room = static_cast<double>(chip.size()) / 4.0;
  Peak peak;
  LogPower here = log_power_at(chip, 0.0, 0.0);
  for (int iteration = 0; iteration < max_steps && here.power() > 0.0; ++iteration) {
    auto [du, dv] = step_of(here);
    LogPower next = here;
    for (int halving = 0; halving < 8; ++halving) {
      next = log_power_at(chip, peak.u + du, peak.v + dv);
      if (next.power() >= here.power() * (1.0 - 1e-12)) break;
      du *= 0.5;
      dv *= 0.5;
    }
    if (!(next.power() >= here.power() * (1.0 - 1e-12))) break;
    if (std::abs(peak.u + du) > room || std::abs(peak.v + dv) > room) break;
    peak.u += du;
    peak.v += dv;
    here = next;
    if (std::hypot(du, dv) < 1e-9) break;
  }
  peak.value = here.value;
  return peak;
}

// A cut along a direction given in metres.
ResponseCut cut(const FocusedImage& image, const Chip& chip, const Peak& peak, double azimuth, double range) {
  constexpr double steps_per_sample = 32.0;
  const double u = azimuth / image.azimuth.step_m;
  const double v = range / image.range.step_m;
  const double step_m = 1.0 / (steps_per_sample * std::max(std::abs(u), std::abs(v)));
  const auto half = static_cast<std::ptrdiff_t>((static_cast<double>(chip.size()) / 2.0 - 2.0) * steps_per_sample);
  return {step_m, chip.line(peak.u, peak.v, u * step_m, v * step_m, half)};
}

// With widths in metres.
std::optional<ResponseFigures> measured(const ResponseCut& cut) {
  auto figures = figures_of(cut.values, cut.values.size() / 2);
  if (!figures) return std::nullopt;
  figures->width *= cut.step_m;
  figures->null *= cut.step_m;
  return figures;
}

// Samples of an axis that the integrated sidelobes of a cut along it extend over.
double reach_in_samples(const ResponseFigures& figures, const ImageAxis& axis) {
  return (1.0 + islr_null_widths) * figures.null / axis.step_m;
}

}  // namespace

ResponseAxes response_axes(const FocusedImage& image) {
  const double azimuth = image.azimuth.spectrum_centre_per_m;
  const double range = image.range.spectrum_centre_per_m + radar::turns_per_m(image.carrier_hz, image.light_speed_mps);
  const double size = std::hypot(azimuth, range);
  // Below half a degree cuts along the axes differ by less than a tenth of a cell where the last sidelobes are counted.
  if (!(std::abs(azimuth) > 0.01 * size)) return {};
  return {{azimuth / size, range / size}, {range / size, -azimuth / size}};
}

ImageReader reader_of(const FocusedImage& image) {
  CORE_EXPECT(image.values.size() == image.azimuth.count * image.range.count);
  return [&image](std::size_t row, std::size_t first_column, std::span<std::complex<float>> out) {
    std::copy_n(image.values.data() + row * image.range.count + first_column, out.size(), out.data());
  };
}

std::optional<PointResponse> measure_point(const FocusedImage& image, const ImageReader& reader,
                                           const ImagePlace& expected, double search_m, PointCuts* cuts) {
  CORE_EXPECT(reader);
  CORE_EXPECT(search_m >= 0.0);
  CORE_EXPECT(image.azimuth.step_m != 0.0);
  CORE_EXPECT(image.range.step_m != 0.0);
  constexpr std::size_t largest_chip = 512;
  const auto middle = largest_sample(image, reader, expected, search_m);
  if (!middle) return std::nullopt;
  const ResponseAxes axes = response_axes(image);
  for (std::size_t size = 64; size <= largest_chip; size *= 2) {
    const Chip chip(image, reader, *middle, size);
    const Peak peak = peak_of(chip);
    ResponseCut azimuth_cut = cut(image, chip, peak, axes.azimuth.azimuth_m, axes.azimuth.range_m);
    ResponseCut range_cut = cut(image, chip, peak, axes.range.azimuth_m, axes.range.range_m);
    const auto azimuth = measured(azimuth_cut);
    const auto range = measured(range_cut);
    const double room = static_cast<double>(size) / 2.0 - 8.0;
    const bool last = size == largest_chip;
    if (!azimuth || !range) {
      if (last) return std::nullopt;
      continue;
    }
    const bool fits = reach_in_samples(*azimuth, image.azimuth) < room && reach_in_samples(*range, image.range) < room;
    if (!fits && !last) continue;
    if (cuts != nullptr) *cuts = {std::move(azimuth_cut), std::move(range_cut)};
    const double row = static_cast<double>(middle->row) + peak.u;
    const double column = static_cast<double>(middle->column) + peak.v;
    return PointResponse{.place = {image.azimuth.at(row), image.range.at(column)},
                         .amplitude = std::abs(peak.value),
                         .phase_rad = std::arg(peak.value),
                         .azimuth = *azimuth,
                         .range = *range};
  }
  return std::nullopt;
}

}  // namespace sarsim::signal
