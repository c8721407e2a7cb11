#pragma once

#include <string>

namespace sarsim::scene {

/// How a file of samples is laid out (docs/formats).
enum class FileFormat { ascii, binary, bracket, hdf5, csv, npy, zarr, sigmf };

/// What is done to the received samples before the A/D converter.
enum class Processing { raw, matched_filter, srp };

/// A recording to be made (script `$SIMULATION`, thesis 4.5).
struct Simulation {
  /// Which part of an echo stands at its target's range.
  enum class PulsePosition { begin, centre };

  std::string radar;
  double range_start_m = 0.0;  ///< One way.
  double range_end_m = 0.0;
  double time_start_s = 0.0;
  double time_end_s = 0.01;
  int bits = 8;
  double sample_rate_hz = 0.0;
  double lsb_v = 0.0;  ///< 0: estimated from the largest magnitude.
  FileFormat format = FileFormat::binary;
  Processing processing = Processing::raw;
  std::string file = "sim1.bin";
  PulsePosition pulse_position = PulsePosition::begin;
  double oversampling = 1.0;  ///< Above 1 a band-limited pulse keeps only its nominal bandwidth.
  /// Kept length of such a pulse, in pulse widths. 0: all of it; in the classic profile, its nominal length.
  double width_factor = 0.0;

  friend bool operator==(const Simulation&, const Simulation&) = default;
};

/// A table of delays, amplitudes and speeds to be made (script `$GEOMETRY`, thesis 4.10).
struct GeometryTable {
  /// What stands between the columns of the table.
  enum class Separator { space, comma };

  std::string radar;
  double range_start_m = 0.0;
  double range_end_m = 100e3;
  double time_start_s = 0.0;
  double time_end_s = 0.1;
  Separator separator = Separator::space;
  int columns = 227;  ///< Sum of column bits, docs/formats/geometry-table.md.
  std::string file = "geo1.txt";

  friend bool operator==(const GeometryTable&, const GeometryTable&) = default;
};

}  // namespace sarsim::scene
