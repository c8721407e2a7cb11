#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/os/output_file.hpp"
#include "raster/cphd/block_file.hpp"
#include "raster/cphd/cphd_description.hpp"
#include "raster/cphd/cphd_writer.hpp"

namespace sarsim::raster {

/// A number in two parts, whole and broken, as CRSD keeps times and phases.
struct IntFrac {
  std::int64_t whole = 0;
  double part = 0.0;  ///< In [0, 1).

  /// Both parts of a number.
  [[nodiscard]] static IntFrac of(double value);
};

/// What CRSD says of one pulse and of the row that was recorded after it. Places and directions are Earth-fixed (ECF).
struct ReceivedPulse {
  double tx_time_s = 0.0;  ///< When the middle of the pulse leaves, after the reference time of the collection.
  core::Vec3 tx_m, tx_mps;
  core::Vec3 tx_x, tx_y;       ///< Axes of the antenna as the pulse leaves, length 1.
  double carrier_hz = 0.0;     ///< Of pulse and receiver; its phase is 0 at the middle of the pulse.
  double rate_hz_per_s = 0.0;  ///< Of the chirp.
  double rcv_start_s = 0.0;    ///< Time of the first sample.
  double phase_cycles = 0.0;   ///< Of the receiver's reference at the first sample.
  core::Vec3 rcv_m, rcv_mps;   ///< Of the receiver then,
  core::Vec3 rcv_x, rcv_y;     ///< and the axes of its antenna.
};

/// What the XML of a CRSD file says: a sequence of pulses and one channel that records them.
struct CrsdDescription {
  std::string name;    ///< Of the product.
  std::string sensor;  ///< Name of the radar.
  std::string mode = "STRIPMAP";
  std::vector<std::pair<std::string, std::string>> parameters = {};
  std::string start;  ///< UTC of time 0, ISO 8601.
  SceneCoordinates scene;
  SignalEncoding encoding = SignalEncoding::cf8;
  std::size_t pulses = 0;     ///< And rows.
  std::size_t samples = 0;    ///< Of a row.
  std::size_t reference = 0;  ///< Number of the reference pulse and row.
  double tx_time1_s = 0.0, tx_time2_s = 0.0;
  double rcv_start1_s = 0.0, rcv_start2_s = 0.0;
  double min_carrier_hz = 0.0, max_carrier_hz = 0.0;
  double band_hz = 0.0;  ///< Of the pulse.
  double width_s = 0.0;  ///< Of the pulse.
  double sample_rate_hz = 0.0;
  double reference_carrier_hz = 0.0;
  double noise_w = 0.0;        ///< Power of the noise of a sample.
  AreaPlane centre_time_s;     ///< When each point of the area is seen, and
  double dwell_s = 0.0;        ///< for how long.
  ReferenceGeometry geometry;  ///< Of transmitter and receiver, as of bistatic collections.
  PlatformGeometry middle;     ///< Of the point between the two.
  double tx_squint_deg = 0.0, rcv_squint_deg = 0.0, middle_squint_deg = 0.0;
};

/// The XML of a file, with the elements in the order of the schema.
[[nodiscard]] std::string crsd_xml(const CrsdDescription& description);

/// Writes a CRSD 1.0 file (CRSDsar), row by row (docs/formats/crsd.md): one sequence of pulses, one channel, an antenna
/// of the same gain everywhere. The file appears under its name with `finish`; destroyed before, it leaves nothing.
class CrsdWriter {
 public:
  /// Begins the file. std::system_error where it cannot be made, or is a pipe.
  CrsdWriter(const std::filesystem::path& path, CrsdDescription description, bool replace);

  /// A row as bytes; integers are scaled as in CPHD.
  [[nodiscard]] EncodedVector encode(const ReceivedPulse& pulse, std::size_t row,
                                     std::span<const std::complex<double>> samples) const;
  /// The parameters of a pulse as bytes.
  [[nodiscard]] std::vector<std::byte> pulse_bytes(const ReceivedPulse& pulse) const;
  /// Adds the next pulse with its row; std::logic_error where one has another size or there are too many.
  void append(std::span<const std::byte> pulse, const EncodedVector& row);
  /// Gives the file its name; std::logic_error where rows are missing.
  void finish();

 private:
  void write_support();

  core::OutputFile file_;
  CrsdDescription description_;
  FileBlock support_, ppp_, pvp_, signal_;
  std::size_t signal_bytes_ = 0;  // of a row
  std::size_t written_ = 0;
};

}  // namespace sarsim::raster
