#include "radar/echo/spectral_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <list>
#include <optional>

#include "core/maths/constants.hpp"
#include "core/maths/fft.hpp"
#include "core/os/aligned_vector.hpp"
#include "core/report/expect.hpp"
#include "radar/echo/complex_rows.hpp"
#include "radar/echo/direct_kernel.hpp"
#include "radar/echo/doppler_coupling.hpp"
#include "radar/echo/doppler_terms.hpp"
#include "radar/echo/edge_pieces.hpp"
#include "radar/echo/gridding.hpp"
#include "radar/echo/pulse_body.hpp"
#include "radar/echo/slepian_row.hpp"
#include "radar/echo/spectral_settings.hpp"
#include "radar/echo/strengths.hpp"

namespace sarsim::radar {

namespace {

constexpr std::size_t spectra_bytes = 16'000'000;  // of remembered spectra, per thread
constexpr std::size_t bands_kept = 4;              // allowances for Doppler shifts whose transforms are remembered
constexpr std::size_t oversampling = 4;            // of the body, for its spectrum

// Of a transform of rows: beyond the near cache its length costs more than its factors.
std::size_t row_size_for(std::size_t minimum) {
  constexpr std::size_t max_in_cache = 16384;
  const std::size_t fast = core::fast_fft_size(minimum);
  return fast <= max_in_cache ? fast : core::good_fft_size(minimum);
}

}  // namespace

struct SpectralKernel::Implementation {
  virtual ~Implementation() = default;
  virtual void begin(double carrier_hz, std::size_t expected) = 0;
  virtual void take(const EchoBatch& echoes) = 0;
  virtual void finish(std::span<std::complex<double>> row) = 0;
  virtual void finish_filtered(std::span<std::complex<double>> out) = 0;
};

template <class Real>
struct SpectralKernel::Typed : Implementation {
  // What depends on the Doppler span: nodes and the factors of the modes, with every scale in them.
  struct Spectra {
    DopplerSpan span;
    DopplerSpan bends;
    double carrier_hz = 0.0;
    double shift_s = 0.0;                                         // per unit of D from the middle of the span
    std::size_t terms = 1;                                        // in D
    std::size_t bend_terms = 1;                                   // times these in a
    std::vector<core::AlignedVector<std::complex<Real>>> factor;  // [bend term x terms + term][mode + modes]

    // Two terms are the strengths themselves and their product with where D stands in the span, -1 to 1.
    [[nodiscard]] bool is_tilted() const { return terms == 2 && bend_terms == 1; }
    [[nodiscard]] bool is_same_motion(const Spectra& other) const { return span == other.span && bends == other.bends; }
  };

  // The transform between the spreading grid and the modes of a band.
  struct Band {
    double allowance;   // for Doppler shifts, cycles per sample
    std::size_t modes;  // -modes ... modes - 1
    std::size_t cells;  // of the spreading grid
    core::BasicFft<Real> grid_fft;
    std::vector<double> kernel_transform;
    std::list<Spectra> recent;

    Band(double shift_allowance, double half_band, std::size_t row_size, const GriddingKernel& kernel)
        : allowance(shift_allowance),
          modes(static_cast<std::size_t>(std::ceil((half_band + allowance) * static_cast<double>(row_size)))),
          cells(core::fast_fft_size(4 * modes + 2 * kernel.width)),
          grid_fft(cells),
          kernel_transform(kernel.transforms(cells, modes + 1)) {}
  };

  // What the echoes on the grid are spread for.
  struct Gridding {
    Band* band = nullptr;
    const Spectra* spectra = nullptr;  // none: nothing is on the grid

    [[nodiscard]] bool is_for(double allowance, const Spectra& wanted) const {
      return spectra != nullptr && band->allowance == allowance && spectra->is_same_motion(wanted);
    }
  };

  Typed(const EchoPulse& echo_pulse, const SampleGrid& sample_grid, const SpectralSettings& choices, double tolerance,
        const RowFilter& filter)
      : pulse(&echo_pulse),
        grid(sample_grid),
        settings(choices),
        body(echo_pulse, sample_grid.interval_s, choices.edge_samples, choices.beta),
        kernel(choices.share),
        taps(tap_polynomials<Real>(kernel, 0.3 * choices.share)),
        direct(echo_pulse, sample_grid, tolerance),
        room(stretch_room(echo_pulse, sample_grid.interval_s)),
        row_size(row_size_for(sample_grid.count +
                              static_cast<std::size_t>(std::ceil(body.last() - body.first()) + 2.0 * room) + 4)),
        row_fft(row_size),
        folded(row_size) {
    edge_row.resize(grid.count);
    if (body.has_body())
      if (auto found = edge_pieces<Real>(body, settings.edge_samples, 0.3 * settings.share)) {
        has_body = true;
        pieces = std::move(*found);
        steepest = steepest_edge(echo_pulse, body, settings.edge_samples);
      }
    if constexpr (sizeof(Real) == 4)
      if (has_body && SlepianRow::suits(echo_pulse, body))
        dense.emplace(echo_pulse, body, grid, choices.share, room, row_fft);
    if (!filter.taps.empty()) set_filter(filter);
  }

  void set_filter(const RowFilter& filter) {
    // Correlation: the transform of the filter run backwards in time.
    std::vector<std::complex<double>> backwards(row_size);
    for (std::size_t k = 0; k < filter.taps.size(); ++k) backwards[(row_size - k) % row_size] = filter.taps[k];
    const core::Fft fft(row_size);
    fft.forward(backwards);
    double largest = 0.0;
    for (const std::complex<double>& value : backwards) largest = std::max(largest, std::abs(value));
    if (!(largest > 0.0) || !std::isfinite(largest)) largest = 1.0;
    // A power of two apart, so that weak echoes behind a filter of little gain keep their digits in single precision.
    response_scale = std::exp2(std::floor(std::log2(largest)));
    for (std::complex<double>& value : backwards) value /= response_scale;
    response.assign(backwards.begin(), backwards.end());
    output_index.assign(filter.output_index.begin(), filter.output_index.end());
  }

  void begin(double new_carrier_hz, std::size_t echoes_expected) override {
    carrier_hz = new_carrier_hz;
    expected = echoes_expected;
    densely.reset();
    if (dense) dense->forget();
    motion.reset();
    spreading = {};
    has_bodies = has_edges = has_plain = false;
    lone.clear();
  }

  // Parts go onto one grid for as long as the motion of all so far asks for the same spectra.
  void take(const EchoBatch& echoes) override {
    gather(echoes);
    if (position.empty()) return;
    motion = motion ? motion->with(gathered.motion) : gathered.motion;
    Spectra wanted = wanted_spectra();
    // Those of a part without bends are 0.
    if (wanted.bends != DopplerSpan{}) gathered.dilation_rate.resize(position.size());
    if (!has_body || is_beyond_room()) return take_plainly(echoes);
    if (take_densely(wanted, echoes.size())) return;
    if (edges_stray() || wanted.terms * wanted.bend_terms > max_doppler_terms) return take_plainly(echoes);
    share_span(wanted);
    part_neighbours(gathered);
    const double allowance = allowance_for(max_doppler() * body.largest_frequency_hz(carrier_hz) * grid.interval_s);
    if (!spreading.is_for(allowance, wanted)) {
      leave_grid();
      spreading.band = &band_for(allowance);
      spreading.spectra = &spectra_for(*spreading.band, wanted);
      spread_grid.resize(spreading.band->cells, spreading.spectra->factor.size());
      spread_grid.clear();
    }
    spread_terms(*spreading.spectra);
    if (pieces.empty()) return;
    begin_edges();
    add_edge_pieces();
  }

  void begin_edges() {
    if (!has_edges) edge_row.clear();
    has_edges = true;
  }

  // Where many echoes fall on each sample. The first part of a pulse decides, for how many are to come.
  bool take_densely([[maybe_unused]] const Spectra& wanted, [[maybe_unused]] std::size_t given) {
    if constexpr (sizeof(Real) == 4) {
      const double touching = static_cast<double>(position.size()) / static_cast<double>(given);
      const double in_all = touching * static_cast<double>(std::max(expected, given));
      if (!dense) return false;
      if (!densely) {
        const std::size_t transforms =
            SlepianRow::transforms_about(*pulse, grid.interval_s, carrier_hz, wanted.span.half, settings.share);
        densely = SlepianRow::is_worth(in_all, transforms, row_size, wanted.terms * wanted.bend_terms);
      }
      if (!*densely) return false;
      DenseMotion common{carrier_hz,
                         SlepianRow::shared_span(*pulse, grid.interval_s, carrier_hz, wanted.span, settings.share),
                         wanted.bends};
      if (dense->is_refused(common)) common.span = wanted.span;
      if (!dense->is_for(common)) leave_dense();
      if (!dense->prepare(common)) {
        common.span = wanted.span;
        if (!dense->prepare(common)) return false;
      }
      dense->take(gathered);
      return true;
    }
    return false;
  }

  void leave_dense() {
    if constexpr (sizeof(Real) == 4) {
      if (!dense || dense->is_empty()) return;
      begin_bodies();
      dense->leave(folded, lone);
    }
  }

  void begin_bodies() {
    if (!has_bodies) std::ranges::fill(folded, std::complex<Real>());
    has_bodies = true;
  }

  // Echoes that are better added directly.
  void take_plainly(const EchoBatch& echoes) {
    if (!has_plain) raw_row.assign(grid.count, {});
    has_plain = true;
    direct.add(raw_row, carrier_hz, echoes);
  }

  void finish(std::span<std::complex<double>> row) override {
    CORE_EXPECT(row.size() == grid.count);
    leave_grid();
    leave_dense();
    if (has_bodies) {
      row_fft.inverse(folded);
      add_row<Real>(row, std::span(folded).first(row.size()));
    }
    if (has_edges) add_row<Real>(row, edge_samples());
    if (has_plain) std::ranges::transform(row, raw_row, row.begin(), std::plus());
    for (const LoneSample& sample : lone) row[sample.at] += std::complex<double>(sample.value);
  }

  void finish_filtered(std::span<std::complex<double>> out) override {
    leave_grid();
    leave_dense();
    if (!has_bodies && !has_plain) return;
    if (!has_bodies) std::ranges::fill(folded, std::complex<Real>());
    if (has_edges || has_plain || !lone.empty()) {
      time_row.assign(row_size, {});
      if (has_edges) std::ranges::copy(edge_samples(), time_row.begin());
      if (has_plain)
        for (std::size_t n = 0; n < raw_row.size(); ++n) time_row[n] += std::complex<Real>(raw_row[n]);
      for (const LoneSample& sample : lone) time_row[sample.at] += std::complex<Real>(sample.value);
      add_time_row();
    }
    multiply_by<Real>(folded, response);
    row_fft.inverse(folded);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] += response_scale * std::complex<double>(folded[output_index[i]]);
  }

  [[nodiscard]] std::span<std::complex<Real>> edge_samples() {
    return std::span(edge_row.samples).subspan(EdgeRow<Real>::padding, grid.count);
  }

  // Adds the spectrum of a row of samples to that of the bodies.
  void add_time_row() {
    row_fft.forward(time_row);
    const Real scale = Real(1) / static_cast<Real>(row_size);
    for (std::size_t j = 0; j < row_size; ++j) folded[j] += scale * time_row[j];
  }

  // What the motion of the echoes taken so far asks for.
  Spectra wanted_spectra() {
    Spectra wanted;
    wanted.carrier_hz = carrier_hz;
    wanted.span = span_covering(motion->lowest_doppler, motion->highest_doppler);
    wanted.bends =
        bends_covering(motion->lowest_bend, motion->highest_bend, largest_bend_rad(body, carrier_hz), settings.share);
    const DopplerCoupling coupling = coupling_for(wanted.span);
    wanted.shift_s = coupling.shift_s;
    wanted.terms = wanted.span.half > 0.0 ? coupling.terms_for(wanted.span.half, settings.motion_share()) : 1;
    wanted.bend_terms =
        wanted.bends.half > 0.0 ? bend_terms_for(body, carrier_hz, wanted.bends.half, settings.share) : 1;
    return wanted;
  }

  // As wide as its terms allow, so that rows share spectra.
  void share_span(Spectra& wanted) {
    if (wanted.span.half == 0.0) return;
    const double widest = coupling_for(wanted.span).widest(wanted.terms, grid.interval_s, settings.motion_share());
    wanted.span = span_within(motion->lowest_doppler, motion->highest_doppler, std::min(8.0 * wanted.span.half, widest))
                      .value_or(wanted.span);
  }

  // How echoes of a span are taken: that of the last carrier is kept, as most radars have one.
  DopplerCoupling coupling_for(const DopplerSpan& span) {
    if (span.half == 0.0) return {};
    if (!coupled || coupled_carrier_hz != carrier_hz) {
      coupled = coupling_of(*pulse, body, grid.interval_s, carrier_hz);
      coupled_carrier_hz = carrier_hz;
    }
    return best_coupling(*coupled, body, carrier_hz, span.half, grid.interval_s, settings.motion_share());
  }

  // Whether echoes are stretched, or bent, beyond what there is room for.
  [[nodiscard]] bool is_beyond_room() const {
    if (pulse->doppler_rule == DopplerRule::thesis) return false;
    return (max_doppler() + 0.5 * max_bend()) * (body.last() - body.first()) > std::max(room, 1e-12);
  }

  // Whether they are beyond what the samples at the edges follow: these keep their shape, and the Doppler of the hard
  // end.
  [[nodiscard]] bool edges_stray() const {
    if (pulse->doppler_rule == DopplerRule::thesis || !motion->moving()) return false;
    const auto samples = static_cast<double>(settings.edge_samples);
    const double rad =
        2.0 * core::pi * carrier_hz * grid.interval_s * samples * (max_doppler() * max_doppler() + 0.5 * max_bend());
    const double share_of_edges =
        std::sqrt(static_cast<double>(pieces.size()) * samples / (body.last() - body.first()));
    return share_of_edges * (rad + samples * (max_doppler() + max_bend()) * steepest) > settings.share;
  }

  [[nodiscard]] double max_doppler() const {
    return std::max(std::abs(motion->lowest_doppler), std::abs(motion->highest_doppler));
  }
  // What the largest bend changes D by until the ends of the pulse.
  [[nodiscard]] double max_bend() const {
    const double half_s = 0.5 * (body.last() - body.first()) * grid.interval_s;
    return half_s * std::max(std::abs(motion->lowest_bend), std::abs(motion->highest_bend));
  }

  Band& band_for(double allowance) {
    const auto found = std::ranges::find(bands, allowance, &Band::allowance);
    if (found != bands.end()) {
      bands.splice(bands.begin(), bands, found);
      return bands.front();
    }
    if (bands.size() >= bands_kept) bands.pop_back();
    return bands.emplace_front(allowance, body.half_band(), row_size, kernel);
  }

  // The echoes that touch the row.
  void gather(const EchoBatch& echoes) {
    RowFrame frame;
    frame.carrier_hz = carrier_hz;
    frame.origin_s = pulse->lead_s + grid.first_s;
    frame.interval_s = grid.interval_s;
    frame.from = -body.last() - room;
    frame.to = static_cast<double>(grid.count) - body.first() + room;
    gather_strengths(echoes, frame, gathered);
  }

  void spread_terms(const Spectra& s) {
    SpreadMotion moved;
    if (s.span.half > 0.0) moved = {doppler, s.span.middle, s.shift_s / grid.interval_s, 1.0 / s.span.half};
    const bool weighs = s.factor.size() > 1 && !s.is_tilted();
    if (weighs) weigh(s);
    std::span<const std::complex<Real>> strengths = weighs ? weighted : strength;
    spread<Real>(taps, kernel.width, static_cast<double>(row_size), position, strengths, moved, spread_grid);
  }

  // Strengths for each node in D, for each node in a.
  void weigh(const Spectra& s) {
    const std::size_t count = position.size();
    weighted.resize(s.factor.size() * count);
    const std::span<std::complex<Real>> all(weighted);
    if (s.bend_terms == 1) return weigh_strengths<Real>(strength, gathered.doppler, s.span, s.terms, all);
    if (s.terms == 1) return weigh_strengths<Real>(strength, gathered.dilation_rate, s.bends, s.bend_terms, all);
    bent.resize(s.bend_terms * count);
    weigh_strengths<Real>(strength, gathered.dilation_rate, s.bends, s.bend_terms, bent);
    for (std::size_t b = 0; b < s.bend_terms; ++b)
      weigh_strengths<Real>(std::span(bent).subspan(b * count, count), gathered.doppler, s.span, s.terms,
                            all.subspan(b * s.terms * count, s.terms * count));
  }

  // Grid to modes, times the factors, folded into the sampled band.
  void leave_grid() {
    if (spreading.spectra == nullptr) return;
    const Band& band = *spreading.band;
    const Spectra& s = *spreading.spectra;
    begin_bodies();
    spreading = {};
    for (std::size_t r = 0; r < s.factor.size(); ++r) {
      const std::span<std::complex<Real>> cell = spread_grid.fold(r);
      band.grid_fft.forward(cell);
      fold_modes(cell.last(band.modes), std::span(s.factor[r]).first(band.modes), row_size - band.modes % row_size);
      fold_modes(cell.first(band.modes), std::span(s.factor[r]).last(band.modes), 0);
    }
  }

  // Adds modes times factors to the bins of the row from `bin` on, again and again around the circle.
  void fold_modes(std::span<const std::complex<Real>> modes, std::span<const std::complex<Real>> factors,
                  std::size_t bin) {
    bin %= row_size;
    for (std::size_t from = 0; from < modes.size();) {
      const std::size_t count = std::min(modes.size() - from, row_size - bin);
      add_products<Real>(std::span(folded).subspan(bin, count), modes.subspan(from, count),
                         factors.subspan(from, count));
      from += count;
      bin = 0;
    }
  }

  // Adds the samples next to the hard edges to `edge_row`.
  void add_edge_pieces() {
    for (EdgePiece<Real>& piece : pieces) {
      if (pulse->doppler_rule == DopplerRule::stretch && gathered.motion.moving()) {
        // Without bends they are the same at each edge.
        if (&piece == &pieces.front() || !gathered.dilation_rate.empty()) find_late_rates(piece);
        add_stretched_edge(piece);
        continue;
      }
      piece.doppler_offset = body.doppler_turns(piece.start, carrier_hz);
      piece.doppler_bend = 0.5 * (body.doppler_turns(piece.start + 1.0, carrier_hz) +
                                  body.doppler_turns(piece.start - 1.0, carrier_hz)) -
                           piece.doppler_offset;
      piece.doppler_slope =
          body.doppler_turns(piece.start + 1.0, carrier_hz) - piece.doppler_offset - piece.doppler_bend;
      add_edges<Real>(piece, position, strength,
                      gathered.motion.moving() ? std::span<const double>(doppler) : std::span<const double>(),
                      edge_row);
    }
  }

  void find_late_rates(const EdgePiece<Real>& piece) {
    late.resize(position.size());
    late_rates(doppler, gathered.dilation_rate, body.from_middle_s(piece.hard), late);
  }

  // An edge comes back where its hard end does, the few samples beside it as they were sent but for their phase: with
  // h the hard end, D' = late_of(h)/h and s the time from it, D' f h + D' (f s + K (h + s) s) turns.
  void add_stretched_edge(EdgePiece<Real>& piece) {
    const double hard_s = body.from_middle_s(piece.hard);
    const double before_s = (piece.hard - piece.start) * grid.interval_s;  // from the first sample to the hard end
    const double sweep = pulse->pulse.sweep_rate_hz_per_s();
    const double slope = carrier_hz + sweep * (hard_s - 2.0 * before_s);
    piece.doppler_offset = carrier_hz * (hard_s - before_s) - sweep * (hard_s - before_s) * before_s;
    piece.doppler_slope = slope * grid.interval_s;
    piece.doppler_bend = sweep * grid.interval_s * grid.interval_s;
    piece.late = hard_s / grid.interval_s;
    add_edges<Real>(piece, position, strength, late, edge_row);
  }

  const Spectra& spectra_for(Band& band, const Spectra& wanted) {
    const bool at_rest = wanted.span == DopplerSpan{} && wanted.bends == DopplerSpan{};
    const auto found = std::ranges::find_if(band.recent, [&](const Spectra& s) {
      return s.is_same_motion(wanted) && (s.carrier_hz == wanted.carrier_hz || at_rest);
    });
    if (found != band.recent.end()) {
      band.recent.splice(band.recent.begin(), band.recent, found);
      return band.recent.front();
    }
    band.recent.push_front(make_spectra(band, wanted));
    // Stepped carriers come back; the least recently used spectra make room.
    std::size_t bytes = 0;
    std::size_t kept = 0;
    for (const Spectra& s : band.recent) {
      bytes += s.factor.size() * s.factor.front().size() * sizeof(std::complex<Real>);
      if (bytes > spectra_bytes && kept > 0) break;
      ++kept;
    }
    band.recent.resize(kept);
    return band.recent.front();
  }

  Spectra make_spectra(const Band& band, Spectra s) {
    const auto node = [](const DopplerSpan& span, std::size_t r, std::size_t terms) {
      return span.middle + (span.half > 0.0 ? span.half * doppler_node(r, terms) : 0.0);
    };
    for (std::size_t b = 0; b < s.bend_terms; ++b)
      for (std::size_t r = 0; r < s.terms; ++r)
        s.factor.push_back(mode_factors(band, {node(s.span, r, s.terms), node(s.bends, b, s.bend_terms)}, s));
    if (!s.is_tilted()) return s;
    const auto half = static_cast<Real>(0.5);
    const auto slope = static_cast<Real>(0.5 / doppler_node(0, 2));
    for (std::size_t j = 0; j < s.factor[0].size(); ++j) {
      const std::complex<Real> high = s.factor[0][j];
      const std::complex<Real> low = s.factor[1][j];
      s.factor[0][j] = half * (high + low);
      s.factor[1][j] = slope * (high - low);
    }
    return s;
  }

  // Spectrum of the body so stretched at the modes, taken where the span takes it, over the kernel's transform, with
  // the scale of the transforms.
  core::AlignedVector<std::complex<Real>> mode_factors(const Band& band, const PulseClock& clock, const Spectra& s) {
    const double shift =
        s.shift_s * (clock.doppler - s.span.middle) / (grid.interval_s * static_cast<double>(row_size));
    const std::size_t fine = oversampling * fine_factor(band) * row_size;
    const double per_sample = static_cast<double>(oversampling * fine_factor(band));
    std::vector<std::complex<double>> spectrum(fine);
    const auto first = static_cast<std::ptrdiff_t>(std::ceil(body.received(body.first(), clock) * per_sample));
    const auto last = static_cast<std::ptrdiff_t>(std::floor(body.received(body.last(), clock) * per_sample));
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      const auto index =
          static_cast<std::size_t>(((i % static_cast<std::ptrdiff_t>(fine)) + static_cast<std::ptrdiff_t>(fine)) %
                                   static_cast<std::ptrdiff_t>(fine));
      spectrum[index] += body.echo(static_cast<double>(i) / per_sample, clock, s.carrier_hz);
    }
    const core::Fft fft(fine);
    fft.forward(spectrum);
    const auto half = static_cast<std::ptrdiff_t>(band.modes);
    core::AlignedVector<std::complex<Real>> factor(2 * band.modes);
    for (std::ptrdiff_t j = -half; j < half; ++j) {
      const std::complex<double> q =
          spectrum[static_cast<std::size_t>(j < 0 ? j + static_cast<std::ptrdiff_t>(fine) : j)] *
          std::polar(1.0 / per_sample, 2.0 * core::pi * shift * static_cast<double>(j));
      factor[static_cast<std::size_t>(j + half)] = std::complex<Real>(
          q / (static_cast<double>(row_size) * band.kernel_transform[static_cast<std::size_t>(std::abs(j))]));
    }
    return factor;
  }

  // The body is sampled often enough that its spectrum, twice as wide as the modes, does not alias.
  [[nodiscard]] std::size_t fine_factor(const Band& band) const {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(body.half_band() + band.allowance)));
  }

  const EchoPulse* pulse;
  SampleGrid grid;
  SpectralSettings settings;
  PulseBody body;
  GriddingKernel kernel;
  LanePolynomials<Real> taps;
  DirectKernel direct;
  double room;           // for the stretch of echoes at either end, samples
  std::size_t row_size;  // points of the period that the row is part of
  core::BasicFft<Real> row_fft;
  std::vector<EdgePiece<Real>> pieces;
  std::list<Band> bands;
  std::optional<SlepianRow> dense;

  // Of the pulse that was begun.
  double carrier_hz = 0.0;
  std::optional<MotionSpan> motion;  // of the echoes taken so far; none: none touches the row
  std::size_t expected = 0;          // echoes in all
  std::optional<bool> densely;       // none: no echo so far
  Gridding spreading;
  bool has_bodies = false;  // in `folded`
  bool has_edges = false;   // in `edge_row`
  bool has_plain = false;   // in `raw_row`
  std::vector<LoneSample> lone;

  Strengths<Real> gathered;  // of the part that is taken
  core::AlignedVector<double>& position = gathered.position;
  core::AlignedVector<std::complex<Real>>& strength = gathered.strength;
  core::AlignedVector<double>& doppler = gathered.doppler;
  core::AlignedVector<std::complex<Real>> weighted;
  core::AlignedVector<std::complex<Real>> bent;
  core::AlignedVector<double> late;
  SpreadGrid<Real> spread_grid;
  EdgeRow<Real> edge_row;
  bool has_body = false;
  double steepest = 0.0;  // edge, 1/sample
  std::optional<DopplerCoupling> coupled;
  double coupled_carrier_hz = 0.0;
  core::AlignedVector<std::complex<Real>> folded;  // spectrum, then samples, of the period

  core::AlignedVector<std::complex<Real>> response;  // of the filter, but for its scale
  double response_scale = 1.0;
  std::vector<std::size_t> output_index;
  core::AlignedVector<std::complex<Real>> time_row;
  std::vector<std::complex<double>> raw_row;
};

SpectralKernel::SpectralKernel(const EchoPulse& pulse, const SampleGrid& grid, double tolerance,
                               const RowFilter& filter) {
  CORE_EXPECT(grid.interval_s > 0.0);
  CORE_EXPECT(tolerance > 0.0);
  const SpectralSettings settings(tolerance);
  if (settings.single_precision)
    implementation_ = std::make_unique<Typed<float>>(pulse, grid, settings, tolerance, filter);
  else
    implementation_ = std::make_unique<Typed<double>>(pulse, grid, settings, tolerance, filter);
}

SpectralKernel::~SpectralKernel() = default;
SpectralKernel::SpectralKernel(SpectralKernel&&) noexcept = default;
SpectralKernel& SpectralKernel::operator=(SpectralKernel&&) noexcept = default;

void SpectralKernel::add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes) {
  begin(carrier_hz, echoes.size());
  take(echoes);
  finish(row);
}

void SpectralKernel::begin(double carrier_hz, std::size_t expected) {
  CORE_EXPECT(std::isfinite(carrier_hz));
  implementation_->begin(carrier_hz, expected);
}

void SpectralKernel::take(const EchoBatch& echoes) {
  CORE_EXPECT(echoes.is_whole());
  implementation_->take(echoes);
}

void SpectralKernel::finish(std::span<std::complex<double>> row) { implementation_->finish(row); }

void SpectralKernel::finish_filtered(std::span<std::complex<double>> out) { implementation_->finish_filtered(out); }

SpectralCost SpectralKernel::cost(const EchoPulse& pulse, const SampleGrid& grid, double tolerance, double carrier_hz,
                                  double lowest_doppler, double highest_doppler) {
  CORE_EXPECT(grid.interval_s > 0.0);
  CORE_EXPECT(tolerance > 0.0);
  CORE_EXPECT(lowest_doppler <= highest_doppler);
  const SpectralSettings settings(tolerance);
  const PulseBody body(pulse, grid.interval_s, settings.edge_samples, settings.beta);
  const auto row = static_cast<double>(grid.count) + body.last() - body.first();
  const double shift = std::max(std::abs(lowest_doppler), std::abs(highest_doppler)) *
                       body.largest_frequency_hz(carrier_hz) * grid.interval_s;
  const DopplerSpan span = span_covering(lowest_doppler, highest_doppler);
  SpectralCost cost;
  cost.gridding_width = GriddingKernel(settings.share).width;
  cost.edge_samples = body.edges().size() * settings.edge_samples;
  cost.transform_size = static_cast<std::size_t>(4.0 * (body.half_band() + allowance_for(shift)) * row);
  if (span.half > 0.0)
    cost.doppler_terms = best_coupling(coupling_of(pulse, body, grid.interval_s, carrier_hz), body, carrier_hz,
                                       span.half, grid.interval_s, settings.motion_share())
                             .terms_for(span.half, settings.motion_share());
  if (!body.has_body()) cost.doppler_terms = max_doppler_terms + 1;
  if (settings.single_precision && SlepianRow::suits(pulse, body)) {
    cost.bin_transforms = SlepianRow::transforms_about(pulse, grid.interval_s, carrier_hz, span.half, settings.share);
    cost.bin_points = static_cast<std::size_t>(row);
  }
  return cost;
}

}  // namespace sarsim::radar
