#include "radar/echo/dense_row.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"
#include "radar/echo/complex_rows.hpp"

namespace sarsim::radar {

namespace {

constexpr std::size_t powers = Moments::powers;
constexpr std::size_t kept_bytes = 16'000'000;  // of factors, per thread
constexpr std::size_t most_points = 32'768;     // of a transform: sums and factors of more would take much memory
constexpr double shortest_run = 0.05;           // samples of phi that polynomials are fitted over
constexpr double most_pieces = 6.0;             // of a sample
// Echoes that take as long one by one as a point of one more transform and what is done to it.
constexpr double echoes_of_a_point = 0.6;

// Polynomials through values at Chebyshev's points, y from -1 to 1.
class PowerFit {
 public:
  PowerFit() {
    for (std::size_t i = 0; i < powers; ++i) {
      const double angle = core::pi * (static_cast<double>(i) + 0.5) / powers;
      node_[i] = std::cos(angle);
      std::array<double, powers> before{1.0};
      std::array<double, powers> now{0.0, 1.0};
      for (std::size_t m = 0; m < powers; ++m) {
        const double weight = (m == 0 ? 1.0 : 2.0) / powers * std::cos(static_cast<double>(m) * angle);
        for (std::size_t p = 0; p < powers; ++p) weight_[p][i] += weight * before[p];
        // T_(m+1) = 2 y T_m - T_(m-1).
        std::array<double, powers> next{};
        for (std::size_t p = 0; p + 1 < powers; ++p) next[p + 1] = 2.0 * now[p];
        for (std::size_t p = 0; p < powers; ++p) next[p] -= before[p];
        before = now;
        now = next;
      }
    }
  }

  using Coefficients = std::array<std::complex<double>, powers>;  // lowest power first

  template <class Function>
  [[nodiscard]] Coefficients fit(const Function& f) const {
    Coefficients sum{};
    for (std::size_t i = 0; i < powers; ++i) {
      const std::complex<double> value = f(node_[i]);
      for (std::size_t p = 0; p < powers; ++p) sum[p] += weight_[p][i] * value;
    }
    return sum;
  }

 private:
  std::array<double, powers> node_{};
  std::array<std::array<double, powers>, powers> weight_{};  // of value i in the coefficient of power p
};

std::complex<double> polynomial(const PowerFit::Coefficients& coefficients, double y) {
  std::complex<double> sum;
  for (std::size_t p = powers; p-- > 0;) sum = sum * y + coefficients[p];
  return sum;
}

double late_rate(double doppler) { return doppler / (1.0 - doppler); }

}  // namespace

// Samples of an echo in a bin, each a polynomial in y: [term][power][sample].
struct DenseRow::BinSamples {
  std::array<std::vector<std::complex<double>>, 2 * powers> row;
  double energy = 0.0;   // of the pulse, once for each term
  bool is_exact = true;  // the polynomials keep the share; if not, they are not finished
};

bool DenseRow::suits(const EchoPulse& pulse, const PulseBody& body) {
  const bool smooth = pulse.pulse.kind == Pulse::Kind::chirp || pulse.pulse.kind == Pulse::Kind::mono;
  return smooth && pulse.pulse.envelope == Pulse::Envelope::rectangular && !pulse.band_limited && body.has_body();
}

// Two pieces between samples, one more where the pulse ends between them; for two terms, which need fewer powers of the
// second, two more bins for the echoes whose ends motion moves over a sample.
std::size_t DenseRow::transforms_about(const PulseBody& body, std::size_t doppler_terms) {
  CORE_EXPECT(doppler_terms == 1 || doppler_terms == 2);
  const double samples = body.last() - body.first();
  const std::size_t bins = std::abs(samples - std::round(samples)) < 1e-9 ? 2 : 3;
  return doppler_terms == 1 ? powers * bins : 13 * bins + 12;
}

bool DenseRow::is_worth(double echoes, std::size_t transforms, std::size_t points) {
  return points <= most_points &&
         echoes > echoes_of_a_point * static_cast<double>(transforms) * static_cast<double>(points);
}

DenseRow::DenseRow(const PulseBody& body, const SampleGrid& grid, double share, double room,
                   const core::BasicFft<float>& row_fft)
    : body_(&body), grid_(grid), share_(share), room_(room), row_fft_(&row_fft) {
  CORE_EXPECT(share > 0.0);
  CORE_EXPECT(room >= 0.0);
  CORE_EXPECT(body.edges().size() == 2);
}

bool DenseRow::prepare(const DenseMotion& motion) {
  CORE_EXPECT(motion.terms == 1 || motion.terms == 2);
  const auto found = std::ranges::find_if(kept_, [&](const Kept& kept) { return kept.motion.is_same(motion); });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
  } else {
    kept_.push_front(make(motion));
    limit_kept();
  }
  return kept_.front().usable;
}

// The least recently used make room.
void DenseRow::limit_kept() {
  std::size_t bytes = 0;
  std::size_t count = 0;
  for (const Kept& kept : kept_) {
    for (const Spectrum& factor : kept.factor) bytes += factor.size() * sizeof(std::complex<float>);
    if (bytes > kept_bytes && count > 0) break;
    ++count;
  }
  kept_.resize(count);
}

void DenseRow::take(const Strengths<float>& echoes) {
  const Kept& kept = kept_.front();
  CORE_EXPECT(kept.usable);
  if (!has_sums_) moments_.make_room(kept.bins, kept.motion.terms);
  has_sums_ = true;
  add_moments(kept.bins, echoes, kept.motion.terms, moments_);
}

void DenseRow::forget() {
  if (has_sums_) moments_.sums.clear();
  has_sums_ = false;
}

void DenseRow::leave(std::span<std::complex<float>> spectrum) {
  CORE_EXPECT(spectrum.size() == row_fft_->size());
  if (!has_sums_) return;
  has_sums_ = false;
  const Kept& kept = kept_.front();
  for (std::size_t bin = 0; bin * powers < kept.factor.size(); ++bin) {
    take_powers(kept.bins, bin);
    for (std::size_t p = 0; p < powers; ++p) {
      const Spectrum& factor = kept.factor[bin * powers + p];
      if (factor.empty()) continue;
      row_fft_->forward(power_row_[p]);
      add_products<float>(spectrum, power_row_[p], factor);
    }
  }
}

// Moves the sums of a bin of a term to rows of the period, and leaves 0.
void DenseRow::take_powers(const RangeBins& bins, std::size_t bin) {
  const std::size_t period = row_fft_->size();
  const auto around = static_cast<std::ptrdiff_t>(period);
  for (Spectrum& row : power_row_) row.assign(period, {});
  auto at = static_cast<std::size_t>((static_cast<std::ptrdiff_t>(bins.first_sample) % around + around) % around);
  std::complex<float>* sums = moments_.sums.data() + bin * bins.samples * powers;
  for (std::size_t n = 0; n < bins.samples; ++n, sums += powers) {
    for (std::size_t p = 0; p < powers; ++p) power_row_[p][at] += sums[p];
    std::fill_n(sums, powers, std::complex<float>());
    if (++at == period) at = 0;
  }
}

// The fewest pieces that keep the share.
DenseRow::Kept DenseRow::make(const DenseMotion& motion) const {
  Kept kept;
  kept.motion = motion;
  for (double pieces = 1.0; pieces <= most_pieces && make_bins(kept, pieces); pieces += 1.0)
    if (make_factors(kept)) return kept;
  kept.usable = false;
  kept.factor.clear();
  return kept;
}

// False where motion moves the ends of pulses too far apart.
bool DenseRow::make_bins(Kept& kept, double pieces_per_sample) const {
  const DopplerSpan& span = kept.motion.span;
  RangeBins& bins = kept.bins;
  bins = {};
  bins.middle = span.middle;
  bins.shift = kept.motion.shift_s / grid_.interval_s;
  bins.tilt = span.half > 0.0 ? 1.0 / span.half : 0.0;
  bins.begin_hard = body_->first();
  bins.end_hard = body_->last();
  if (body_->is_stretched() && span != DopplerSpan{}) {
    bins.begin_late = body_->from_middle_s(bins.begin_hard) / grid_.interval_s;
    bins.end_late = body_->from_middle_s(bins.end_hard) / grid_.interval_s;
  }
  bins.begin = bins.begin_hard + bins.begin_late * late_rate(span.middle);
  const double longer = bins.end_late - bins.begin_late;
  const double apart = 1.01 * longer * span.half;  // by how much motion moves one end against the other
  if (apart > 0.25) return false;
  double samples = bins.end_hard - bins.begin_hard + longer * late_rate(span.middle);
  if (std::abs(samples - std::round(samples)) < 1e-9) samples = std::round(samples);
  // The end is reached after ceil(samples - phi) samples, or as many as motion makes of that; at rest phi is below 1.
  bins.least_samples = std::ceil(samples - 1.0 - apart);
  if (apart == 0.0 && bins.least_samples == samples - 1.0) bins.least_samples = samples;
  bins.run_count = static_cast<std::size_t>(std::ceil(samples + apart) - bins.least_samples) + 1;
  bins.bins = 0;
  for (std::size_t r = 0; r < bins.run_count; ++r) {
    RangeBins::Run& run = bins.runs[r];
    const double most = samples - bins.least_samples - static_cast<double>(r) + 1.0;
    run.from = std::clamp(most - 1.0, 0.0, 1.0);
    double length = std::clamp(most, 0.0, 1.0) - run.from;
    if (length < shortest_run) {
      run.from -= 0.5 * (shortest_run - length);
      length = shortest_run;
    }
    const double pieces = std::max(1.0, std::ceil(length * pieces_per_sample - 1e-6));
    run.per_piece = pieces / length;
    run.last_piece = pieces - 1.0;
    run.first_bin = static_cast<double>(bins.bins);
    bins.bins += static_cast<std::size_t>(pieces);
  }
  // For the echoes that touch the row, and a few beside.
  const double spare = 2.0 * room_ + 3.0;
  bins.first_sample = std::floor(bins.begin_hard - bins.end_hard - spare);
  bins.samples = static_cast<std::size_t>(static_cast<double>(grid_.count) + spare - bins.first_sample + 1.0);
  return true;
}

// False where polynomials do not keep the share.
bool DenseRow::make_factors(Kept& kept) const {
  const RangeBins& bins = kept.bins;
  kept.factor.assign(kept.motion.terms * bins.bins * powers, {});
  for (std::size_t r = 0; r < bins.run_count; ++r)
    for (double piece = 0.0; piece <= bins.runs[r].last_piece; piece += 1.0) {
      BinSamples samples = samples_of(kept, r, piece);
      if (!samples.is_exact) return false;
      if (kept.motion.terms == 2) tilt(samples);
      keep_factors(samples, static_cast<std::size_t>(bins.runs[r].first_bin + piece), kept);
    }
  return true;
}

DenseRow::BinSamples DenseRow::samples_of(const Kept& kept, std::size_t run_index, double piece) const {
  static const PowerFit fit;
  constexpr std::array<double, 4> check_places{-0.999, -0.3827, 0.7071, 0.999};  // where a fit errs about the most
  const RangeBins& bins = kept.bins;
  const RangeBins::Run& run = bins.runs[run_index];
  const DenseMotion& motion = kept.motion;
  const std::size_t period = row_fft_->size();
  BinSamples out;
  for (std::size_t c = 0; c < motion.terms * powers; ++c) out.row[c].assign(period, {});
  const auto count = static_cast<std::size_t>(bins.least_samples) + run_index;
  out.energy = static_cast<double>(count * motion.terms);
  const double most_error = 0.09 * share_ * share_ * out.energy;
  double error = 0.0;
  for (std::size_t n = 0; n < count && out.is_exact; ++n)
    for (std::size_t term = 0; term < motion.terms; ++term) {
      const double from_middle = motion.span.half * (motion.terms == 1 ? 0.0 : doppler_node(term, motion.terms));
      const double begin = bins.begin + bins.shift * from_middle + static_cast<double>(n);
      const auto sample = [&](double y) {
        const double phi = run.from + (piece + 0.5 * (y + 1.0)) / run.per_piece;
        return body_->endless_echo(begin + phi, {bins.middle + from_middle, 0.0}, motion.carrier_hz);
      };
      const PowerFit::Coefficients fitted = fit.fit(sample);
      for (std::size_t p = 0; p < powers; ++p) out.row[term * powers + p][n % period] += fitted[p];
      const double y = check_places[n % check_places.size()];
      error += std::norm(polynomial(fitted, y) - sample(y));
      out.is_exact = error <= most_error;
    }
  return out;
}

// From the samples at two nodes in D to those of the strengths and of their product with where D stands in the span.
void DenseRow::tilt(BinSamples& samples) {
  const double slope = 0.5 / doppler_node(0, 2);
  for (std::size_t p = 0; p < powers; ++p)
    for (std::size_t n = 0; n < samples.row[p].size(); ++n) {
      const std::complex<double> high = samples.row[p][n];
      const std::complex<double> low = samples.row[powers + p][n];
      samples.row[p][n] = 0.5 * (high + low);
      samples.row[powers + p][n] = slope * (high - low);
    }
}

void DenseRow::keep_factors(BinSamples& samples, std::size_t bin, Kept& kept) const {
  const std::size_t period = row_fft_->size();
  const core::Fft fft(period);
  const double least = 1e-3 * share_ * share_ * samples.energy / static_cast<double>(kept.motion.terms);
  for (std::size_t c = 0; c < kept.motion.terms * powers; ++c) {
    std::vector<std::complex<double>>& row = samples.row[c];
    double energy = 0.0;
    for (const std::complex<double>& z : row) energy += std::norm(z);
    if (!(energy > least)) continue;
    fft.forward(row);
    Spectrum& factor = kept.factor[(c / powers * kept.bins.bins + bin) * powers + c % powers];
    factor.resize(period);
    std::ranges::transform(row, factor.begin(), [&](const std::complex<double>& z) {
      return std::complex<float>(z / static_cast<double>(period));
    });
  }
}

}  // namespace sarsim::radar
