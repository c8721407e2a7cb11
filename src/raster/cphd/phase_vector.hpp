#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/maths/vector.hpp"

namespace sarsim::raster {

/// In what the samples of a phase history are counted.
enum class PhaseDomain {
  fx,   ///< Frequencies, Hz: sample k stands at f = SC0 + k SCSS.
  toa,  ///< Times of arrival after that of the reference point, s.
};

/// How a sample of a CPHD file is stored, big-endian, I before Q.
enum class SignalEncoding {
  cf8,  ///< Two floats.
  ci4,  ///< Two 16-bit integers, times AmpSF of their vector.
  ci2,  ///< Two 8-bit integers, times AmpSF of their vector.
};

/// All encodings with the words that XML has for them and their bytes.
struct SignalEncodingName {
  SignalEncoding encoding;
  std::string_view name;  ///< In XML: "CF8".
  std::size_t bytes;      ///< Of a sample.
  double largest;         ///< Magnitude of I or Q that integers hold; 0 for floats.
};
inline constexpr std::array<SignalEncodingName, 3> signal_encodings{{{SignalEncoding::cf8, "CF8", 8, 0.0},
                                                                     {SignalEncoding::ci4, "CI4", 4, 32767.0},
                                                                     {SignalEncoding::ci2, "CI2", 2, 127.0}}};
/// What there is to know of an encoding.
[[nodiscard]] const SignalEncodingName& entry_of(SignalEncoding encoding);

/// What CPHD says of one vector (one pulse): where transmitter, receiver and reference point are, and what its samples
/// are. A receiver elsewhere (bistatic) is nothing but other numbers. Places and velocities are Earth-fixed (ECF).
struct PhaseVector {
  double tx_time_s = 0.0;  ///< When the middle of the pulse leaves, after the start of the collection.
  core::Vec3 tx_m, tx_mps;
  double rcv_time_s = 0.0;  ///< When that echo of the reference point arrives.
  core::Vec3 rcv_m, rcv_mps;
  core::Vec3 srp_m;                   ///< The reference point, to which phases and times of arrival are relative.
  double amplitude = 1.0;             ///< AmpSF: what samples are multiplied by.
  double doppler = 0.0;               ///< aFDOP: -(rate of the path)/c.
  double rate1 = 0.0;                 ///< aFRR1: 2 fc/(c K) of a chirp of rate K; 0 of others.
  double rate2 = 0.0;                 ///< aFRR2: 2/(c K).
  double fx1_hz = 0.0, fx2_hz = 0.0;  ///< Band that is kept.
  double toa1_s = 0.0, toa2_s = 0.0;  ///< Times of arrival of targets whose echoes are there as a whole.
  double tropo_s = 0.0;               ///< TDTropoSRP: delay of the troposphere to the reference point.
  double first = 0.0;                 ///< SC0: frequency (Hz) or time of arrival (s) of the first sample.
  double step = 0.0;                  ///< SCSS: of the next ones.
  std::int64_t signal = 1;            ///< 0: there is no signal, and samples are 0.

  /// Sum of the ways to the reference point, m.
  [[nodiscard]] double reference_way_m() const { return core::norm(tx_m - srp_m) + core::norm(rcv_m - srp_m); }
};

/// One parameter of each vector: its name in XML and where the numbers of a PhaseVector go.
struct PvpField {
  std::string_view name;
  std::size_t words;  ///< Of 8 bytes: 1 or 3.
  bool optional;      ///< XML may leave it out.
  double PhaseVector::*number = nullptr;
  core::Vec3 PhaseVector::*place = nullptr;
  std::int64_t PhaseVector::*integer = nullptr;
};

/// The parameters that we write and read, in the order of the standard. Others may stand in a file.
[[nodiscard]] std::span<const PvpField> pvp_fields();

/// Writes the words of a field, big-endian, to the `field.words * 8` bytes at `to`.
void put_pvp(const PvpField& field, const PhaseVector& vector, std::byte* to);
/// Reads them back.
void get_pvp(const PvpField& field, const std::byte* from, PhaseVector& vector);

}  // namespace sarsim::raster
