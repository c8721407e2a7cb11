#include "workflow/focus/phase_history_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/maths/turns.hpp"
#include "core/report/invalid_request.hpp"
#include "raster/cphd/cphd_file.hpp"

namespace sarsim::workflow {

namespace {

using raster::PhaseDomain;
using raster::PhaseVector;

// Frequencies between samples of the band and the next band: enough for the interpolation of back projection.
constexpr double oversampling = 1.3;

std::size_t middle_sample(std::size_t samples) { return samples / 2; }

[[noreturn]] void refuse_vector(const raster::CphdFile& file, std::size_t vector, const char* what,
                                std::string found = {}, std::string expected = "finite numbers") {
  throw core::InvalidRequest({core::error(fmt::format("vector {} (from 0) {}", vector, what))
                                  .found(std::move(found))
                                  .expected(std::move(expected))
                                  .hint("the file is damaged, or cut off and filled up")
                                  .in(file.file().path().string())});
}

bool is_sound(const PhaseVector& v) {
  return std::isfinite(core::norm(v.tx_m) + core::norm(v.tx_mps) + core::norm(v.rcv_m) + core::norm(v.srp_m)) &&
         std::isfinite(v.tx_time_s + v.rcv_time_s + v.first + v.toa1_s + v.toa2_s + v.amplitude) && v.step > 0.0 &&
         std::isfinite(1.0 / v.step) && v.fx1_hz > 0.0 && std::isfinite(v.fx2_hz);
}

}  // namespace

// How the compressed echoes of a vector are sampled, in time after the arrival of the reference point's.
struct PhaseHistoryRows::Sampling {
  std::size_t transform = 0;  // FX: length of the transform
  std::size_t count = 0;      // samples
  double first_s = 0.0;
  double interval_s = 0.0;
};

PhaseHistoryRows::PhaseHistoryRows(std::shared_ptr<const raster::CphdFile> file, std::size_t channel,
                                   std::optional<int> sign, const radar::EarthFrame& earth)
    : file_(std::move(file)), channel_(channel), sign_(sign.value_or(file_->description().sign)), earth_(earth) {}

// Of FX the times of arrival that the vector says to hold, and a little on either side; no more than the period in
// which they are told apart.
PhaseHistoryRows::Sampling PhaseHistoryRows::sampling_of(const PhaseVector& v) const {
  const std::size_t samples = channel().samples;
  if (file_->description().domain == PhaseDomain::toa) return {0, samples, v.first, v.step};
  constexpr double spare_samples = 16.0;
  Sampling sampling;
  sampling.transform =
      core::fast_fft_size(static_cast<std::size_t>(std::ceil(oversampling * static_cast<double>(samples))));
  const double period_s = 1.0 / v.step;
  sampling.interval_s = period_s / static_cast<double>(sampling.transform);
  const double wanted = (v.toa2_s - v.toa1_s) / sampling.interval_s + 2.0 * spare_samples;
  const double middle_s = 0.5 * (v.toa1_s + v.toa2_s);
  sampling.count =
      static_cast<std::size_t>(std::clamp(std::ceil(wanted), 2.0, static_cast<double>(sampling.transform)));
  sampling.first_s = middle_s - 0.5 * static_cast<double>(sampling.count) * sampling.interval_s;
  return sampling;
}

double PhaseHistoryRows::carrier_hz(const PhaseVector& v) const {
  if (file_->description().domain == PhaseDomain::toa) return channel().centre_hz;
  return v.first + static_cast<double>(middle_sample(channel().samples)) * v.step;
}

signal::TrackPoint PhaseHistoryRows::track_point(const PhaseVector& v) const {
  signal::TrackPoint point{v.tx_time_s, earth_.world_from_ecef(v.tx_m), {}};
  const double under_way_s = v.rcv_time_s - v.tx_time_s;
  if (!file_->description().bistatic && under_way_s > 0.0)
    point.velocity_mps = (1.0 / under_way_s) * (earth_.world_from_ecef(v.rcv_m) - point.position_m);
  return point;
}

// As back projection computes it, so that the difference to a target's has no rounding of its own.
double PhaseHistoryRows::reference_delay_s(const PhaseVector& v, const signal::TrackPoint& point) const {
  const double c = core::exact_light_speed_mps;
  const core::Vec3 srp_m = earth_.world_from_ecef(v.srp_m);
  const core::Vec3 r = srp_m - point.position_m;
  if (file_->description().bistatic) return (core::norm(r) + core::norm(srp_m - earth_.world_from_ecef(v.rcv_m))) / c;
  const core::Vec3& mps = point.velocity_mps;
  return 2.0 / c / (1.0 - core::dot(mps, mps) / (c * c)) * (core::norm(r) - core::dot(r, mps) / c);
}

std::size_t PhaseHistoryRows::together(std::size_t first) const {
  constexpr std::size_t max_samples = std::size_t{1} << 23U;
  constexpr std::size_t most = 4096;
  const std::size_t rows = std::min(most, channel().vectors - first);
  std::vector<PhaseVector> vectors(rows);
  file_->read_vectors(channel_, first, vectors);
  if (!is_sound(vectors.front()) && vectors.front().signal != 0) refuse_vector(*file_, first, "says no place or time");
  const Sampling sampling = sampling_of(vectors.front());
  const std::size_t fit = std::clamp<std::size_t>(max_samples / std::max<std::size_t>(sampling.count, 1), 1, rows);
  std::size_t count = 1;
  while (count < fit && vectors[count].step == vectors.front().step &&
         sampling_of(vectors[count]).count == sampling.count)
    ++count;
  return count;
}

signal::SarEchoes PhaseHistoryRows::echoes(std::size_t first, std::size_t count,
                                           const core::WorkControl& control) const {
  const raster::CphdDescription& d = file_->description();
  std::vector<PhaseVector> vectors(count);
  file_->read_vectors(channel_, first, vectors);
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < count; ++i) {
    if (vectors[i].signal == 0) continue;
    if (!is_sound(vectors[i])) refuse_vector(*file_, first + i, "says no place or time");
    used.push_back(i);
  }
  signal::SarEchoes echoes;
  if (used.empty()) return echoes;
  const Sampling sampling = sampling_of(vectors[used.front()]);
  echoes.samples = sampling.count;
  echoes.waveform = {.carrier_hz = channel().centre_hz,
                     .bandwidth_hz = channel().band_hz,
                     .pulse_width_s = 0.0,
                     .sample_rate_hz = 1.0 / sampling.interval_s,
                     .light_speed_mps = core::exact_light_speed_mps};
  std::vector<double> delays_s;
  for (const std::size_t i : used) {
    const PhaseVector& v = vectors[i];
    echoes.track.push_back(track_point(v));
    delays_s.push_back(reference_delay_s(v, echoes.track.back()));
    echoes.later_s.push_back(delays_s.back() + sampling_of(v).first_s);
    echoes.carriers_hz.push_back(carrier_hz(v));
    if (d.bistatic) echoes.receivers_m.push_back(earth_.world_from_ecef(v.rcv_m));
  }
  echoes.volts.resize(used.size() * echoes.samples);
  const core::BasicFft<double> fft(std::max<std::size_t>(sampling.transform, 1));
  core::parallel_ranges(used.size(), 8, control, [&](std::size_t begin, std::size_t end) {
    std::vector<std::complex<float>> samples(channel().samples);
    std::vector<std::complex<double>> row(sampling.transform);
    for (std::size_t i = begin; i < end; ++i) {
      const PhaseVector& v = vectors[used[i]];
      file_->read_samples(channel_, first + used[i], v.amplitude, samples);
      for (std::complex<float>& sample : samples) {
        if (!std::isfinite(sample.real()) || !std::isfinite(sample.imag()))
          refuse_vector(*file_, first + used[i], "holds a sample that is not a number");
        if (!(std::abs(static_cast<double>(sample.real())) <= raster::max_cphd_sample &&
              std::abs(static_cast<double>(sample.imag())) <= raster::max_cphd_sample))
          refuse_vector(*file_, first + used[i], "holds a sample that is too large to compute with",
                        fmt::format("{:g} + {:g}j", sample.real(), sample.imag()),
                        fmt::format("finite numbers, up to {:g}", raster::max_cphd_sample));
        if (sign_ > 0) sample = std::conj(sample);
      }
      const std::complex<double> turn = core::turned_exactly(-echoes.carriers_hz[i] * delays_s[i]);
      const std::span<std::complex<float>> out = std::span(echoes.volts).subspan(i * echoes.samples, echoes.samples);
      if (d.domain == PhaseDomain::toa) {
        for (std::size_t k = 0; k < samples.size(); ++k)
          out[k] = std::complex<float>(turn * std::complex<double>(samples[k]));
        continue;
      }
      const auto middle = static_cast<std::ptrdiff_t>(middle_sample(samples.size()));
      const double scale = 1.0 / static_cast<double>(samples.size());
      const double first_turns = v.step * sampling_of(v).first_s;
      std::ranges::fill(row, std::complex<double>());
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const std::ptrdiff_t bin = static_cast<std::ptrdiff_t>(k) - middle;
        const auto at = static_cast<std::size_t>(bin < 0 ? bin + static_cast<std::ptrdiff_t>(row.size()) : bin);
        row[at] = scale * turn * core::turned_exactly(static_cast<double>(bin) * first_turns) *
                  std::complex<double>(samples[k]);
      }
      fft.inverse(row);
      for (std::size_t k = 0; k < out.size(); ++k) out[k] = std::complex<float>(row[k]);
    }
  });
  return echoes;
}

std::vector<PhaseVector> PhaseHistoryRows::some_vectors(std::size_t most) const {
  const std::size_t vectors = channel().vectors;
  const std::size_t count = std::min(most, vectors);
  std::vector<PhaseVector> some;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = count > 1 ? i * (vectors - 1) / (count - 1) : 0;
    PhaseVector vector;
    file_->read_vectors(channel_, at, std::span(&vector, 1));
    if (vector.signal == 0) continue;
    if (!is_sound(vector)) refuse_vector(*file_, at, "says no place or time");
    some.push_back(vector);
  }
  return some;
}

}  // namespace sarsim::workflow
