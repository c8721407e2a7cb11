#include "signal/sar/autofocus.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <span>
#include <stdexcept>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/report/expect.hpp"
#include "radar/path/path.hpp"
#include "signal/sar/best_line.hpp"

namespace sarsim::signal {

namespace {

// Columns of an image, each with its azimuth in one piece.
class AzimuthColumns {
 public:
  AzimuthColumns(std::size_t columns, std::size_t size) : size_(size), values_(columns * size) {}

  [[nodiscard]] std::size_t count() const { return size_ > 0 ? values_.size() / size_ : 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<std::complex<double>> column(std::size_t i) {
    return std::span(values_).subspan(i * size_, size_);
  }
  [[nodiscard]] std::span<const std::complex<double>> column(std::size_t i) const {
    return std::span(values_).subspan(i * size_, size_);
  }

 private:
  std::size_t size_;
  std::vector<std::complex<double>> values_;
};

// Frequencies that an aperture may have, in steps of 1/size.
struct SpectrumBand {
  double centre = 0.0;  // Any fold of the spectrum.
  double width = 0.0;   // Full; 0: all.
};

// What the phase gradient says about the spectra of columns.
struct GradientResult {
  long first_frequency = 0;       // In steps of 1/size; the middle lies within half the sampling rate of the band's.
  std::vector<double> phase_rad;  // From there on, within the aperture.
  std::vector<double> round_rad;
  std::vector<double> amplitude;  // Of the spectra there, root mean square: as long as phase_rad.
  double energy = 0.0;            // Of the columns.
};

constexpr std::size_t grain = 16;  // columns of a partial sum

// Sums over columns that do not depend on how many threads share them: one for every `grain` columns, added in order.
template <class Value, class AddColumn>
std::vector<Value> sum_over_columns(const AzimuthColumns& columns, const core::WorkControl& control,
                                    const AddColumn& add) {
  const std::size_t size = columns.size();
  std::vector<std::vector<Value>> parts((columns.count() + grain - 1) / grain);
  core::parallel_ranges(columns.count(), grain, control, [&](std::size_t begin, std::size_t end) {
    std::vector<Value>& part = parts[begin / grain];
    part.resize(size);
    std::vector<std::complex<double>> scratch(size);
    for (std::size_t i = begin; i < end; ++i) add(i, part, scratch);
  });
  std::vector<Value> sum(size);
  for (const auto& part : parts)
    for (std::size_t k = 0; k < size; ++k) sum[k] += part[k];
  return sum;
}

// The frequencies that the spectrum fills: `count` of them from `first` on, in a circle.
struct Support {
  long first = 0;
  std::size_t count = 0;
};

std::size_t wrapped(long k, long size) { return static_cast<std::size_t>((k % size + size) % size); }

// The power that only a few frequencies of the smoothed spectrum exceed, be the aperture all of it or a small part.
double strong_level(const std::vector<double>& power, long reach) {
  const auto size = static_cast<long>(power.size());
  std::vector<double> smooth;
  for (long k = 0; k < size; ++k) {
    double sum = 0.0;
    for (long j = k - reach; j <= k + reach; ++j) sum += power[wrapped(j, size)];
    smooth.push_back(sum / static_cast<double>(2 * reach + 1));
  }
  std::ranges::sort(smooth);
  return smooth[static_cast<std::size_t>(97 * (size - 1) / 100)];
}

Support support_of(const std::vector<double>& power, const SpectrumBand& band, double share) {
  const auto size = static_cast<long>(power.size());
  // Gaps of a few weak frequencies do not split the aperture.
  const long reach = size / 64;
  const double level = share * strong_level(power, reach);
  const auto is_in_band = [&](long k) {
    const double from_centre = static_cast<double>(k) - band.centre;
    const auto full = static_cast<double>(size);
    return band.width <= 0.0 || std::abs(from_centre - full * std::round(from_centre / full)) <= 0.5 * band.width;
  };
  const auto is_strong = [&](long k) { return is_in_band(k) && power[wrapped(k, size)] > level; };
  const auto is_full = [&](long k) {
    bool before = is_strong(k);
    bool after = before;
    for (long j = 1; j <= reach && !(before && after); ++j) {
      before = before || is_strong(k - j);
      after = after || is_strong(k + j);
    }
    return before && after;
  };
  // The longest empty run is what lies outside.
  long longest = 0, longest_end = 0, run = 0;
  for (long k = 0; k < 2 * size; ++k) {
    run = is_full(k % size) ? 0 : std::min(run + 1, size);
    if (run > longest) {
      longest = run;
      longest_end = k + 1;
    }
  }
  if (longest >= size) return {};
  const long centre = std::lround(band.centre);
  if (longest == 0) return {centre - size / 2, power.size()};
  long first = longest_end % size;
  const long count = size - longest;
  // The middle within half the sampling rate of the band's.
  while (2 * (first - centre) + count > size) first -= size;
  while (2 * (first - centre) + count <= -size) first += size;
  return {first, static_cast<std::size_t>(count)};
}

// Takes out what lies beyond the aperture.
void keep(AzimuthColumns& columns, const Support& support, const core::Fft& fft, const core::WorkControl& control) {
  const auto size = static_cast<long>(columns.size());
  if (support.count == columns.size()) return;
  core::parallel_ranges(columns.count(), grain, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = columns.column(i);
      fft.forward(column);
      for (long k = 0; k < size; ++k) {
        const bool kept = wrapped(k - support.first, size) < support.count;
        column[static_cast<std::size_t>(k)] *= kept ? 1.0 / static_cast<double>(size) : 0.0;
      }
      fft.inverse(column);
    }
  });
}

std::size_t brightest(std::span<const std::complex<double>> column) {
  std::size_t top = 0;
  for (std::size_t i = 1; i < column.size(); ++i)
    if (std::norm(column[i]) > std::norm(column[top])) top = i;
  return top;
}

// Width about the middle within which the centred columns together stay above a tenth of their largest power.
std::size_t blur_width(const std::vector<double>& power) {
  const std::size_t size = power.size();
  double top = 0.0;
  for (const double p : power) top = std::max(top, p);
  std::size_t width = 1;
  for (std::size_t k = 0; k < size; ++k)
    if (power[k] > 0.1 * top) width = std::max(width, 2 * std::min(k, size - k) + 1);
  return width;
}

// Takes the straight line that fits best out of evenly spaced values.
void remove_line(std::span<double> values) {
  const auto count = static_cast<double>(values.size());
  if (values.empty()) return;
  double mean = 0.0, moment = 0.0, spread = 0.0;
  for (const double v : values) mean += v / count;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = static_cast<double>(i) - 0.5 * (count - 1.0);
    moment += x * (values[i] - mean);
    spread += x * x;
  }
  const double slope = spread > 0.0 ? moment / spread : 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= mean + slope * (static_cast<double>(i) - 0.5 * (count - 1.0));
}

// The gradients' integral over the support, without its straight line.
std::vector<double> integral(const std::vector<std::complex<double>>& products, const Support& support) {
  const auto size = static_cast<long>(products.size());
  std::vector<double> phase(support.count);
  for (std::size_t i = 1; i < support.count; ++i) {
    const long k = support.first + static_cast<long>(i);
    phase[i] = phase[i - 1] + std::arg(products[wrapped(k, size)]);
  }
  remove_line(phase);
  return phase;
}

double root_mean_square(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// Turns every frequency of every column by `phase_rad(column, frequency)`; frequencies from -size/2 on.
void turn_spectra(AzimuthColumns& columns, const core::WorkControl& control,
                  const std::function<double(std::size_t, long)>& phase_rad) {
  CORE_EXPECT(phase_rad);
  const std::size_t size = columns.size();
  const core::Fft fft(size);
  const auto half = static_cast<long>(size / 2);
  core::parallel_ranges(columns.count(), grain, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto column = columns.column(i);
      fft.forward(column);
      for (long k = -half; k < static_cast<long>(size) - half; ++k)
        column[static_cast<std::size_t>(k < 0 ? k + static_cast<long>(size) : k)] *=
            std::polar(1.0 / static_cast<double>(size), phase_rad(i, k));
      fft.inverse(column);
    }
  });
}

// Phase gradient autofocus of columns; signal/sar/autofocus.hpp says how.
// @param[in,out] columns  corrected, and without what lies beyond the aperture
GradientResult phase_gradient(AzimuthColumns& columns, const SpectrumBand& band, const AutofocusOptions& options,
                              const core::WorkControl& control) {
  CORE_EXPECT(columns.count() > 0);
  CORE_EXPECT(columns.size() > 0);
  CORE_EXPECT(band.width >= 0.0);
  GradientResult result;
  const std::size_t size = columns.size();
  if (columns.count() == 0) return result;
  const core::Fft fft(size);
  const auto power = sum_over_columns<double>(columns, control, [&](std::size_t i, auto& sum, auto& scratch) {
    std::ranges::copy(columns.column(i), scratch.begin());
    fft.forward(scratch);
    for (std::size_t k = 0; k < size; ++k) sum[k] += std::norm(scratch[k]);
  });
  for (const double p : power) result.energy += p / static_cast<double>(size);
  const Support support = support_of(power, band, options.support_share);
  if (support.count < 3) return result;
  keep(columns, support, fft, control);
  result.first_frequency = support.first;
  result.phase_rad.resize(support.count);
  for (std::size_t i = 0; i < support.count; ++i)
    result.amplitude.push_back(
        std::sqrt(power[wrapped(support.first + static_cast<long>(i), static_cast<long>(size))]));

  std::size_t window = size;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    std::vector<std::size_t> tops(columns.count());
    const auto centred = sum_over_columns<double>(columns, control, [&](std::size_t i, auto& sum, auto& /*scratch*/) {
      const auto column = columns.column(i);
      tops[i] = brightest(column);
      for (std::size_t k = 0; k < size; ++k) sum[k] += std::norm(column[(k + tops[i]) % size]);
    });
    // Twice as wide as the blur to begin with, then narrower from round to round: what lies beyond is other points,
    // whose echoes would be taken for fast changes of phase that no later, narrower round could see.
    const std::size_t least = std::min(options.min_window, size);
    window = std::max(round == 0 ? std::min(2 * blur_width(centred), size) : 6 * window / 10, least);
    const auto products =
        sum_over_columns<std::complex<double>>(columns, control, [&](std::size_t i, auto& sum, auto& scratch) {
          const auto column = columns.column(i);
          for (std::size_t k = 0; k < size; ++k)
            scratch[k] = 2 * std::min(k, size - k) <= window ? column[(k + tops[i]) % size] : 0.0;
          fft.forward(scratch);
          for (std::size_t k = 0; k < size; ++k) sum[k] += scratch[k] * std::conj(scratch[(k + size - 1) % size]);
        });
    const std::vector<double> phase = integral(products, support);
    turn_spectra(columns, control, [&](std::size_t, long frequency) {
      const std::size_t at = wrapped(frequency - support.first, static_cast<long>(size));
      return at < support.count ? -phase[at] : 0.0;
    });
    for (std::size_t i = 0; i < phase.size(); ++i) result.phase_rad[i] += phase[i];
    result.round_rad.push_back(root_mean_square(phase));
    if (window == least && result.round_rad.back() < options.enough_rad) break;
  }
  return result;
}

AzimuthColumns columns_of(const FocusedImage& image) {
  AzimuthColumns columns(image.range.count, image.azimuth.count);
  for (std::size_t row = 0; row < image.azimuth.count; ++row)
    for (std::size_t column = 0; column < image.range.count; ++column)
      columns.column(column)[row] = std::complex<double>(image.values[row * image.range.count + column]);
  return columns;
}

void expect_sound(const FocusedImage& image) {
  core::expect(image.values.size() == image.azimuth.count * image.range.count,
               "autofocus: the number of values is not that of the axes");
  core::expect(image.azimuth.step_m != 0.0, "autofocus: the rows are not apart");
}

// Pieces of half overlap whose weights, squared sines, add up to 1 but for the first and the last half piece, which
// are held at 1.
struct Piece {
  long first = 0;
  double middle_m = 0.0;
};

double piece_weight(long offset, long length, bool is_first, bool is_last) {
  if ((is_first && offset < length / 2) || (is_last && offset >= length / 2)) return 1.0;
  const double sine = std::sin(core::pi * (static_cast<double>(offset) + 0.5) / static_cast<double>(length));
  return sine * sine;
}

// Where along the track the frequencies of an image's pieces were received.
class Sight {
 public:
  Sight(const FocusedImage& image, std::size_t size)
      : sine_per_step_(radar::range_of_cycle(image.carrier_hz, image.light_speed_mps) /
                       (image.azimuth.step_m * static_cast<double>(size))),
        centre_(image.azimuth.spectrum_centre_per_m * image.azimuth.step_m * static_cast<double>(size)) {}

  /// Of the image's spectrum, in steps of 1/size.
  [[nodiscard]] double centre() const { return centre_; }
  /// How far behind a point at this range the antenna received this frequency of it: R tan a.
  [[nodiscard]] double behind_m(double frequency, double range_m) const {
    constexpr double steepest = 0.999;  // as far as focusing goes
    const double sine = std::clamp(frequency * sine_per_step_, -steepest, steepest);
    return range_m * sine / std::sqrt(1.0 - sine * sine);
  }
  /// The inverse.
  [[nodiscard]] double frequency(double behind_m, double range_m) const {
    return behind_m / std::hypot(behind_m, range_m) / sine_per_step_;
  }

 private:
  double sine_per_step_;
  double centre_;
};

// An image of which each column is displaced, so that rows follow the line of sight of the beam's middle.
class SkewedImage {
 public:
  SkewedImage(const FocusedImage& image, const Sight& sight) : image_(image) {
    const double middle_m = middle_range_m();
    for (std::size_t column = 0; column < image.range.count; ++column) {
      const double farther_m = image.range.at(static_cast<double>(column)) - middle_m;
      offsets_.push_back(std::lround(sight.behind_m(sight.centre(), farther_m) / image.azimuth.step_m));
    }
  }

  [[nodiscard]] double middle_range_m() const { return image_.range.at(static_cast<double>(image_.range.count / 2)); }
  /// Of a column, in rows.
  [[nodiscard]] long offset(std::size_t column) const { return offsets_[column]; }
  /// Of half overlap.
  [[nodiscard]] std::vector<Piece> pieces(long length) const {
    std::vector<Piece> pieces;
    const auto [least, most] = std::ranges::minmax(offsets_);
    const long end = static_cast<long>(image_.azimuth.count) - least;
    for (long first = -most;; first += length / 2) {
      pieces.push_back({first, image_.azimuth.at(static_cast<double>(first) + 0.5 * static_cast<double>(length - 1))});
      if (first + length >= end) return pieces;
    }
  }
  [[nodiscard]] AzimuthColumns cut_out(const Piece& piece, long length, bool is_first, bool is_last,
                                       std::size_t size) const {
    AzimuthColumns columns(image_.range.count, size);
    for (std::size_t column = 0; column < image_.range.count; ++column)
      for (long i = 0; i < length; ++i) {
        const long row = piece.first + i + offset(column);
        if (row < 0 || row >= static_cast<long>(image_.azimuth.count)) continue;
        columns.column(column)[static_cast<std::size_t>(i)] =
            piece_weight(i, length, is_first, is_last) *
            std::complex<double>(image_.values[static_cast<std::size_t>(row) * image_.range.count + column]);
      }
    return columns;
  }

 private:
  const FocusedImage& image_;
  std::vector<long> offsets_;
};

// Evenly spaced places along the track.
struct AlongTrack {
  double first_m = 0.0;
  double step_m = 1.0;
  std::size_t count = 0;
};

// What one piece says about the phase along the track, but for a straight line: cells first, first + 1 ...
struct PiecePhase {
  std::size_t first = 0;
  std::vector<double> phase_rad;
  double weight = 0.0;
};

// Phase along the track as the mean of all pieces, each with a straight line added that makes it agree with the others.
class JoinedPhase {
 public:
  explicit JoinedPhase(std::size_t cells) : sum_(cells), weight_(cells) {}

  /// Adds a piece with the line that fits it best to what is there.
  void add(PiecePhase& piece) {
    fit(piece);
    change(piece, 1.0);
  }
  /// Fits a piece anew to the others.
  void refit(PiecePhase& piece) {
    change(piece, -1.0);
    add(piece);
  }
  /// What the means weigh.
  [[nodiscard]] const std::vector<double>& weights() const { return weight_; }
  /// The means; held or drawn straight where no piece reaches.
  [[nodiscard]] std::vector<double> mean() const {
    std::vector<double> phase(sum_.size());
    std::size_t known = 0;
    bool any = false;
    for (std::size_t i = 0; i < phase.size(); ++i) {
      if (weight_[i] <= 0.0) continue;
      phase[i] = sum_[i] / weight_[i];
      for (std::size_t k = any ? known + 1 : 0; k < i; ++k)
        phase[k] = !any ? phase[i]
                        : phase[known] + (phase[i] - phase[known]) * static_cast<double>(k - known) /
                                             static_cast<double>(i - known);
      known = i;
      any = true;
    }
    for (std::size_t k = known + 1; k < phase.size(); ++k) phase[k] = phase[known];
    return phase;
  }

 private:
  void fit(PiecePhase& piece) const {
    double n = 0.0, x1 = 0.0, x2 = 0.0, y1 = 0.0, xy = 0.0;
    const auto size = static_cast<double>(piece.phase_rad.size());
    for (std::size_t i = 0; i < piece.phase_rad.size(); ++i) {
      const double w = weight_[piece.first + i];
      if (w <= 0.0) continue;
      const double x = static_cast<double>(i) / size;
      const double y = sum_[piece.first + i] / w - piece.phase_rad[i];
      n += w;
      x1 += w * x;
      x2 += w * x * x;
      y1 += w * y;
      xy += w * x * y;
    }
    const double spread = n * x2 - x1 * x1;
    if (!(spread > 1e-9 * n * n)) return;
    const double slope = (n * xy - x1 * y1) / spread;
    const double constant = (y1 - slope * x1) / n;
    for (std::size_t i = 0; i < piece.phase_rad.size(); ++i)
      piece.phase_rad[i] += constant + slope * static_cast<double>(i) / size;
  }
  void change(const PiecePhase& piece, double sign) {
    for (std::size_t i = 0; i < piece.phase_rad.size(); ++i) {
      sum_[piece.first + i] += sign * piece.weight * piece.phase_rad[i];
      weight_[piece.first + i] += sign * piece.weight;
      // What is left after the last piece was taken away is rounding.
      if (weight_[piece.first + i] < 1e-9 * piece.weight) sum_[piece.first + i] = weight_[piece.first + i] = 0.0;
    }
  }

  std::vector<double> sum_, weight_;
};

double interpolated(const std::vector<double>& y, double x) {
  const double held = std::clamp(x, 0.0, static_cast<double>(y.size() - 1));
  const auto left = std::min(static_cast<std::size_t>(held), y.size() - 2);
  const double share = held - static_cast<double>(left);
  return y[left] + share * (y[left + 1] - y[left]);
}

// The phases of one piece on the cells along the track. The places at mid-range stand for all columns.
PiecePhase along_track(const GradientResult& found, double middle_m, double range_m, const Sight& sight,
                       const AlongTrack& track) {
  PiecePhase piece;
  if (found.phase_rad.size() < 3) return piece;
  const auto begin = static_cast<double>(found.first_frequency);
  const auto along_m = [&](double frequency) { return middle_m - sight.behind_m(frequency, range_m); };
  const auto [low_m, high_m] =
      std::minmax({along_m(begin), along_m(begin + static_cast<double>(found.phase_rad.size()) - 1.0)});
  const double first = std::max(std::ceil((low_m - track.first_m) / track.step_m), 0.0);
  const double last =
      std::min(std::floor((high_m - track.first_m) / track.step_m), static_cast<double>(track.count) - 1.0);
  piece.first = static_cast<std::size_t>(first);
  piece.weight = found.energy;
  for (double cell = first; cell <= last; ++cell) {
    const double s_m = track.first_m + cell * track.step_m;
    piece.phase_rad.push_back(interpolated(found.phase_rad, sight.frequency(middle_m - s_m, range_m) - begin));
  }
  return piece;
}

// From where the first piece's last frequency may have been received to where the last piece's first one may.
AlongTrack track_of(const std::vector<Piece>& pieces, double range_m, const Sight& sight, std::size_t size) {
  const auto whole = static_cast<double>(size);
  const auto [min_m, max_m] =
      std::minmax({sight.behind_m(sight.centre() - whole, range_m), sight.behind_m(sight.centre() + whole, range_m)});
  const auto [low_m, high_m] = std::minmax({pieces.front().middle_m, pieces.back().middle_m});
  AlongTrack track;
  track.step_m = std::abs(sight.behind_m(1.0, range_m));
  track.first_m = low_m - max_m;
  track.count = static_cast<std::size_t>((high_m - min_m - track.first_m) / track.step_m) + 2;
  return track;
}

// A strip, piece by piece: first the phase of all, then the image without it.
class StripWork {
 public:
  StripWork(const FocusedImage& image, long length, const AutofocusOptions& options, const core::WorkControl& control)
      : image_(image),
        options_(options),
        control_(control),
        length_(length),
        size_(core::good_fft_size(2 * static_cast<std::size_t>(length))),
        sight_(image, size_),
        skewed_(image, sight_),
        pieces_(skewed_.pieces(length)),
        track_(track_of(pieces_, skewed_.middle_range_m(), sight_, size_)) {}

  /// The phase along the track.
  void find(StripmapAutofocusResult& result) {
    const SpectrumBand band{sight_.centre(),
                            options_.band_per_m * std::abs(image_.azimuth.step_m) * static_cast<double>(size_)};
    JoinedPhase joined(track_.count);
    std::vector<PiecePhase> phases;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      AzimuthColumns columns = cut_out(i);
      found_.push_back(phase_gradient(columns, band, options_, control_));
      phases.push_back(along_track(found_.back(), pieces_[i].middle_m, skewed_.middle_range_m(), sight_, track_));
      joined.add(phases.back());
    }
    for (int sweep = 0; sweep < 10; ++sweep)
      for (PiecePhase& phase : phases) joined.refit(phase);
    result.phase_rad = joined.mean();
    for (std::size_t i = 0; i < result.phase_rad.size(); ++i)
      result.along_m.push_back(track_.first_m + static_cast<double>(i) * track_.step_m);
    const StraightLine line = best_line(result.along_m, result.phase_rad, joined.weights());
    for (std::size_t i = 0; i < result.phase_rad.size(); ++i) result.phase_rad[i] -= line.at(result.along_m[i]);
  }

  void take_out(StripmapAutofocusResult& result) {
    std::ranges::fill(result.image.values, 0.0F);
    double energy = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Bend bend = bend_of(i, result);
      energy += found_[i].energy;
      squares += found_[i].energy * bend.rms_rad * bend.rms_rad;
      take_out(i, bend.line, result);
    }
    if (energy > 0.0) result.rms_rad = std::sqrt(squares / energy);
  }

 private:
  // The line that one piece keeps, over the places along the track, and what is taken out of its spectrum.
  struct Bend {
    StraightLine line;
    double rms_rad = 0.0;
  };

  [[nodiscard]] AzimuthColumns cut_out(std::size_t i) const {
    return skewed_.cut_out(pieces_[i], length_, i == 0, i + 1 == pieces_.size(), size_);
  }

  [[nodiscard]] double phase_at(const StripmapAutofocusResult& result, double along_m) const {
    return interpolated(result.phase_rad, (along_m - track_.first_m) / track_.step_m);
  }

  // By the amplitudes of the spectrum: the phase that is left then moves no peak.
  [[nodiscard]] Bend bend_of(std::size_t i, const StripmapAutofocusResult& result) const {
    const GradientResult& found = found_[i];
    std::vector<double> along_m, phase_rad;
    for (std::size_t k = 0; k < found.amplitude.size(); ++k) {
      const auto frequency = static_cast<double>(found.first_frequency + static_cast<long>(k));
      along_m.push_back(pieces_[i].middle_m - sight_.behind_m(frequency, skewed_.middle_range_m()));
      phase_rad.push_back(phase_at(result, along_m.back()));
    }
    Bend bend{best_line(along_m, phase_rad, found.amplitude)};
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < along_m.size(); ++k) {
      const double rest_rad = phase_rad[k] - bend.line.at(along_m[k]);
      sum += found.amplitude[k];
      squares += found.amplitude[k] * rest_rad * rest_rad;
    }
    if (sum > 0.0) bend.rms_rad = std::sqrt(squares / sum);
    return bend;
  }

  void take_out(std::size_t i, const StraightLine& line, StripmapAutofocusResult& result) const {
    const GradientResult& found = found_[i];
    // Of the aperture: the others count from there.
    const long middle = found.phase_rad.empty() ? std::lround(sight_.centre())
                                                : found.first_frequency + static_cast<long>(found.phase_rad.size() / 2);
    AzimuthColumns columns = cut_out(i);
    turn_spectra(columns, control_, [&](std::size_t column, long frequency) {
      const double turns = std::round(static_cast<double>(frequency - middle) / static_cast<double>(size_));
      const double unfolded = static_cast<double>(frequency) - static_cast<double>(size_) * turns;
      const double along_m = pieces_[i].middle_m + static_cast<double>(skewed_.offset(column)) * image_.azimuth.step_m -
                             sight_.behind_m(unfolded, image_.range.at(static_cast<double>(column)));
      return line.at(along_m) - phase_at(result, along_m);
    });
    add(i, columns, result);
  }

  // What the correction moved beyond the ends of the piece stands in the zeros behind it, or before it at the end.
  void add(std::size_t i, const AzimuthColumns& columns, StripmapAutofocusResult& result) const {
    const auto size = static_cast<long>(size_);
    for (long k = -size / 4; k < length_ + size / 4; ++k) {
      const long at = k < 0 ? k + size : k;
      if (at >= size) continue;
      for (std::size_t column = 0; column < image_.range.count; ++column) {
        const long row = pieces_[i].first + k + skewed_.offset(column);
        if (row < 0 || row >= static_cast<long>(image_.azimuth.count)) continue;
        result.image.values[static_cast<std::size_t>(row) * image_.range.count + column] +=
            std::complex<float>(columns.column(column)[static_cast<std::size_t>(at)]);
      }
    }
  }

  const FocusedImage& image_;
  const AutofocusOptions& options_;
  const core::WorkControl& control_;
  long length_;
  std::size_t size_;
  Sight sight_;
  SkewedImage skewed_;
  std::vector<Piece> pieces_;
  AlongTrack track_;
  std::vector<GradientResult> found_;
};

}  // namespace

double image_entropy(const FocusedImage& image) {
  double energy = 0.0;
  for (const auto& value : image.values) energy += std::norm(std::complex<double>(value));
  if (energy <= 0.0) return 0.0;
  double entropy = 0.0;
  for (const auto& value : image.values) {
    const double share = std::norm(std::complex<double>(value)) / energy;
    if (share > 0.0) entropy -= share * std::log(share);
  }
  return entropy;
}

AutofocusResult autofocus(const FocusedImage& image, const AutofocusOptions& options,
                          const core::WorkControl& control) {
  CORE_EXPECT(options.support_share >= 0.0 && options.support_share < 1.0);
  CORE_EXPECT(options.band_per_m >= 0.0);
  CORE_EXPECT(options.enough_rad >= 0.0);
  expect_sound(image);
  AutofocusResult result;
  result.image = image;
  if (image.values.empty()) return result;
  const Sight sight(image, image.azimuth.count);
  const double spacing = 1.0 / (image.azimuth.step_m * static_cast<double>(image.azimuth.count));
  AzimuthColumns columns = columns_of(image);
  const GradientResult found =
      phase_gradient(columns, {sight.centre(), options.band_per_m / std::abs(spacing)}, options, control);
  columns = columns_of(image);
  const auto size = static_cast<long>(image.azimuth.count);
  turn_spectra(columns, control, [&](std::size_t, long frequency) {
    const auto at = static_cast<std::size_t>(((frequency - found.first_frequency) % size + size) % size);
    return at < found.phase_rad.size() ? -found.phase_rad[at] : 0.0;
  });
  for (std::size_t row = 0; row < image.azimuth.count; ++row)
    for (std::size_t column = 0; column < image.range.count; ++column)
      result.image.values[row * image.range.count + column] = std::complex<float>(columns.column(column)[row]);
  result.round_rad = found.round_rad;
  result.phase_rad = found.phase_rad;
  for (std::size_t i = 0; i < found.phase_rad.size(); ++i)
    result.cycles_per_m.push_back(spacing * static_cast<double>(found.first_frequency + static_cast<long>(i)));
  if (spacing < 0.0) {
    std::ranges::reverse(result.phase_rad);
    std::ranges::reverse(result.cycles_per_m);
  }
  return result;
}

StripmapAutofocusResult autofocus_strip(const FocusedImage& image, double piece_m, const AutofocusOptions& options,
                                        const core::WorkControl& control) {
  CORE_EXPECT(piece_m > 0.0);
  CORE_EXPECT(options.support_share >= 0.0 && options.support_share < 1.0);
  CORE_EXPECT(options.band_per_m >= 0.0);
  expect_sound(image);
  core::expect(image.frame.plane == ImagePlane::slant_range, "autofocus: a strip must be an image of slant range");
  const long length = 2 * static_cast<long>(0.5 * piece_m / std::abs(image.azimuth.step_m));
  core::expect(length >= 4, "autofocus: a piece of the strip has fewer than four pixels");
  StripmapAutofocusResult result;
  result.image = image;
  if (image.values.empty()) return result;
  StripWork work(image, length, options, control);
  work.find(result);
  work.take_out(result);
  return result;
}

}  // namespace sarsim::signal
