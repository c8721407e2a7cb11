#include "radar/echo/direct_kernel.hpp"

#include <algorithm>
#include <cmath>

#include "core/maths/constants.hpp"
#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

// Half a block squared over the samples of a chirp is the largest number of turns: 3e5 for one of 500 at full band,
// which a double resolves to 3e-11.
constexpr std::size_t longest_block = 32768;

double centre_of_block(std::size_t block, std::size_t length) {
  return static_cast<double>(block * length + length / 2);
}

}  // namespace

DirectKernel::DirectKernel(const EchoPulse& pulse, const SampleGrid& grid, double tolerance)
    : pulse_(&pulse),
      grid_(grid),
      tolerance_(tolerance),
      single_precision_(tolerance >= 1e-6),
      sweep_rate_hz_per_s_(pulse.band_limited ? 0.0 : pulse.pulse.sweep_rate_hz_per_s()),
      block_(std::clamp<std::size_t>(grid.count, 1, longest_block)) {
  CORE_EXPECT(grid.interval_s > 0.0);
  CORE_EXPECT(tolerance > 0.0);
  if (pulse.band_limited || pulse.pulse.kind == Pulse::Kind::user ||
      pulse.pulse.envelope != Pulse::Envelope::rectangular) {
    shape_.emplace(pulse, grid, single_precision_);
    if (!shape_->is_usable()) return;
  }
  sum_.re.resize(grid.count + SplitRow::padding);
  sum_.im.resize(grid.count + SplitRow::padding);
  const double sweep = sweep_rate_hz_per_s_ * grid.interval_s * grid.interval_s;
  if (sweep == 0.0) return;
  chirp_.re.resize(block_);
  chirp_.im.resize(block_);
  for (std::size_t n = 0; n < block_; ++n) {
    const double m = static_cast<double>(n) - centre_of_block(0, block_);
    const double turns = 0.5 * sweep * m * m;
    const std::complex<double> phasor = std::polar(1.0, 2.0 * core::pi * (turns - std::round(turns)));
    chirp_.re[n] = phasor.real();
    chirp_.im[n] = phasor.imag();
  }
}

SampleSpan DirectKernel::add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes) {
  CORE_EXPECT(row.size() >= grid_.count);
  CORE_EXPECT(std::isfinite(carrier_hz));
  CORE_EXPECT(echoes.is_whole());
  if ((shape_ && !shape_->is_usable()) || is_beyond_tones(echoes)) {
    add_echoes(row, grid_, *pulse_, carrier_hz, echoes);
    return {0, grid_.count};
  }
  const SampleSpan touched = collect(carrier_hz, echoes);
  add_tones(tones_, single_precision_, sum_, scratch_);
  if (shape_) add_shaped_tones(*shape_, shaped_, shaped_tones_, sum_, scratch_, shape_scratch_);
  if (chirp_.re.empty()) {
    drain(sum_, touched.begin, touched.end, {}, row);
    return touched;
  }
  for (std::size_t begin = touched.begin; begin < touched.end;) {
    const std::size_t in_block = begin % block_;
    const std::size_t end = std::min(touched.end, begin - in_block + block_);
    const std::span<const double> re(chirp_.re);
    const std::span<const double> im(chirp_.im);
    drain(sum_, begin, end, {re.subspan(in_block), im.subspan(in_block)}, row);
    begin = end;
  }
  return touched;
}

// A chirp that is stretched unevenly is no longer a quadratic phase: K a u^3/2 turns are left, largest at its ends. A
// table that has the sweep in it is read at the right times.
bool DirectKernel::is_beyond_tones(const EchoBatch& echoes) const {
  if (echoes.dilation_rate.empty() || pulse_->doppler_rule != DopplerRule::stretch) return false;
  double largest = 0.0;
  for (const double bend : echoes.dilation_rate) largest = std::max(largest, std::abs(bend));
  const double half_s = 0.5 * pulse_->pulse.width_s;
  return core::pi * std::abs(sweep_rate_hz_per_s_) * largest * half_s * half_s * half_s > 0.1 * tolerance_;
}

// Returns the samples that the echoes touch, from the first to the last.
SampleSpan DirectKernel::collect(double carrier_hz, const EchoBatch& echoes) {
  tones_.clear();
  shaped_tones_.clear();
  shaped_.clear();
  SampleSpan touched;
  for (std::size_t k = 0; k < echoes.size(); ++k) {
    const PulseClock clock = pulse_->clock_of(echoes, k);
    const SampleSpan on = touched_samples(*pulse_, grid_, echoes.delay_s[k], clock);
    if (on.begin >= on.end) continue;
    touched = touched.with(on);
    const Source source{echoes.delay_s[k], echoes.amplitude_sqrt_w[k],      echoes.doppler[k], clock,
                        carrier_hz,        echoes.late_turns(k, carrier_hz)};
    if (!shape_) {
      append_tones(source, on, tones_);
      continue;
    }
    const SampleSpan flat = flat_samples(source, on);
    append_shaped(source, {on.begin, flat.begin});
    Source gained = source;
    gained.amplitude *= shape_->constant().gain;
    append_tones(gained, flat, tones_);
    append_shaped(source, {flat.end, on.end});
  }
  return touched;
}

// Samples of an echo where the shape is a number: they need no table.
SampleSpan DirectKernel::flat_samples(const Source& source, const SampleSpan& on) const {
  const ShapeTable::Constant& constant = shape_->constant();
  if (constant.begin >= constant.end) return {on.begin, on.begin};
  const std::size_t cell = shape_->place(on, source.delay_s, source.clock).cell;
  // The samples of a stretched echo stray from their cells.
  const double half_s = 0.5 * pulse_->pulse.width_s;
  const double strays =
      std::max(std::abs(source.clock.late_of(half_s)), std::abs(source.clock.late_of(-half_s))) / grid_.interval_s;
  const std::size_t margin = strays == 0.0 ? 0 : 2 + static_cast<std::size_t>(2.0 * strays);
  if (constant.end - constant.begin <= 2 * margin) return {on.begin, on.begin};
  const auto sample_of = [&](std::size_t c) { return std::clamp(on.begin + c, cell + on.begin, cell + on.end) - cell; };
  return {sample_of(constant.begin + margin), sample_of(constant.end - margin)};
}

void DirectKernel::append_shaped(const Source& source, const SampleSpan& on) {
  for (std::size_t begin = on.begin; begin < on.end;) {
    ShapedEcho echo;
    echo.place = shape_->place({begin, on.end}, source.delay_s, source.clock);
    const std::size_t end = begin + echo.place.count;
    echo.first_tone = shaped_tones_.size();
    append_tones(source, {begin, end}, shaped_tones_);
    echo.last_tone = shaped_tones_.size();
    shaped_.push_back(echo);
    begin = end;
  }
}

void DirectKernel::append_tones(const Source& source, const SampleSpan& on, std::vector<Tone>& tones) const {
  for (std::size_t begin = on.begin; begin < on.end;) {
    const std::size_t block = begin / block_;
    Tone tone = tone_at(source, block);
    tone.begin = begin;
    tone.end = std::min(on.end, (block + 1) * block_);
    if (pulse_->pulse.kind == Pulse::Kind::code && !pulse_->band_limited)
      append_code_tones(tone, source, tones);
    else
      tones.push_back(tone);
    begin = tone.end;
  }
}

// Phase in turns of sample centre + m: (S - L)u^2/2 - D f u - (f tau - phi) with u = u0 + m dt, less S (m dt)^2/2. S is
// the sweep rate K, or 0 where a table has the pulse with its sweep; L what motion takes from it: f a + S D (2 - D), as
// S (1 - D)^2 is left of the sweep, and K D by the rule of the thesis.
Tone DirectKernel::tone_at(const Source& source, std::size_t block) const {
  const double dt = grid_.interval_s;
  const double doppler_rate = pulse_->doppler_rule == DopplerRule::stretch
                                  ? source.carrier_hz * source.clock.dilation_rate +
                                        sweep_rate_hz_per_s_ * source.doppler * (2.0 - source.doppler)
                                  : source.doppler * pulse_->pulse.sweep_rate_hz_per_s();
  const double doppler_hz = source.doppler * source.carrier_hz;
  const double sweep_rate = sweep_rate_hz_per_s_ - doppler_rate;
  Tone tone;
  tone.centre = centre_of_block(block, block_);
  const double u0 = grid_.first_s + tone.centre * dt - source.delay_s + pulse_->lead_s - 0.5 * pulse_->pulse.width_s;
  tone.alpha = 0.5 * sweep_rate * u0 * u0 - doppler_hz * u0 - (source.late_turns - std::round(source.late_turns));
  tone.beta = (sweep_rate * u0 - doppler_hz) * dt;
  tone.gamma = -0.5 * doppler_rate * dt * dt;
  tone.amplitude = source.amplitude;
  return tone;
}

// One tone per run of chips with the same sign.
void DirectKernel::append_code_tones(const Tone& whole, const Source& source, std::vector<Tone>& tones) const {
  const std::vector<int>& code = pulse_->pulse.code;
  const double chip_s = pulse_->pulse.width_s / static_cast<double>(code.size());
  Tone tone = whole;
  for (std::size_t chip = 0; chip < code.size();) {
    std::size_t after = chip + 1;
    while (after < code.size() && code[after] == code[chip]) ++after;
    // The border of chips is an edge like that of a pulse: a sample within 1e-9 of an interval belongs to the later
    // one.
    const double border_s = static_cast<double>(after) * chip_s;
    const double late_s = source.clock.late_of(border_s - 0.5 * pulse_->pulse.width_s);
    const double border = (source.delay_s - pulse_->lead_s + border_s + late_s - grid_.first_s) / grid_.interval_s;
    const double next = after == code.size() ? static_cast<double>(whole.end) : std::ceil(border - 1e-9);
    tone.end =
        static_cast<std::size_t>(std::clamp(next, static_cast<double>(tone.begin), static_cast<double>(whole.end)));
    tone.amplitude = whole.amplitude * code[chip];
    if (tone.begin < tone.end) tones.push_back(tone);
    tone.begin = tone.end;
    chip = after;
  }
}

}  // namespace sarsim::radar
