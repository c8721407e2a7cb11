#pragma once

#include <optional>

#include "radar/atmosphere/gas_profile.hpp"
#include "radar/atmosphere/ionosphere.hpp"
#include "radar/atmosphere/rain.hpp"
#include "radar/atmosphere/refractivity.hpp"
#include "radar/atmosphere/straight_path.hpp"

namespace sarsim::radar {

/// How refractivity depends on height.
enum class Refraction {
  none,         ///< The air is as quick as vacuum.
  exponential,  ///< ExponentialRefractivity.
  linear,       ///< LinearRefractivity, its gradient by the factor k.
};

/// What lies between a radar and what it sees. As it is made nothing does: each part is switched on by itself.
struct Atmosphere {
  Refraction refraction = Refraction::none;
  double surface_refractivity = 315.0;  ///< N0 at height 0; both models.
  double scale_height_m = 7350.0;       ///< Refraction::exponential.
  double k_factor = 4.0 / 3.0;          ///< Refraction::linear; above 1.

  bool gases = false;                                            ///< Loss in the reference atmosphere of ITU-R P.835.
  double surface_vapour_kg_per_m3 = reference_vapour_kg_per_m3;  ///< Water vapour at height 0.

  double rain_rate_mm_per_h = 0.0;     ///< Uniform rain; 0: none.
  double rain_top_m = 5000.0;          ///< Rain height.
  double polarisation_tilt_rad = 0.0;  ///< From the horizontal: 0 H, pi/2 V, pi/4 also for circular.

  double vertical_tec_per_m2 = 0.0;              ///< Electron content between ground and radar; 0: no ionosphere.
  double shell_height_m = usual_shell_height_m;  ///< Where all electrons are.
  double field_along_path_t = 0.0;               ///< Magnetic field component along the path, for Faraday rotation.

  friend constexpr bool operator==(const Atmosphere&, const Atmosphere&) = default;
};

/// What a path through the atmosphere does to a wave, one way.
struct PathEffect {
  double delay_m = 0.0;      ///< Excess of the group path over the straight distance: air and ionosphere.
  double phase_m = 0.0;      ///< Excess of the phase path: air less ionosphere.
  double loss_db = 0.0;      ///< Gases and rain; never negative.
  double faraday_rad = 0.0;  ///< Rotation of linear polarisation; adds up on the way back.
};

/// An atmosphere at one frequency, ready for many paths. Safe to share between threads.
class AtmosphereModel {
 public:
  /// Takes 2 ms with gases. The frequency, the scale height and N0 are positive, k is above 1.
  AtmosphereModel(const Atmosphere& atmosphere, double carrier_hz);

  /// All of a path's effects: 0.3 us inside the air, 4 us to space; with gases 1 and 16 us. A path of length 0 has
  /// none. Accuracy of the delay as `excess_path_m`; errors of the straight line are said there.
  [[nodiscard]] PathEffect effect(const StraightPath& path) const;

  /// The parts: excess path in air, m.
  [[nodiscard]] double air_m(const StraightPath& path) const;
  /// Loss by gases, dB.
  [[nodiscard]] double gas_db(const StraightPath& path) const;
  /// Adds ionosphere and rain to an effect: closed forms.
  void add_closed_forms(const StraightPath& path, PathEffect& effect) const;

  [[nodiscard]] const Atmosphere& atmosphere() const { return atmosphere_; }
  /// The refractivity where the model is exponential.
  [[nodiscard]] ExponentialRefractivity exponential() const {
    return {atmosphere_.surface_refractivity, atmosphere_.scale_height_m};
  }
  /// The gases where they are on.
  [[nodiscard]] const std::optional<GasProfile>& gases() const { return gases_; }

 private:
  Atmosphere atmosphere_;
  double carrier_hz_;
  std::optional<GasProfile> gases_;
  RainLaws rain_laws_;
};

/// The effects of one path; for many paths use AtmosphereModel or AtmosphereTable.
[[nodiscard]] PathEffect path_effect(const Atmosphere& atmosphere, double carrier_hz, const StraightPath& path);

}  // namespace sarsim::radar
