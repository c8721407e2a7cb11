#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sarsim::scene {

/// What a number measures: which units may be typed, and which one is shown.
enum class Quantity {
  number,        ///< No unit.
  length,        ///< m: nm, um, mm, cm, m, km, ft, nmi, NM, mi, yd, in
  time,          ///< s: ps, ns, us, ms, s, min, h, day
  frequency,     ///< Hz, kHz, MHz, GHz, THz
  angle,         ///< Held in degrees: deg, rad, mrad, ', arcmin, arcsec, mil (of 6400), turn, rev
  angle_rate,    ///< Held in deg/s: deg/s, rad/s, rpm, deg/min, turn/min, turn/s, mrad/s, deg/h
  area,          ///< m2: m2, cm2, dBsm
  power,         ///< W: uW, mW, W, kW, MW, GW, dBW, dBm, dBkW
  ratio_db,      ///< Held in dB: dB, dBi, dBd, or a bare factor as "x100"
  temperature,   ///< K: K, degC
  voltage,       ///< V: nV, uV, mV, V, kV
  speed,         ///< m/s: m/s, km/s, km/h, kn, kt, ft/s, mph
  acceleration,  ///< m/s2: m/s2, g, mg, ug
  count,         ///< A whole number.
};

/// A value read from what was typed, in the unit in which the quantity is held, or why it could not be read, in words.
struct QuantityReading {
  std::optional<double> value;
  std::string failure;  ///< "'5 kg' is not a valid length; try m, km or mm"
};

/// Reads "50 MHz", "3us", "10 km", "1e3", "1,5" is refused with a hint at the point. Case matters only where it must
/// (mW and MW); "µ" counts as "u". A number without a unit is in `bare_unit`, one of the quantity's units; empty: the
/// base unit. Values outside double's range and NaN are failures.
[[nodiscard]] QuantityReading read_quantity(std::string_view text, Quantity quantity, std::string_view bare_unit = "");

/// Length of the decimal number at the beginning of a text: sign, digits with a point, exponent; 0 where there is none.
[[nodiscard]] std::size_t number_length(std::string_view text);

/// The value with the unit that suits its size: 5e7, frequency: "50 MHz". Reading it back gives exactly `value`.
[[nodiscard]] std::string quantity_text(double value, Quantity quantity);
/// Same with a given unit of the quantity; a unit that is not a power of ten of the base unit (ft, rad, dBm) gives the
/// nearest number, which need not read back exactly. std::invalid_argument for a unit that is none of the quantity's.
[[nodiscard]] std::string quantity_text(double value, Quantity quantity, std::string_view unit);

/// The units listed in messages, the base unit first; a few more may be typed (`unit_table`).
[[nodiscard]] std::vector<std::string_view> units_of(Quantity quantity);

/// Decimal exponent of a unit to the base unit: 9 for "GHz". std::invalid_argument for a unit that is none of the
/// quantity's or no power of ten of its base unit.
[[nodiscard]] int exponent_of(std::string_view unit, Quantity quantity);

}  // namespace sarsim::scene
