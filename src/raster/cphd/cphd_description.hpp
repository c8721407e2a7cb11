#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/maths/vector.hpp"
#include "radar/earth/ellipsoid.hpp"
#include "raster/cphd/phase_vector.hpp"

namespace sarsim::raster {

/// A polynomial in the two coordinates of the image area: constant + x_slope x + y_slope y.
struct AreaPlane {
  double constant = 0.0;
  double x_slope = 0.0;
  double y_slope = 0.0;
};

/// A rectangle of the image area, m along its axes.
struct AreaRectangle {
  double x1 = 0.0, y1 = 0.0;  ///< The lower ends,
  double x2 = 0.0, y2 = 0.0;  ///< and the upper ones.
};

/// Where what is imaged lies: a point with two axes, at right angles, in the plane through it.
struct SceneCoordinates {
  core::Vec3 origin_m;  ///< IARP, ECF.
  core::Vec3 x_axis;    ///< uIAX, ECF, length 1.
  core::Vec3 y_axis;    ///< uIAY.
  bool planar = true;   ///< The surface is that plane; otherwise one of constant height over the ellipsoid, which it
                        ///< touches.
  AreaRectangle area;
  double x_step_m = 0.0;  ///< Of the grid that is proposed for an image; 0: none.
  double y_step_m = 0.0;
};

/// One channel: how its vectors and samples are stored, and what holds for all of them.
struct PhaseChannel {
  std::string id;
  std::size_t vectors = 0;
  std::size_t samples = 0;          ///< Of a vector.
  std::uint64_t signal_offset = 0;  ///< In the block of signals, bytes.
  std::uint64_t pvp_offset = 0;     ///< In the block of parameters.
  std::size_t reference = 0;        ///< Number of the reference vector.
  bool fx_fixed = true;             ///< All vectors have the same band,
  bool toa_fixed = true;            ///< the same times of arrival,
  bool srp_fixed = true;            ///< the same reference point.
  std::string transmitted = "V";    ///< Polarisations.
  std::string received = "V";
  double centre_hz = 0.0;  ///< FxC: middle of the band of all vectors,
  double band_hz = 0.0;    ///< FxBW: and its width.
  double toa_s = 0.0;      ///< TOASaved: longest of TOA2 - TOA1.
};

/// Angles of a platform, or of the bisector of two, as seen from the reference point. Degrees.
struct PlatformGeometry {
  double time_s = 0.0;
  core::Vec3 position_m, velocity_mps;
  char side = 'L';  ///< Of the track on which the reference point lies: L or R.
  double slant_range_m = 0.0;
  double ground_range_m = 0.0;  ///< Along a sphere through the reference point.
  double doppler_cone_deg = 90.0;
  double graze_deg = 0.0;
  double incidence_deg = 0.0;
  double azimuth_deg = 0.0;
};

/// ReferenceGeometry: angles at the reference vector of the reference channel.
struct ReferenceGeometry {
  core::Vec3 srp_m;          ///< ECF.
  core::Vec3 srp_in_area_m;  ///< In the coordinates of the image area.
  double time_s = 0.0;
  double centre_time_s = 0.0;  ///< Middle of the time during which the point is seen, and how long that is.
  double dwell_s = 0.0;
  bool bistatic = false;
  PlatformGeometry platform;  ///< Monostatic: the antenna. Bistatic: the transmitter,
  PlatformGeometry receiver;  ///< and the receiver.
  double graze_deg = 0.0;     ///< Bistatic, of the bisector, as the following two.
  double azimuth_deg = 0.0;
  double azimuth_rate_deg_per_s = 0.0;
  double bistatic_deg = 0.0;
  double bistatic_rate_deg_per_s = 0.0;
  double twist_deg = 0.0;  ///< Of the image plane, for both kinds.
  double slope_deg = 0.0;
  double layover_deg = 0.0;
};

/// The transmitted pulse, for TxRcv.
struct TransmittedPulse {
  double width_s = 0.0;
  double band_hz = 0.0;
  double rate_hz_per_s = 0.0;  ///< Of a chirp; 0: none.
  double window_s = 0.0;       ///< Of reception.
  double sample_rate_hz = 0.0;
  double carrier_hz = 0.0;
};

/// What the XML of a CPHD file says, as far as we write or use it.
struct CphdDescription {
  std::string version = "1.1.0";
  std::string collector;         ///< Of the sensor: the radar's name.
  std::string illuminator = {};  ///< Bistatic: of the transmitter.
  std::string core_name;         ///< Of the collection.
  bool bistatic = false;
  std::string mode = "SPOTLIGHT";  ///< RadarMode: SPOTLIGHT, STRIPMAP or DYNAMIC STRIPMAP.
  std::string classification = "UNCLASSIFIED";
  std::string release = "UNRESTRICTED";
  std::vector<std::pair<std::string, std::string>> parameters = {};  ///< Names and values of anything else.
  PhaseDomain domain = PhaseDomain::fx;
  int sign = -1;      ///< SGN: of the phase -+2 pi f delay.
  std::string start;  ///< UTC of time 0, ISO 8601.
  double tx_time1_s = 0.0, tx_time2_s = 0.0;
  double fx_min_hz = 0.0, fx_max_hz = 0.0;
  double toa_min_s = 0.0, toa_max_s = 0.0;
  SceneCoordinates scene;
  SignalEncoding encoding = SignalEncoding::cf8;
  std::size_t pvp_bytes = 0;                       ///< Of a vector.
  std::vector<PhaseChannel> channels;              ///< At least one.
  std::size_t reference_channel = 0;               ///< Number of it.
  AreaPlane centre_time_s;                         ///< When each point of the area is seen, and
  double dwell_s = 0.0;                            ///< for how long.
  std::optional<ReferenceGeometry> geometry = {};  ///< Not read.
  std::optional<TransmittedPulse> pulse = {};      ///< Not read.
};

/// Where the parameters of our files stand in a vector: those of `pvp_fields`, one after the other.
struct PvpSlot {
  const PvpField* field = nullptr;
  std::size_t offset = 0;  ///< Bytes.
};

/// The slots of our files and the bytes of a vector; integers need AmpSF, floats do without.
[[nodiscard]] std::pair<std::vector<PvpSlot>, std::size_t> pvp_slots(SignalEncoding encoding);

/// The XML of a file, with the elements in the order of the schema.
[[nodiscard]] std::string cphd_xml(const CphdDescription& description);

}  // namespace sarsim::raster
