#include "radar/echo/slepian_row.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/echo/complex_rows.hpp"
#include "radar/echo/doppler_terms.hpp"
#include "radar/echo/spectral_settings.hpp"

namespace sarsim::radar {

namespace {

constexpr std::size_t functions = ProlateBasis::count;
constexpr std::size_t kept_bytes = 16'000'000;   // of factors, per thread
constexpr std::size_t max_kept = 64;             // motions; those that cannot be made count too, and hold little
constexpr std::size_t pieces_of_degree_2 = 128;  // of polynomials, which stay in the nearest cache
constexpr std::size_t weights_bytes = pieces_of_degree_2 * 3 * functions * sizeof(float);
constexpr std::size_t max_points = 32'768;         // of a transform: sums and factors of more would take much memory
constexpr std::size_t max_points_of_two = 16'384;  // that a transform to another array pays for: both are in the cache
constexpr double bend_shares = SpectralSettings::motion_shares;  // of the error, for second derivatives of polynomials
constexpr double max_angle_rad = 0.25;                           // that a series in SIMD turns strengths by
constexpr double max_width = 3.0;  // c of the functions: eight of them are enough up to about 2

double late_rate(double doppler) { return doppler / (1.0 - doppler); }

// How far a span of D takes the functions.
struct Reach {
  double width;  // c of the functions
  double rad;    // by which the change of the sweep turns the ends of the pulse

  Reach(const EchoPulse& pulse, double interval_s, double carrier_hz, double half_doppler) {
    const double samples = pulse.pulse.width_s / interval_s;
    const double sweep = std::abs(pulse.pulse.sweep_rate_hz_per_s()) * interval_s * interval_s;
    const double shift = std::abs(carrier_hz) * interval_s * half_doppler;
    width = core::pi * samples * (0.5 * sweep + shift);
    rad = 0.5 * core::pi * sweep * half_doppler * samples * samples;
  }

  // Whether the second derivatives of polynomials of degree 2 keep their shares: what a piece leaves of c rad x^3, the
  // place in the pulse x being in [-1, 1], root mean square of both.
  [[nodiscard]] bool suits_degree_2(double share) const {
    return width * rad / (std::sqrt(21.0) * static_cast<double>(pieces_of_degree_2)) <= bend_shares * share;
  }
};

}  // namespace

// The functions of the bins and what the samples of a pulse have of each: sample s of an echo is
// sum over k of f_k(y) times part(k, s), turned by t.
class SlepianRow::Fit {
 public:
  Fit(const SlepianSums& bins, const PulseBody& body, double interval_s)
      : bins_(bins),
        first_(bins.begin + 0.5 + body.from_middle_s(0.0) / interval_s),
        half_(0.5 * static_cast<double>(bins.main_samples())),
        function_(2.0 * core::pi * bins.max_z * half_) {
    // Fejer's rule: exact for all that sums of the functions are.
    for (std::size_t i = 0; i < nodes; ++i) {
      const double angle = core::pi * (static_cast<double>(i) + 0.5) / nodes;
      double sum = 1.0;
      for (std::size_t m = 1; m <= nodes / 2; ++m) {
        const auto twice = static_cast<double>(2 * m);
        sum -= 2.0 * std::cos(twice * angle) / (twice * twice - 1.0);
      }
      y_[i] = std::cos(angle);
      for (std::size_t k = 0; k < functions; ++k) weight_[k][i] = 2.0 / nodes * sum * function_.value(k, y_[i]);
    }
  }

  // Of sample n after n0.
  [[nodiscard]] Parts parts(double n) const {
    const double s = first_ + n;
    Parts even_and_odd{};
    // Each node and its mirror image, whose weight is the same but for the sign of odd functions.
    for (std::size_t i = 0; i < nodes / 2; ++i) {
      const double angle = 2.0 * core::pi * s * bins_.max_z * y_[i];
      const double c = 2.0 * std::cos(angle);
      const double d = 2.0 * std::sin(angle);
      for (std::size_t k = 0; k < functions; k += 2) {
        even_and_odd[k] += weight_[k][i] * c;
        even_and_odd[k + 1] += std::complex<double>(0.0, weight_[k + 1][i] * d);
      }
    }
    const double turns = (0.5 * bins_.sweep * s - bins_.carrier * bins_.middle) * s;
    const auto common = std::polar(1.0, 2.0 * core::pi * (turns - std::round(turns)));
    for (std::complex<double>& part : even_and_odd) part *= common;
    return even_and_odd;
  }

  // Of all samples of the main run.
  [[nodiscard]] std::vector<Parts> all_parts() const {
    std::vector<Parts> all(bins_.main_samples());
    for (std::size_t n = 0; n < all.size(); ++n) all[n] = parts(static_cast<double>(n));
    return all;
  }

  // What bends the functions: f'' + (2 pi max_z)^2 square f.
  [[nodiscard]] double bend(std::size_t k, double y) const {
    const double rad = 2.0 * core::pi * bins_.max_z;
    return function_.second_derivative(k, y) + rad * rad * bins_.square * function_.value(k, y);
  }
  // How much function k counts in an echo at most: by itself, or by what the largest change of the sweep makes of it.
  // That is much for tones without Doppler, whose functions span next to nothing.
  [[nodiscard]] double most(std::size_t k) const {
    double largest = 0.0;
    for (double y = 0.0; y <= 1.0; y += 0.125) largest = std::max(largest, std::abs(bend(k, y)));
    return std::max(1.0, bend_of(bins_.max_change) * largest);
  }
  [[nodiscard]] double value(std::size_t k, double y) const { return function_.value(k, y); }
  [[nodiscard]] double second_derivative(std::size_t k, double y) const { return function_.second_derivative(k, y); }
  // What a bend of a change of the sweep counts.
  [[nodiscard]] double bend_of(double change) const {
    return bins_.max_z > 0.0 ? change / (4.0 * core::pi * bins_.max_z * bins_.max_z) : 0.0;
  }

  // A sample of an echo that stands at p, by these functions.
  [[nodiscard]] std::complex<double> sample(const Parts& parts, double p, const PulseClock& clock) const {
    const double apart = clock.doppler - bins_.middle;
    const double change = (bins_.sweep_slope + bins_.sweep_square * apart) * apart +
                          bins_.bend_slope * (clock.dilation_rate - bins_.bend_middle);
    const double sweep = bins_.sweep + change;
    const double z = sweep * p - bins_.carrier * apart;
    const double turns = (0.5 * sweep * p - bins_.carrier * clock.doppler) * p + 0.5 * change * bins_.square;
    const double y = bins_.max_z > 0.0 ? z / bins_.max_z : 0.0;
    std::complex<double> sum;
    for (std::size_t k = 0; k < functions; ++k)
      sum += parts[k] * std::complex<double>(value(k, y), -bend_of(change) * bend(k, y));
    return sum * std::polar(1.0, 2.0 * core::pi * turns);
  }

 private:
  static constexpr std::size_t nodes = 32;
  const SlepianSums& bins_;
  double first_;  // s of the first sample
  double half_;
  ProlateBasis function_;
  std::array<double, nodes> y_{};
  std::array<std::array<double, nodes>, functions> weight_{};
};

bool SlepianRow::suits(const EchoPulse& pulse, const PulseBody& body) {
  const bool smooth = pulse.pulse.kind == Pulse::Kind::chirp || pulse.pulse.kind == Pulse::Kind::mono;
  return smooth && pulse.pulse.envelope == Pulse::Envelope::rectangular && !pulse.band_limited && body.has_body();
}

std::size_t SlepianRow::transforms_about(const EchoPulse& pulse, double interval_s, double carrier_hz,
                                         double half_doppler, double error) {
  const Reach reach(pulse, interval_s, carrier_hz, half_doppler);
  // What the square of the angle leaves, over pulse and speeds.
  if (0.029 * reach.rad * reach.rad > error) return functions + 1;
  return ProlateBasis::needed(reach.width, error);
}

// A tenth of the error, so that second derivatives of polynomials of degree 3 will do; and not beyond those of degree 2
// where the echoes are within. Halves are powers of two, so that spans of several widths share one.
DopplerSpan SlepianRow::shared_span(const EchoPulse& pulse, double interval_s, double carrier_hz,
                                    const DopplerSpan& span, double error) {
  if (span.half == 0.0) return span;
  const auto suits_degree_2 = [&](double half) {
    return Reach(pulse, interval_s, carrier_hz, half).suits_degree_2(error);
  };
  const bool is_low = suits_degree_2(span.half);
  for (double half = 8.0 * span.half; half > span.half; half *= 0.5) {
    if (is_low && !suits_degree_2(half)) continue;
    if (transforms_about(pulse, interval_s, carrier_hz, half, 0.1 * error) <= functions)
      return span_within(span.middle - span.half, span.middle + span.half, half).value_or(span);
  }
  return span;
}

// Echoes that take as long one by one as a point of the transforms, by measurement (docs/developer/performance.md).
bool SlepianRow::is_worth(double echoes, std::size_t transforms, std::size_t points, std::size_t doppler_terms) {
  if (points > max_points || transforms > functions) return false;
  const double least = doppler_terms > 1 ? 0.0 : 0.8;
  return echoes > least * static_cast<double>(points);
}

SlepianRow::SlepianRow(const EchoPulse& pulse, const PulseBody& body, const SampleGrid& grid, double share, double room,
                       const core::BasicFft<float>& row_fft)
    : pulse_(&pulse), body_(&body), grid_(grid), share_(share), room_(room), row_fft_(&row_fft) {
  CORE_EXPECT(share > 0.0);
  CORE_EXPECT(room >= 0.0);
  CORE_EXPECT(body.edges().size() == 2);
}

bool SlepianRow::prepare(const DenseMotion& motion) {
  const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) { return kept.motion.is_same(motion); });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
  } else {
    kept_.push_front(make(motion));
    limit_kept();
  }
  return kept_.front().usable;
}

bool SlepianRow::is_refused(const DenseMotion& motion) const {
  return std::ranges::any_of(kept_, [&](const Kept& kept) { return !kept.usable && kept.motion.is_same(motion); });
}

// The least recently used make room.
void SlepianRow::limit_kept() {
  std::size_t bytes = 0;
  std::size_t count = 0;
  for (const Kept& kept : kept_) {
    for (const Spectrum& factor : kept.factor) bytes += factor.size() * sizeof(std::complex<float>);
    if ((bytes > kept_bytes && count > 0) || count == max_kept) break;
    ++count;
  }
  kept_.resize(count);
}

void SlepianRow::take(const Strengths<float>& echoes) {
  const Kept& kept = kept_.front();
  CORE_EXPECT(kept.usable);
  if (!has_sums_) sums_.make_room(kept.bins);
  has_sums_ = true;
  add_to_bins(kept.bins, kept.weights, echoes, sums_);
}

void SlepianRow::forget() {
  if (has_sums_) sums_.clear();
  has_sums_ = false;
}

void SlepianRow::leave(std::span<std::complex<float>> spectrum, std::vector<LoneSample>& lone) {
  CORE_EXPECT(spectrum.size() == row_fft_->size());
  if (!has_sums_) return;
  has_sums_ = false;
  const Kept& kept = kept_.front();
  const auto period = static_cast<std::ptrdiff_t>(row_fft_->size());
  const auto first = static_cast<std::ptrdiff_t>(kept.bins.first_sample) % period;
  std::array<std::span<std::complex<float>>, functions> rows;
  for (std::size_t k = 0; k < functions; ++k) {
    row_[k].resize(row_fft_->size());
    rows[k] = row_[k];
  }
  leave_bins(kept.bins, kept.tails, sums_, static_cast<std::size_t>(first < 0 ? first + period : first), rows,
             grid_.count, lone);
  for (std::size_t k = 0; k < functions; ++k) {
    if (kept.factor[k].empty()) continue;
    add_products<float>(spectrum, transformed(row_[k]), kept.factor[k]);
  }
}

std::span<const std::complex<float>> SlepianRow::transformed(Spectrum& row) {
  if (row.size() > max_points_of_two) {
    row_fft_->forward(row);
    return row;
  }
  transform_.resize(row.size());
  row_fft_->forward(row, transform_);
  return transform_;
}

SlepianRow::Kept SlepianRow::make(const DenseMotion& motion) const {
  Kept kept;
  kept.motion = motion;
  kept.usable = make_bins(kept);
  if (!kept.usable) return kept;
  const Fit fit(kept.bins, *body_, grid_.interval_s);
  const std::vector<Parts> parts = fit.all_parts();
  kept.usable = is_exact(kept, fit, parts);
  if (!kept.usable) return kept;
  make_factors(kept, fit, parts);
  make_tails(kept, fit);
  kept.usable = make_weights(kept, fit, share_);
  return kept;
}

// False where motion moves the ends of pulses too far apart, or turns them too much.
bool SlepianRow::make_bins(Kept& kept) const {
  const DopplerSpan& span = kept.motion.span;
  SlepianSums& bins = kept.bins;
  bins.bends = kept.motion.bends != DopplerSpan{};
  bins.moves = bins.bends || span != DopplerSpan{};
  bins.middle = span.middle;
  bins.begin_hard = body_->first();
  bins.end_hard = body_->last();
  if (body_->is_stretched() && bins.moves) {
    bins.begin_late = body_->from_middle_s(bins.begin_hard) / grid_.interval_s;
    bins.end_late = body_->from_middle_s(bins.end_hard) / grid_.interval_s;
    bins.begin_bent = 0.5 * bins.begin_late * bins.begin_late * grid_.interval_s;
    bins.end_bent = 0.5 * bins.end_late * bins.end_late * grid_.interval_s;
  }
  bins.begin = bins.begin_hard + bins.begin_late * late_rate(span.middle);
  const double half = 1.01 * span.half;
  const double longer = bins.end_late - bins.begin_late;
  // By how much motion moves one end against the other.
  const double max_bend = std::abs(kept.motion.bends.middle) + 1.01 * kept.motion.bends.half;
  bins.apart = longer * half + (bins.begin_bent + bins.end_bent) * max_bend;
  // Ends are moved by polynomials of second degree.
  if (bins.apart > 0.25 || std::pow(half, 3) * std::max(std::abs(bins.begin_late), std::abs(bins.end_late)) > 1e-10)
    return false;
  double samples = bins.end_hard - bins.begin_hard + longer * late_rate(span.middle);
  if (std::abs(samples - std::round(samples)) < 1e-9) samples = std::round(samples);
  // The end is reached after ceil(samples - phi) samples, or as many as motion makes of that; at rest phi is below 1.
  bins.min_samples = std::ceil(samples - 1.0 - bins.apart);
  if (bins.apart == 0.0 && bins.min_samples == samples - 1.0) bins.min_samples = samples;
  bins.run_count = static_cast<std::size_t>(std::ceil(samples + bins.apart) - bins.min_samples) + 1;
  double longest = -1.0;
  for (std::size_t r = 0; r < bins.run_count; ++r) {
    const double most = samples - bins.min_samples - static_cast<double>(r) + 1.0;
    const double length = std::clamp(most, 0.0, 1.0) - std::clamp(most - 1.0, 0.0, 1.0);
    if (length > longest) bins.main_run = r;
    longest = std::max(longest, length);
  }
  // From the last echo that ends before the row to the first that begins behind it: others are taken for one of these.
  bins.first_sample = std::floor(bins.begin_hard - bins.end_hard - room_);
  bins.samples = static_cast<std::size_t>(static_cast<double>(grid_.count) - bins.first_sample + 1.0);

  const double sweep = pulse_->pulse.sweep_rate_hz_per_s() * grid_.interval_s * grid_.interval_s;
  const double rate = 1.0 - span.middle;
  bins.sweep = sweep * (body_->is_stretched() ? rate * rate : rate);
  bins.square = samples * samples / 12.0;
  const double place = 0.5 + std::abs(bins.begin_late) * half + bins.begin_bent * max_bend + 1e-6;
  if (bins.moves) {
    bins.carrier = kept.motion.carrier_hz * grid_.interval_s;
    bins.sweep_slope = sweep * (body_->is_stretched() ? -2.0 * rate : -1.0);
    bins.sweep_square = body_->is_stretched() ? sweep : 0.0;
    bins.bend_middle = kept.motion.bends.middle;
    bins.bend_slope = -bins.carrier * grid_.interval_s;
    bins.sweep += bins.bend_slope * bins.bend_middle;
    bins.max_change = half * (std::abs(bins.sweep_slope) + std::abs(bins.sweep_square) * half) +
                      1.01 * std::abs(bins.bend_slope) * kept.motion.bends.half;
    if (core::pi * bins.max_change * bins.square < 0.1 * share_) bins.max_change = 0.0;
  }
  bins.max_z = (std::abs(bins.sweep) + bins.max_change) * place + std::abs(bins.carrier) * half;
  const double angle = 2.0 * core::pi *
                       ((0.5 * (std::abs(bins.sweep) + bins.max_change) * place +
                         std::abs(bins.carrier) * (std::abs(span.middle) + half)) *
                            place +
                        0.5 * bins.max_change * bins.square);
  return angle < max_angle_rad && core::pi * bins.max_z * samples < max_width;
}

// Whether the functions make samples of echoes, each at another place, speed and bend: some hundreds all over the
// pulse.
bool SlepianRow::is_exact(const Kept& kept, const Fit& fit, std::span<const Parts> parts) const {
  // Steps that fill a cube evenly: powers of the inverse of the root of x^4 = x + 1.
  constexpr double steps[] = {0.81917251339616440, 0.67104360670378920, 0.54970047790197030};
  constexpr std::size_t looks = 400;
  const SlepianSums& bins = kept.bins;
  const std::size_t stride = std::max<std::size_t>(1, parts.size() / looks);
  const double max_error = share_ * share_ * static_cast<double>((parts.size() + stride - 1) / stride);
  double error = 0.0;
  for (std::size_t n = 0; n < parts.size() && error <= max_error; n += stride) {
    const auto look = static_cast<double>(n / stride);
    const auto within = [&](double step, const DopplerSpan& span) {
      return span.middle + span.half * (2.0 * (look * step - std::floor(look * step)) - 1.0);
    };
    const double place = within(steps[0], {0.0, 0.5});
    const PulseClock clock{within(steps[1], kept.motion.span), within(steps[2], kept.motion.bends)};
    const double at = bins.begin + 0.5 + place + static_cast<double>(n);
    error += std::norm(fit.sample(parts[n], place, clock) - body_->endless_echo(at, clock, kept.motion.carrier_hz));
  }
  return error <= max_error;
}

// What each function has of the samples goes into its weights, so that all sums count alike.
void SlepianRow::make_factors(Kept& kept, const Fit& fit, std::span<const Parts> parts) const {
  const std::size_t count = parts.size();
  const std::size_t period = row_fft_->size();
  std::array<double, functions> energy{};
  for (const Parts& sample : parts)
    for (std::size_t k = 0; k < functions; ++k) energy[k] += std::norm(sample[k]);
  const core::Fft fft(period);
  std::vector<std::complex<double>> row;
  for (std::size_t k = 0; k < functions; ++k) {
    kept.size[k] = std::sqrt(energy[k] / static_cast<double>(count));
    if (!(kept.size[k] * fit.most(k) > 0.2 * share_)) {
      kept.size[k] = 0.0;
      continue;
    }
    row.assign(period, {});
    for (std::size_t n = 0; n < count; ++n) row[n % period] += parts[n][k];
    fft.forward(row);
    kept.factor[k].resize(period);
    const double scale = 1.0 / (kept.size[k] * static_cast<double>(period));
    std::ranges::transform(row, kept.factor[k].begin(),
                           [&](const std::complex<double>& z) { return std::complex<float>(scale * z); });
  }
}

// What second derivatives of the polynomials leave of an echo with the largest change of the sweep, root mean square.
double SlepianRow::bend_error(const Kept& kept, const Fit& fit) {
  constexpr int checks = 203;
  double sum = 0.0;
  for (std::size_t k = 0; k < functions; ++k)
    for (int i = 0; i <= checks; ++i) {
      const double x = static_cast<double>(i) / checks;
      const double exact = kept.size[k] * fit.second_derivative(k, 2.0 * x - 1.0);
      sum += std::pow(0.25 * kept.weights.second_derivative(k, x) - exact, 2);
    }
  return fit.bend_of(kept.bins.max_change) * std::sqrt(sum / (checks + 1));
}

// False where the polynomials leave more than half of a share, or their second derivatives more than three: bins have
// a row of eight shares to themselves, and the functions leave one at most.
bool SlepianRow::make_weights(Kept& kept, const Fit& fit, double share) {
  for (std::size_t lowest_degree = 2; lowest_degree <= 3; ++lowest_degree) {
    auto weights =
        fit_lanes<float>(functions, [&](std::size_t k, double x) { return kept.size[k] * fit.value(k, 2.0 * x - 1.0); },
                         0.5 * share, {functions, lowest_degree, weights_bytes});
    if (!weights) return false;
    kept.weights = std::move(*weights);
    if (bend_error(kept, fit) < bend_shares * share) return true;
  }
  return false;
}

void SlepianRow::make_tails(Kept& kept, const Fit& fit) {
  const SlepianSums& bins = kept.bins;
  const auto count = static_cast<std::ptrdiff_t>(bins.main_samples());
  for (std::size_t run = 0; run < bins.run_count; ++run) {
    const std::ptrdiff_t more = static_cast<std::ptrdiff_t>(run) - static_cast<std::ptrdiff_t>(bins.main_run);
    for (std::ptrdiff_t sample = std::min(count, count + more); sample < std::max(count, count + more); ++sample) {
      BinTail tail{run, sample, {}, {}};
      const Parts parts = fit.parts(static_cast<double>(sample));
      for (std::size_t k = 0; k < functions; ++k)
        if (kept.size[k] > 0.0) tail.set(k, (more > 0 ? 1.0 : -1.0) / kept.size[k] * parts[k]);
      kept.tails.push_back(tail);
    }
  }
}

}  // namespace sarsim::radar
