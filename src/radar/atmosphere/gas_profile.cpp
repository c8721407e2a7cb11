#include "radar/atmosphere/gas_profile.hpp"

#include <algorithm>
#include <cmath>

#include "radar/atmosphere/gas.hpp"
#include "radar/atmosphere/path_integral.hpp"
#include "radar/atmosphere/polynomial_nodes.hpp"

namespace sarsim::radar {

namespace {

// Integral from -1 to y of a polynomial in powers of y.
template <std::size_t n>
double integral_of_powers(const std::array<double, n>& powers, double y) {
  double up = 0.0, down = 0.0;
  for (std::size_t k = n; k-- > 0;) {
    const double power = powers[k] / static_cast<double>(k + 1);
    up = (up + power) * y;
    down = -(down + power);
  }
  return up - down;
}

}  // namespace

GasProfile::GasProfile(double carrier_hz, double surface_vapour_kg_per_m3, double lowest_m) : lowest_m_(lowest_m) {
  double base_m = lowest_m, column_db = 0.0;
  while (base_m < reference_top_m) {
    const double top_m = next_reference_break_m(base_m);
    Piece piece{0.5 * (base_m + top_m), 0.5 * (top_m - base_m), column_db, {}};
    const auto& nodes = polynomial_nodes<terms>().y;
    std::array<double, terms> values{};
    for (std::size_t i = 0; i < terms; ++i) {
      const double height_m = piece.middle_m + piece.half_m * nodes[i];
      values[i] = gas_loss(carrier_hz, reference_air(height_m, surface_vapour_kg_per_m3)).sum_db_per_m();
    }
    piece.powers = powers_through(values);
    column_db += piece.half_m * integral_of_powers(piece.powers, 1.0);
    tops_m_.push_back(top_m);
    pieces_.push_back(piece);
    base_m = top_m;
  }
}

const GasProfile::Piece* GasProfile::piece_at(double height_m) const {
  const auto top = std::upper_bound(tops_m_.begin(), tops_m_.end(), height_m);
  return top == tops_m_.end() ? nullptr : &pieces_[static_cast<std::size_t>(top - tops_m_.begin())];
}

double GasProfile::value(double height_m) const {
  const Piece* piece = piece_at(height_m);
  if (piece == nullptr) return 0.0;
  return value_of_powers(piece->powers, (std::max(height_m, lowest_m_) - piece->middle_m) / piece->half_m);
}

double GasProfile::column_db(double height_m) const {
  if (height_m < lowest_m_) return (height_m - lowest_m_) * value(lowest_m_);
  const Piece* piece = piece_at(height_m);
  if (piece == nullptr)
    return pieces_.back().column_db + pieces_.back().half_m * integral_of_powers(pieces_.back().powers, 1.0);
  return piece->column_db +
         piece->half_m * integral_of_powers(piece->powers, (height_m - piece->middle_m) / piece->half_m);
}

double gas_loss_db(const GasProfile& profile, const StraightPath& path) {
  const Climb climb = climb_of(path);
  if (climb.curvature_per_m > 0.0) return integral_along(climb, profile);
  const double rise_m = climb.high_m - climb.low_m;
  if (rise_m < 1.0) return climb.length_m * profile.value(climb.low_m + 0.5 * rise_m);
  return climb.length_m / rise_m * (profile.column_db(climb.high_m) - profile.column_db(climb.low_m));
}

}  // namespace sarsim::radar
