#include "process/autofocus.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "base/constants.hpp"
#include "math/fft.hpp"
#include "process/phase_gradient.hpp"

namespace sarsim {

namespace {

void expect(bool right, const char* what) {
  if (!right) throw std::invalid_argument(what);
}

AzimuthColumns columns_of(const FocusedImage& image) {
  AzimuthColumns columns(image.range.count, image.azimuth.count);
  for (std::size_t row = 0; row < image.azimuth.count; ++row)
    for (std::size_t column = 0; column < image.range.count; ++column)
      columns.column(column)[row] = std::complex<double>(image.values[row * image.range.count + column]);
  return columns;
}

void expect_sound(const FocusedImage& image) {
  expect(image.values.size() == image.azimuth.count * image.range.count,
         "autofocus: the number of values is not that of the axes");
  expect(image.azimuth.step_m != 0.0, "autofocus: the rows are not apart");
}

// Pieces of half overlap whose weights, squared sines, add up to 1 but for the first and the last half piece, which
// are held at 1.
struct Piece {
  long first = 0;
  double middle_m = 0.0;
};

double piece_weight(long offset, long length, bool is_first, bool is_last) {
  if ((is_first && offset < length / 2) || (is_last && offset >= length / 2)) return 1.0;
  const double sine = std::sin(pi * (static_cast<double>(offset) + 0.5) / static_cast<double>(length));
  return sine * sine;
}

std::vector<Piece> pieces_of(const FocusedImage& image, long length) {
  std::vector<Piece> pieces;
  const auto rows = static_cast<long>(image.azimuth.count);
  for (long first = 0;; first += length / 2) {
    pieces.push_back({first, image.azimuth.at(static_cast<double>(first) + 0.5 * static_cast<double>(length - 1))});
    if (first + length >= rows) return pieces;
  }
}

AzimuthColumns cut_out(const FocusedImage& image, const Piece& piece, long length, bool is_first, bool is_last,
                       std::size_t size) {
  AzimuthColumns columns(image.range.count, size);
  for (long i = 0; i < length; ++i) {
    const long row = piece.first + i;
    if (row >= static_cast<long>(image.azimuth.count)) break;
    const double weight = piece_weight(i, length, is_first, is_last);
    for (std::size_t column = 0; column < image.range.count; ++column)
      columns.column(column)[static_cast<std::size_t>(i)] =
          weight * std::complex<double>(image.values[static_cast<std::size_t>(row) * image.range.count + column]);
  }
  return columns;
}

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
PiecePhase along_track(const GradientResult& found, double middle_m, double reach_m, const AlongTrack& track) {
  PiecePhase piece;
  const auto count = static_cast<double>(found.phase_rad.size());
  if (found.phase_rad.size() < 3) return piece;
  const auto along_m = [&](double i) { return middle_m - (static_cast<double>(found.first_frequency) + i) * reach_m; };
  const double low_m = std::min(along_m(0.0), along_m(count - 1.0));
  const double high_m = std::max(along_m(0.0), along_m(count - 1.0));
  const double first = std::max(std::ceil((low_m - track.first_m) / track.step_m), 0.0);
  const double last =
      std::min(std::floor((high_m - track.first_m) / track.step_m), static_cast<double>(track.count) - 1.0);
  piece.first = static_cast<std::size_t>(first);
  piece.weight = found.energy;
  for (double cell = first; cell <= last; ++cell) {
    const double s_m = track.first_m + cell * track.step_m;
    piece.phase_rad.push_back(interpolated(found.phase_rad, (along_m(0.0) - s_m) / reach_m));
  }
  return piece;
}

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

AutofocusResult autofocus(const FocusedImage& image, const AutofocusOptions& options, const WorkControl& control) {
  expect_sound(image);
  AutofocusResult result;
  result.image = image;
  if (image.values.empty()) return result;
  AzimuthColumns columns = columns_of(image);
  const GradientResult found = phase_gradient(columns, options, control);
  for (std::size_t row = 0; row < image.azimuth.count; ++row)
    for (std::size_t column = 0; column < image.range.count; ++column)
      result.image.values[row * image.range.count + column] = std::complex<float>(columns.column(column)[row]);
  result.round_rad = found.round_rad;
  const double spacing = 1.0 / (image.azimuth.step_m * static_cast<double>(image.azimuth.count));
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
                                        const WorkControl& control) {
  expect_sound(image);
  expect(image.frame.plane == ImagePlane::slant_range, "autofocus: a strip must be an image of slant range");
  const long length = 2 * static_cast<long>(0.5 * piece_m / std::abs(image.azimuth.step_m));
  expect(length >= 4, "autofocus: a piece of the strip has fewer than four pixels");
  StripmapAutofocusResult result;
  result.image = image;
  if (image.values.empty()) return result;

  const std::vector<Piece> pieces = pieces_of(image, length);
  const std::size_t size = good_fft_size(2 * static_cast<std::size_t>(length));
  const double wavelength_m = image.light_speed_mps / image.carrier_hz;
  const double frequency_step = 1.0 / (image.azimuth.step_m * static_cast<double>(size));
  const auto reach_of = [&](std::size_t column) {  // metres along the track for each step of frequency
    return 0.5 * wavelength_m * image.range.at(static_cast<double>(column)) * frequency_step;
  };
  const double middle_reach_m = reach_of(image.range.count / 2);
  const auto is_last = [&](std::size_t i) { return i + 1 == pieces.size(); };

  const double half_band_m = std::abs(middle_reach_m) * static_cast<double>(size);
  AlongTrack track;
  track.step_m = std::abs(middle_reach_m);
  track.first_m = std::min(pieces.front().middle_m, pieces.back().middle_m) - half_band_m;
  const double span_m = std::abs(pieces.back().middle_m - pieces.front().middle_m) + 2.0 * half_band_m;
  track.count = static_cast<std::size_t>(span_m / track.step_m) + 2;
  JoinedPhase joined(track.count);
  std::vector<PiecePhase> phases;
  std::vector<long> middle_frequency;  // of the aperture: the others count from there
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    AzimuthColumns columns = cut_out(image, pieces[i], length, i == 0, is_last(i), size);
    const GradientResult found = phase_gradient(columns, options, control);
    middle_frequency.push_back(found.first_frequency + static_cast<long>(found.phase_rad.size() / 2));
    phases.push_back(along_track(found, pieces[i].middle_m, middle_reach_m, track));
    joined.add(phases.back());
  }
  for (int sweep = 0; sweep < 10; ++sweep)
    for (PiecePhase& phase : phases) joined.refit(phase);
  result.phase_rad = joined.mean();
  remove_line(result.phase_rad);
  for (std::size_t i = 0; i < result.phase_rad.size(); ++i)
    result.along_m.push_back(track.first_m + static_cast<double>(i) * track.step_m);

  std::ranges::fill(result.image.values, 0.0F);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    AzimuthColumns columns = cut_out(image, pieces[i], length, i == 0, is_last(i), size);
    turn_spectra(columns, control, [&](std::size_t column, long frequency) {
      const auto from_middle = static_cast<double>(frequency - middle_frequency[i]);
      const double unfolded = static_cast<double>(frequency) -
                              static_cast<double>(size) * std::round(from_middle / static_cast<double>(size));
      const double along_m = pieces[i].middle_m - unfolded * reach_of(column);
      return -interpolated(result.phase_rad, (along_m - track.first_m) / track.step_m);
    });
    // What the correction moved beyond the ends of the piece stands in the zeros behind it, or before it at the end.
    for (long k = -static_cast<long>(size) / 4; k < length + static_cast<long>(size) / 4; ++k) {
      const long row = pieces[i].first + k;
      if (row < 0 || row >= static_cast<long>(image.azimuth.count)) continue;
      const auto at = static_cast<std::size_t>(k < 0 ? k + static_cast<long>(size) : k);
      if (at >= size) continue;
      for (std::size_t column = 0; column < image.range.count; ++column)
        result.image.values[static_cast<std::size_t>(row) * image.range.count + column] +=
            std::complex<float>(columns.column(column)[at]);
    }
  }
  return result;
}

}  // namespace sarsim
