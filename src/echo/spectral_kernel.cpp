#include "echo/spectral_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <list>

#include "base/constants.hpp"
#include "echo/direct_kernel.hpp"
#include "echo/pulse_body.hpp"
#include "echo/spreading.hpp"
#include "echo/strengths.hpp"
#include "math/fft.hpp"

namespace sarsim {

namespace {

constexpr std::size_t most_terms = 24;             // of the Doppler expansion; beyond, pulses are added directly
constexpr std::size_t spectra_bytes = 16'000'000;  // of remembered spectra, per thread
constexpr std::size_t bands_kept = 4;              // allowances for Doppler shifts whose transforms are remembered
constexpr std::size_t oversampling = 4;            // of the body, for its spectrum

// How an error budget is divided and what follows from it.
struct Settings {
  bool single_precision;
  double share;              // error allowed to each source
  std::size_t edge_samples;  // K
  double beta;               // of the Kaiser step

  explicit Settings(double tolerance)
      : single_precision(tolerance >= 9.9e-7),
        share(tolerance / 8.0),
        edge_samples(single_precision ? 8 : 12),
        beta(std::log(4.0 / share)) {}
};

// Terms of the interpolation in D that make exp(-j z x), |x| <= 1, to `error`: the remainder of Chebyshev interpolation
// is below 2 (z/2)^R/R! for R nodes.
std::size_t terms_for(double z, double error) {
  double bound = 2.0;
  for (std::size_t terms = 1;; ++terms) {
    bound *= 0.5 * z / static_cast<double>(terms);
    if (bound < error || terms > most_terms) return terms;
  }
}

// Largest Doppler phase per unit of D over the pulse [rad].
double largest_doppler_rad(const PulseBody& body, double carrier_hz) {
  double largest = 0.0;
  for (int i = 0; i <= 16; ++i)
    largest = std::max(
        largest, std::abs(body.doppler_turns(body.first() + (body.last() - body.first()) * i / 16.0, carrier_hz)));
  return 2.0 * pi * largest;
}

// A span of D = 2v/c on a fixed ladder of spans, so that neighbouring pulses share spectra.
struct DopplerSpan {
  double middle = 0.0;
  double half = 0.0;
  friend bool operator==(const DopplerSpan&, const DopplerSpan&) = default;
};

DopplerSpan span_covering(double lowest, double highest) {
  if (lowest == highest) return {lowest, 0.0};
  // Half spans are powers of two; middles are multiples of half of that.
  double half = std::exp2(std::ceil(std::log2(0.5 * (highest - lowest))));
  for (;; half *= 2.0) {
    const double step = 0.5 * half;
    const double middle = std::round(0.5 * (lowest + highest) / step) * step;
    if (middle - half <= lowest && middle + half >= highest) return {middle, half};
  }
}

// What a body's band is widened by for Doppler shifts of up to `shift` cycles per sample: nothing where it is too small
// to move more than a trifle over the edge, otherwise a power of two, so that few widths occur. It depends on the
// pulse's own echoes alone, so that a kernel gives the same samples whatever it did before.
double allowance_for(double shift) {
  constexpr double trifle = 1.0 / 4096.0;
  return shift <= trifle ? 0.0 : std::exp2(std::ceil(std::log2(shift)));
}

double node(std::size_t r, std::size_t terms) {
  return std::cos(pi * (static_cast<double>(r) + 0.5) / static_cast<double>(terms));
}

}  // namespace

struct SpectralKernel::Implementation {
  virtual ~Implementation() = default;
  virtual void add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes) = 0;
};

template <class Real>
struct SpectralKernel::Typed : Implementation {
  // What depends on the Doppler span: nodes and the factors of the modes, with every scale in them.
  struct Spectra {
    DopplerSpan span;
    double carrier_hz = 0.0;
    std::size_t terms = 1;
    std::vector<std::vector<std::complex<Real>>> factor;  // [term][mode + modes]
  };

  // The transform between the spreading grid and the modes of a band.
  struct Band {
    double allowance;   // for Doppler shifts, cycles per sample
    std::size_t modes;  // -modes ... modes - 1
    std::size_t cells;  // of the spreading grid
    BasicFft<Real> grid_fft;
    std::vector<double> kernel_transform;
    std::list<Spectra> recent;

    Band(double shift_allowance, double half_band, std::size_t row_size, const SpreadingKernel& kernel)
        : allowance(shift_allowance),
          modes(static_cast<std::size_t>(std::ceil((half_band + allowance) * static_cast<double>(row_size)))),
          cells(good_fft_size(4 * modes + 2 * kernel.width)),
          grid_fft(cells),
          kernel_transform(modes + 1) {
      for (std::size_t j = 0; j <= modes; ++j)
        kernel_transform[j] = kernel.transform(static_cast<double>(j) / static_cast<double>(cells));
    }
  };

  Typed(const EchoPulse& echo_pulse, const SampleGrid& sample_grid, const Settings& choices, double tolerance)
      : pulse(&echo_pulse),
        grid(sample_grid),
        settings(choices),
        body(echo_pulse, sample_grid.interval_s, choices.edge_samples, choices.beta),
        kernel(choices.share),
        taps(tap_polynomials<Real>(kernel, 0.3 * choices.share)),
        direct(echo_pulse, sample_grid, tolerance),
        row_size(
            good_fft_size(sample_grid.count + static_cast<std::size_t>(std::ceil(body.last() - body.first())) + 4)),
        row_fft(row_size),
        folded(row_size) {
    edge_row.resize(grid.count);
  }

  void add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes) override {
    gather(carrier_hz, echoes);
    if (position.empty()) return;
    const auto [lowest, highest] =
        gathered.moving ? std::ranges::minmax(doppler) : std::ranges::minmax_result<double>{0.0, 0.0};
    const DopplerSpan span = span_covering(lowest, highest);
    if (!body.has_body() || terms_for(largest_doppler_rad(body, carrier_hz) * span.half, settings.share) > most_terms) {
      direct.add(row, carrier_hz, echoes);
      return;
    }
    Band& band = band_for(std::max(std::abs(lowest), std::abs(highest)) * carrier_hz * grid.interval_s);
    const Spectra& s = spectra_for(band, span, carrier_hz);
    spread_terms(band, s);
    transform(band, s, row);
    add_edge_pieces(carrier_hz, row);
  }

  Band& band_for(double shift) {
    const double allowance = allowance_for(shift);
    const auto found = std::ranges::find(bands, allowance, &Band::allowance);
    if (found != bands.end()) {
      bands.splice(bands.begin(), bands, found);
      return bands.front();
    }
    if (bands.size() >= bands_kept) bands.pop_back();
    return bands.emplace_front(allowance, body.half_band(), row_size, kernel);
  }

  // The echoes that touch the row.
  void gather(double carrier_hz, const EchoBatch& echoes) {
    RowFrame frame;
    frame.carrier_hz = carrier_hz;
    frame.light_speed_mps = pulse->light_speed_mps;
    frame.origin_s = pulse->lead_s + grid.first_s;
    frame.interval_s = grid.interval_s;
    frame.from = -body.last();
    frame.to = static_cast<double>(grid.count) - body.first();
    gather_strengths(echoes, frame, gathered);
  }

  void spread_terms(const Band& band, const Spectra& s) {
    const std::size_t count = position.size();
    const double scale = static_cast<double>(band.cells) / static_cast<double>(row_size);
    cell_position.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double wrapped = position[k] < 0.0 ? position[k] + static_cast<double>(row_size) : position[k];
      cell_position[k] = std::min(wrapped * scale, static_cast<double>(band.cells));
    }
    spread_grid.resize(band.cells, s.terms);
    spread_grid.clear();
    if (s.terms == 1) {
      spread<Real>(taps, kernel.width, cell_position, strength, spread_grid);
      return;
    }
    weighted.resize(count * s.terms);
    for (std::size_t k = 0; k < count; ++k) weigh(k, count, s);
    spread<Real>(taps, kernel.width, cell_position, weighted, spread_grid);
  }

  // Strengths of one echo for the Doppler nodes: Lagrange's polynomials in Chebyshev form.
  void weigh(std::size_t k, std::size_t count, const Spectra& s) {
    const double x = (doppler[k] - s.span.middle) / s.span.half;
    const auto terms = static_cast<double>(s.terms);
    for (std::size_t r = 0; r < s.terms; ++r) {
      const double xr = node(r, s.terms);
      double sum = 0.5;
      double before = 1.0, now = x, node_before = 1.0, node_now = xr;
      for (std::size_t m = 1; m < s.terms; ++m) {
        sum += now * node_now;
        const double next = 2.0 * x * now - before;
        const double node_next = 2.0 * xr * node_now - node_before;
        before = now, now = next, node_before = node_now, node_now = node_next;
      }
      weighted[r * count + k] = strength[k] * static_cast<Real>(2.0 * sum / terms);
    }
  }

  // Grid to modes, times the factors, folded into the sampled band, back to samples.
  void transform(const Band& band, const Spectra& s, std::span<std::complex<double>> row) {
    std::ranges::fill(folded, std::complex<Real>());
    for (std::size_t r = 0; r < s.terms; ++r) {
      const std::span<std::complex<Real>> cell = spread_grid.fold(r);
      band.grid_fft.forward(cell);
      const std::complex<Real>* factor = s.factor[r].data();
      const auto half = static_cast<std::ptrdiff_t>(band.modes);
      const auto size = static_cast<std::ptrdiff_t>(row_size);
      std::ptrdiff_t bin = ((-half % size) + size) % size;
      for (std::ptrdiff_t j = -half; j < half; ++j) {
        const std::complex<Real> c =
            cell[static_cast<std::size_t>(j < 0 ? j + static_cast<std::ptrdiff_t>(band.cells) : j)];
        const std::complex<Real> f = factor[j + half];
        auto& out = folded[static_cast<std::size_t>(bin)];
        out = {out.real() + (c.real() * f.real() - c.imag() * f.imag()),
               out.imag() + (c.real() * f.imag() + c.imag() * f.real())};
        if (++bin == size) bin = 0;
      }
    }
    row_fft.inverse(folded);
    for (std::size_t n = 0; n < row.size(); ++n) row[n] += std::complex<double>(folded[n]);
  }

  void add_edge_pieces(double carrier_hz, std::span<std::complex<double>> row) {
    if (body.edges().empty()) return;
    if (pieces.empty()) make_pieces();
    edge_row.clear();
    for (std::size_t e = 0; e < pieces.size(); ++e) {
      EdgePiece<Real>& piece = pieces[e];
      piece.doppler_offset = body.doppler_turns(piece.start, carrier_hz);
      piece.doppler_bend = 0.5 * (body.doppler_turns(piece.start + 1.0, carrier_hz) +
                                  body.doppler_turns(piece.start - 1.0, carrier_hz)) -
                           piece.doppler_offset;
      piece.doppler_slope =
          body.doppler_turns(piece.start + 1.0, carrier_hz) - piece.doppler_offset - piece.doppler_bend;
      add_edges<Real>(piece, position, strength,
                      gathered.moving ? std::span<const double>(doppler) : std::span<const double>(), edge_row);
    }
    for (std::size_t n = 0; n < row.size(); ++n)
      row[n] += std::complex<double>(edge_row.samples[n + EdgeRow<Real>::padding]);
  }

  void make_pieces() {
    const auto width = static_cast<double>(settings.edge_samples);
    for (const PulseBody::Edge& edge : body.edges()) {
      // Kept off the border by a hair, so that a value there is the one inside the piece.
      const auto inside = [&](double t) { return std::clamp(t, edge.start + 1e-9, edge.start + width - 1e-9); };
      const auto left_out = [&](std::size_t lane, double fraction) {
        const double t = static_cast<double>(lane) + fraction;
        const double x = t / width;
        return body.value(inside(edge.start + t)) * (1.0 - body.step(edge.rising ? x : 1.0 - x));
      };
      EdgePiece<Real> piece;
      piece.start = edge.start;
      piece.samples = fit_lanes<Real>(
          2 * settings.edge_samples,
          [&](std::size_t lane, double x) {
            const std::complex<double> e = left_out(lane / 2, x);
            return lane % 2 == 0 ? e.real() : e.imag();
          },
          0.3 * settings.share);
      pieces.push_back(std::move(piece));
    }
  }

  const Spectra& spectra_for(Band& band, const DopplerSpan& span, double carrier_hz) {
    const auto found = std::ranges::find_if(band.recent, [&](const Spectra& s) {
      return s.span == span && (s.carrier_hz == carrier_hz || (span.half == 0.0 && span.middle == 0.0));
    });
    if (found != band.recent.end()) {
      band.recent.splice(band.recent.begin(), band.recent, found);
      return band.recent.front();
    }
    band.recent.push_front(make_spectra(band, span, carrier_hz));
    // Stepped carriers come back; the least recently used spectra make room.
    std::size_t bytes = 0;
    std::size_t kept = 0;
    for (const Spectra& s : band.recent) {
      bytes += s.terms * s.factor.front().size() * sizeof(std::complex<Real>);
      if (bytes > spectra_bytes && kept > 0) break;
      ++kept;
    }
    band.recent.resize(kept);
    return band.recent.front();
  }

  Spectra make_spectra(const Band& band, const DopplerSpan& span, double carrier_hz) {
    Spectra s;
    s.span = span;
    s.carrier_hz = carrier_hz;
    s.terms = span.half > 0.0 ? terms_for(largest_doppler_rad(body, carrier_hz) * span.half, settings.share) : 1;
    for (std::size_t r = 0; r < s.terms; ++r) {
      const double d = span.middle + (span.half > 0.0 ? span.half * node(r, s.terms) : 0.0);
      s.factor.push_back(mode_factors(band, d, carrier_hz));
    }
    return s;
  }

  // Spectrum of the body with Doppler d at the modes, over the kernel's transform, with the scale of the transforms.
  std::vector<std::complex<Real>> mode_factors(const Band& band, double d, double carrier_hz) {
    const std::size_t fine = oversampling * fine_factor(band) * row_size;
    const double per_sample = static_cast<double>(oversampling * fine_factor(band));
    std::vector<std::complex<double>> spectrum(fine);
    const auto first = static_cast<std::ptrdiff_t>(std::ceil(body.first() * per_sample));
    const auto last = static_cast<std::ptrdiff_t>(std::floor(body.last() * per_sample));
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      const double t = static_cast<double>(i) / per_sample;
      const double share = body.body_share(t);
      if (share == 0.0) continue;
      const double turns = d * body.doppler_turns(t, carrier_hz);
      const auto index =
          static_cast<std::size_t>(((i % static_cast<std::ptrdiff_t>(fine)) + static_cast<std::ptrdiff_t>(fine)) %
                                   static_cast<std::ptrdiff_t>(fine));
      spectrum[index] += share * body.value(t) * std::polar(1.0, -2.0 * pi * (turns - std::round(turns)));
    }
    const Fft fft(fine);
    fft.forward(spectrum);
    const auto half = static_cast<std::ptrdiff_t>(band.modes);
    std::vector<std::complex<Real>> factor(2 * band.modes);
    for (std::ptrdiff_t j = -half; j < half; ++j) {
      const std::complex<double> q =
          spectrum[static_cast<std::size_t>(j < 0 ? j + static_cast<std::ptrdiff_t>(fine) : j)] / per_sample;
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
  Settings settings;
  PulseBody body;
  SpreadingKernel kernel;
  LanePolynomials<Real> taps;
  DirectKernel direct;
  std::size_t row_size;  // points of the period that the row is part of
  BasicFft<Real> row_fft;
  std::vector<EdgePiece<Real>> pieces;
  std::list<Band> bands;

  Strengths<Real> gathered;
  std::vector<double>& position = gathered.position;
  std::vector<std::complex<Real>>& strength = gathered.strength;
  std::vector<double>& doppler = gathered.doppler;
  std::vector<double> cell_position;
  std::vector<std::complex<Real>> weighted;
  SpreadGrid<Real> spread_grid;
  EdgeRow<Real> edge_row;
  std::vector<std::complex<Real>> folded;
};

SpectralKernel::SpectralKernel(const EchoPulse& pulse, const SampleGrid& grid, double tolerance) {
  const Settings settings(tolerance);
  if (settings.single_precision)
    implementation_ = std::make_unique<Typed<float>>(pulse, grid, settings, tolerance);
  else
    implementation_ = std::make_unique<Typed<double>>(pulse, grid, settings, tolerance);
}

SpectralKernel::~SpectralKernel() = default;
SpectralKernel::SpectralKernel(SpectralKernel&&) noexcept = default;
SpectralKernel& SpectralKernel::operator=(SpectralKernel&&) noexcept = default;

void SpectralKernel::add(std::span<std::complex<double>> row, double carrier_hz, const EchoBatch& echoes) {
  implementation_->add(row, carrier_hz, echoes);
}

SpectralCost SpectralKernel::cost(const EchoPulse& pulse, const SampleGrid& grid, double tolerance, double carrier_hz,
                                  double doppler_span) {
  const Settings settings(tolerance);
  const PulseBody body(pulse, grid.interval_s, settings.edge_samples, settings.beta);
  const auto row = static_cast<double>(grid.count) + body.last() - body.first();
  SpectralCost cost;
  cost.spreading_width = SpreadingKernel(settings.share).width;
  cost.edge_samples = body.edges().size() * settings.edge_samples;
  cost.transform_size = static_cast<std::size_t>(4.0 * body.half_band() * row);
  cost.doppler_terms = terms_for(largest_doppler_rad(body, carrier_hz) * doppler_span, settings.share);
  if (!body.has_body()) cost.doppler_terms = most_terms + 1;
  return cost;
}

}  // namespace sarsim
