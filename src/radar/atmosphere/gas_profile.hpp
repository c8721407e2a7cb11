#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "radar/atmosphere/reference_atmosphere.hpp"
#include "radar/atmosphere/straight_path.hpp"

namespace sarsim::radar {

/// The specific attenuation of one frequency in the reference atmosphere, ready for many paths: polynomials of height
/// of degree 8 for each of 36 layers. Error 5e-6 of the value up to 18 km, where the laws of the reference atmosphere
/// meet to that only; up to 1e-5 of the layer's largest value above, but 3e-2 from 22 to 25 km near lines of vapour,
/// whose floor begins there: 1e-5 of the whole column at most. Made in about 2 ms.
class GasProfile {
 public:
  /// @param lowest_m  down to this height, where it is below 0; what is deeper counts as being there
  explicit GasProfile(double carrier_hz, double surface_vapour_kg_per_m3 = reference_vapour_kg_per_m3,
                      double lowest_m = -2000.0);

  /// Specific attenuation at a height, dB/m; 0 above the atmosphere.
  [[nodiscard]] double value(double height_m) const;
  /// Its integral from the lowest height up to a height, dB.
  [[nodiscard]] double column_db(double height_m) const;
  /// End of a panel of quadrature.
  [[nodiscard]] double next_break_m(double height_m) const { return next_reference_break_m(height_m); }

 private:
  static constexpr std::size_t terms = 9;
  struct Piece {
    double middle_m = 0.0;
    double half_m = 1.0;
    double column_db = 0.0;  // below it
    std::array<double, terms> powers{};
  };
  [[nodiscard]] const Piece* piece_at(double height_m) const;

  std::vector<double> tops_m_;
  std::vector<Piece> pieces_;
  double lowest_m_;
};

/// One-way loss over a straight path in the reference atmosphere, dB: integral of the specific attenuation.
/// Against the bent ray of `slant_gas_loss_db`, which stays in the low air for longer where both leave the ground at
/// the same elevation, it is short by 0.03 % at 30 deg, 0.3 % at 10 deg, 1 % at 5 deg and 7 % at 1 deg.
[[nodiscard]] double gas_loss_db(const GasProfile& profile, const StraightPath& path);

}  // namespace sarsim::radar
