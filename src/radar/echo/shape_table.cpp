#include "radar/echo/shape_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

constexpr double largest_bytes = 32e6;
// Cells before the pulse: a sample within the tolerance of the leading edge may stand in the last of them.
constexpr std::size_t front = ShapeTable::cells_per_block;
constexpr double sharp_reach = 1e-8;      // how near to a cell a jump asks for its patch, intervals
constexpr double end_tolerance = 1.1e-9;  // a band-limited pulse is 0 from 1e-9 of an interval before its end
// A tone of its own costs as much as this many values from the table.
constexpr std::size_t shortest_constant = 1024;

double double_of(std::size_t n) { return static_cast<double>(n); }

}  // namespace

// Chebyshev series of every part of every cell, and the degree that each needs; fit_terms where only a patch will do.
struct ShapeTable::Fits {
  Fits(std::size_t part_count, std::size_t cell_count)
      : parts(part_count), cells(cell_count), series(part_count * cell_count), degree(part_count * cell_count, 0) {}
  [[nodiscard]] std::size_t index(std::size_t part, std::size_t cell) const { return part * cells + cell; }
  [[nodiscard]] std::size_t highest_degree() const { return *std::ranges::max_element(degree); }

  std::size_t parts;
  std::size_t cells;
  std::vector<FitTerms> series;
  std::vector<std::size_t> degree;
};

bool ShapeTable::is_worth_making(const EchoPulse& pulse, const SampleGrid& grid, bool single_precision) {
  CORE_EXPECT(grid.interval_s > 0.0);
  // Judged by what most pulses take: six or ten terms in four parts of a cell.
  const bool two_values = pulse.band_limited || pulse.pulse.kind == Pulse::Kind::user;
  const double values = (two_values ? 2.0 : 1.0) * (pulse.band_limited ? 4.0 : 1.0) * (single_precision ? 6.0 : 10.0);
  return values * (single_precision ? 4.0 : 8.0) * (pulse.last_s() - pulse.first_s()) / grid.interval_s <=
         largest_bytes;
}

ShapeTable::ShapeTable(const EchoPulse& pulse, const SampleGrid& grid, bool single_precision)
    : pulse_(&pulse),
      grid_(grid),
      single_precision_(single_precision),
      complex_(pulse.band_limited || pulse.pulse.kind == Pulse::Kind::user),
      origin_s_(pulse.band_limited ? pulse.band_limited->first_s() : 0.0),
      last_((pulse.last_s() - pulse.first_s()) / grid.interval_s) {
  CORE_EXPECT(grid.interval_s > 0.0);
  if (!is_worth_making(pulse, grid, single_precision)) return;
  const auto needed = static_cast<std::size_t>(std::ceil(last_)) + 2 + front;
  cells_ = (needed + cells_per_block - 1) / cells_per_block * cells_per_block;
  if (pulse.band_limited)
    tabulate_band_limited();
  else
    tabulate_pieces();
}

ShapePlace ShapeTable::place(const SampleSpan& span, double delay_s, const PulseClock& clock) const {
  const double u_s = pulse_->from_middle_s(grid_.time_s(span.begin) - delay_s);
  const double after = (grid_.time_s(span.begin) - delay_s + pulse_->lead_s - origin_s_) / grid_.interval_s -
                       clock.late(u_s) / grid_.interval_s;
  // A band-limited pulse is smooth there and continues before its beginning; an edge is decided by the patch of a cell.
  const double cell = std::max(std::floor(after), pulse_->band_limited ? 0.0 : -1.0);
  const double fraction = (after - cell) * double_of(parts_);
  const double part = std::clamp(std::floor(fraction), 0.0, double_of(parts_ - 1));
  ShapePlace place;
  place.delay_s = delay_s;
  place.clock = clock;
  place.sample = span.begin;
  place.count = span.end - span.begin;
  place.cell = static_cast<std::size_t>(cell + double_of(front));
  place.part = static_cast<std::size_t>(part);
  place.y = 2.0 * (fraction - part) - 1.0;
  place.position = after;
  if (!clock.ticks_evenly()) follow_stretch(u_s, place);
  return place;
}

// Cuts the samples where they leave the part, or where an uneven stretch leaves a straight line by 1e-9 of an interval.
void ShapeTable::follow_stretch(double u_s, ShapePlace& place) const {
  auto most = static_cast<double>(place.count);
  if (place.clock.dilation_rate != 0.0)
    most = std::min(most, std::sqrt(2e-9 / (std::abs(place.clock.dilation_rate) * grid_.interval_s)));
  const double middle_s = u_s + 0.5 * most * grid_.interval_s;
  place.drift = -(place.clock.doppler + place.clock.dilation_rate * middle_s);
  place.y_step = 2.0 * double_of(parts_) * place.drift;
  if (place.y_step > 0.0) most = std::min(most, (1.0 - place.y) / place.y_step + 1.0);
  if (place.y_step < 0.0) most = std::min(most, (1.0 + place.y) / -place.y_step + 1.0);
  place.count = static_cast<std::size_t>(std::max(1.0, std::floor(most)));
}

void ShapeTable::tabulate_pieces() {
  pieces_.emplace(pulse_->pulse, grid_.interval_s);
  const double tolerance = pieces_->largest() * (single_precision_ ? 4e-8 : 2e-12);
  Fits fits(1, cells_);
  for (std::size_t cell = front - 1; cell < cells_ && double_of(cell) - front < last_; ++cell) {
    const double begin = double_of(cell) - front;
    const Patch patch{cell, pieces_->piece_at(begin - sharp_reach), pieces_->piece_at(begin + 1.0 + sharp_reach) + 1};
    FitTerms values;
    for (std::size_t k = 0; k < fit_terms; ++k) {
      const double position = begin + 0.5 * (1.0 + fit_nodes()[k]);
      values[k] = pieces_->value(pieces_->piece_at(position, patch.first_piece, patch.last_piece), position);
    }
    fits.series[cell] = chebyshev_series(values);
    fits.degree[cell] = degree_within(fits.series[cell], tolerance);
    if (cell < front || !fits_pieces(patch, powers_of(fits.series[cell], fits.degree[cell]), tolerance))
      fits.degree[cell] = fit_terms;
    patches_.push_back(patch);
  }
  choose_degree(fits);
  std::erase_if(patches_, [&](const Patch& patch) { return fits.degree[patch.cell] <= degree_; });
  find_constant(fits);
  single_precision_ ? store(fits, single_) : store(fits, double_);
}

// Whether one polynomial will do for a cell that several pieces may share: their borders and the ends of the cell are
// where it would show.
bool ShapeTable::fits_pieces(const Patch& patch, const FitTerms& powers, double tolerance) const {
  const double begin = double_of(patch.cell) - front;
  const auto deviates = [&](std::size_t piece, double position) {
    const std::complex<double> fitted = polynomial(powers, 2.0 * (position - begin) - 1.0);
    return !(std::abs(fitted - pieces_->value(piece, position)) <= tolerance);
  };
  for (std::size_t k = patch.first_piece; k < patch.last_piece; ++k) {
    if (pieces_->is_only_exact(k) || (k > patch.first_piece && pieces_->is_sharp(k))) return false;
    const double from = std::max(begin, pieces_->border(k));
    const double to = std::min(begin + 1.0, pieces_->border(k + 1));
    if (from <= to && (deviates(k, from) || deviates(k, 0.5 * (from + to)) || deviates(k, to))) return false;
  }
  return true;
}

// More terms for all cells or patches for some: whatever takes less time.
void ShapeTable::choose_degree(const Fits& fits) {
  constexpr double term_ns = 0.04;
  constexpr double patch_ns = 5.0;
  std::array<double, fit_terms + 1> count{};
  for (const Patch& patch : patches_) count[fits.degree[patch.cell]] += 1.0;
  double patched = double_of(patches_.size());
  double least = 0.0;
  for (std::size_t degree = 0; degree < fit_terms; ++degree) {
    patched -= count[degree];
    const double cost = double_of(patches_.size()) * term_ns * double_of(degree + 1) + patched * patch_ns;
    if (degree == 0 || cost < least) {
      least = cost;
      degree_ = degree;
    }
  }
}

void ShapeTable::find_constant(const Fits& fits) {
  if (complex_) return;
  const double tolerance = pieces_->largest() * 1e-14;
  std::size_t begin = front;
  for (std::size_t cell = front; cell <= cells_; ++cell) {
    const auto same = [&](std::size_t c) {
      return fits.degree[c] == 0 && fits.degree[begin] == 0 &&
             std::abs(fits.series[c][0] - fits.series[begin][0]) <= tolerance;
    };
    if (cell < cells_ && same(cell)) continue;
    if (cell - begin > std::max(constant_.end - constant_.begin, shortest_constant))
      constant_ = {fits.series[begin][0].real(), begin, cell};
    begin = cell;
  }
}

// Four parts suit pulses that fill the sampled band; wider ones need more.
void ShapeTable::tabulate_band_limited() {
  const BandLimitedPulse& pulse = *pulse_->band_limited;
  std::vector<std::complex<double>> samples(cells_ - front);
  pulse.values(origin_s_, samples);
  double largest = 0.0;
  for (const auto& sample : samples) largest = std::max(largest, std::abs(sample));
  const double tolerance = largest * (single_precision_ ? 4e-8 : 2e-12);
  const std::size_t wanted_degree = single_precision_ ? 8 : fit_terms - 2;
  // Short pulses may take what long ones have no room for.
  const std::size_t max_parts = std::clamp<std::size_t>(65536 / cells_, 32, 512);
  for (parts_ = 4;; parts_ *= 2) {
    const Fits fits = fit_band_limited(parts_, tolerance);
    degree_ = std::min(*std::ranges::max_element(fits.degree), fit_terms - 1);
    if (degree_ > wanted_degree && parts_ < max_parts) continue;
    single_precision_ ? store(fits, single_) : store(fits, double_);
    break;
  }
  fit_tail(tolerance);
}

ShapeTable::Fits ShapeTable::fit_band_limited(std::size_t parts, double tolerance) const {
  const BandLimitedPulse& pulse = *pulse_->band_limited;
  Fits fits(parts, cells_);
  std::vector<std::complex<double>> values(cells_ - front);
  for (std::size_t part = 0; part < parts; ++part) {
    for (std::size_t k = 0; k < fit_terms; ++k) {
      const double x = (double_of(part) + 0.5 * (1.0 + fit_nodes()[k])) / double_of(parts);
      pulse.values(origin_s_ + x * grid_.interval_s, values);
      for (std::size_t n = 0; n < values.size(); ++n) fits.series[fits.index(part, front + n)][k] = values[n];
    }
    for (std::size_t n = 0; n < values.size(); ++n) {
      const std::size_t i = fits.index(part, front + n);
      // Where the pulse is cut only its tail matters.
      const double end = double_of(n) + double_of(part + 1) / double_of(parts);
      fits.series[i] = end > last_ ? FitTerms{} : chebyshev_series(fits.series[i]);
      fits.degree[i] = degree_within(fits.series[i], tolerance);
    }
  }
  return fits;
}

// The part of a cell in which the pulse ends.
void ShapeTable::fit_tail(double tolerance) {
  const double units = last_ * double_of(parts_);
  const double unit = std::floor(units);
  Tail tail;
  tail.begin = unit / double_of(parts_);
  tail.end = last_ - end_tolerance;
  if (tail.end <= tail.begin) return;
  tail.cell = static_cast<std::size_t>(std::floor(tail.begin)) + front;
  tail.part = static_cast<std::size_t>(unit) % parts_;
  FitTerms values;
  for (std::size_t k = 0; k < fit_terms; ++k) {
    const double position = tail.begin + 0.5 * (1.0 + fit_nodes()[k]) * (tail.end - tail.begin);
    values[k] = pulse_->band_limited->value(origin_s_ + position * grid_.interval_s);
  }
  const FitTerms series = chebyshev_series(values);
  tail.powers = powers_of(series, degree_within(series, 1e-3 * tolerance));
  tail_ = tail;
}

template <class T>
void ShapeTable::store(const Fits& fits, std::vector<Block<T>>& blocks) const {
  const std::size_t halves = complex_ ? 2 : 1;
  blocks.resize(fits.parts * fits.cells / cells_per_block * halves * (degree_ + 1));
  for (std::size_t part = 0; part < fits.parts; ++part)
    for (std::size_t cell = front; cell < fits.cells; ++cell) {
      const std::size_t i = fits.index(part, cell);
      if (fits.degree[i] > degree_) continue;
      const FitTerms powers = powers_of(fits.series[i], degree_);
      Block<T>* const block = blocks.data() + block_index(part, cell);
      const std::size_t lane = cell % cells_per_block;
      for (std::size_t d = 0; d <= degree_; ++d) {
        block[d].value[lane] = static_cast<T>(powers[d].real());
        if (complex_) block[degree_ + 1 + d].value[lane] = static_cast<T>(powers[d].imag());
      }
    }
}

template <class T>
void ShapeTable::patch(const ShapePlace& place, std::size_t first_cell, T* re, T* im) const {
  const auto put = [&](std::size_t cell, std::complex<double> value) {
    re[cell - first_cell] = static_cast<T>(value.real());
    if (complex_) im[cell - first_cell] = static_cast<T>(value.imag());
  };
  const std::size_t end = place.cell + place.count;
  if (tail_ && tail_->part == place.part && tail_->cell >= place.cell && tail_->cell < end) {
    const double position = place.position + double_of(tail_->cell - place.cell) * (1.0 + place.drift);
    put(tail_->cell, polynomial(tail_->powers, 2.0 * (position - tail_->begin) / (tail_->end - tail_->begin) - 1.0));
  }
  for (auto patch = std::ranges::lower_bound(patches_, place.cell, {}, &Patch::cell);
       patch != patches_.end() && patch->cell < end; ++patch)
    put(patch->cell, patched(*patch, place));
}

template void ShapeTable::patch(const ShapePlace&, std::size_t, float*, float*) const;
template void ShapeTable::patch(const ShapePlace&, std::size_t, double*, double*) const;

std::complex<double> ShapeTable::patched(const Patch& patch, const ShapePlace& place) const {
  const std::size_t offset = patch.cell - place.cell;
  const double position = std::max(0.0, place.position + double_of(offset) * (1.0 + place.drift));
  const std::size_t piece = pieces_->piece_at(position, patch.first_piece, patch.last_piece);
  if (!pieces_->is_in_doubt(piece, position)) return pieces_->value(piece, position);
  const double after_edge_s = grid_.time_s(place.sample + offset) - place.delay_s + pulse_->lead_s;
  return pieces_->exact(std::max(0.0, after_edge_s - place.clock.late(after_edge_s - 0.5 * pulse_->pulse.width_s)));
}

}  // namespace sarsim::radar
