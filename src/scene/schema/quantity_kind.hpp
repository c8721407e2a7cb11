#pragma once

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

inline constexpr Quantity every_quantity[] = {
    Quantity::number,     Quantity::length, Quantity::time,         Quantity::frequency, Quantity::angle,
    Quantity::angle_rate, Quantity::area,   Quantity::power,        Quantity::ratio_db,  Quantity::temperature,
    Quantity::voltage,    Quantity::speed,  Quantity::acceleration, Quantity::count};

}  // namespace sarsim::scene
