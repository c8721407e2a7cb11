#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/task/sample_rows.hpp"
#include "radar/earth/earth_frame.hpp"
#include "radar/earth/instant.hpp"
#include "raster/cphd/cphd_description.hpp"
#include "simulate/plan/acquisition.hpp"
#include "simulate/plan/pulse_geometry.hpp"
#include "workflow/input/recording_input.hpp"

namespace sarsim::workflow {

/// What the phases of a vector are relative to.
struct ReferencePoint {
  enum class Kind {
    fixed,   ///< One point: the middle of the scene.
    moving,  ///< The middle of the scene, carried along with the flight: of strips.
    given,   ///< One point that the user names.
  };
  Kind kind = Kind::fixed;
  core::Vec3 given_world_m{};  ///< Kind::given.
};

/// Reads "fixed", "moving" or "X,Y,Z" in m of the world; throws core::InvalidRequest for anything else.
[[nodiscard]] ReferencePoint reference_point_from(const std::string& text);
/// A recording of raw pulses with its place on the Earth: what CPHD and CRSD files are made of.
struct Collection {
  std::shared_ptr<const simulate::Acquisition> acquisition;  ///< Raw pulses of the physical profile.
  core::SampleRows<double> rows;                             ///< Of the plan, V.
  bool computed = true;     ///< The rows are computed from a scene; otherwise they were recorded.
  radar::EarthFrame earth;  ///< Under the world.
  bool flat = true;         ///< The world is a plane, laid on the Earth at the anchor.
  radar::Instant start;     ///< Time 0 of the file,
  double start_s = 0.0;     ///< and in slow time.
  ReferencePoint reference;
  std::string name;  ///< Of the file.
  std::size_t simulation = 0;
  std::vector<std::filesystem::path> sources;

  /// The moment as ISO 8601.
  [[nodiscard]] std::string start_text() const;
};

/// What the user asks of a collection.
struct CollectionArguments {
  RecordingArguments input;
  std::string format;  ///< That is written, for messages: "CPHD".
  ReferencePoint reference;
  std::optional<radar::Anchor> anchor;  ///< Of a flat world; that over the Earth has its own.
};

/// Opens a scene, whose echoes are then computed when they are asked for, or a recording.
/// A scene is recorded raw, with band-limited pulses unless the arguments say otherwise, and longer by a pulse, so that
/// the echoes at the end of its window are there as a whole.
/// @param[in,out] remarks  gets warnings and notes
/// @throws core::InvalidRequest where the recording cannot be exchanged: other processing than raw, the classic
/// profile, an
///         anchor that is missing or given twice
[[nodiscard]] Collection open_collection(const CollectionArguments& arguments, const core::WorkControl& control,
                                         core::Problems& remarks);

/// One pulse of a collection.
struct CollectedPulse {
  raster::PhaseVector vector;  ///< Times, places, aFDOP, aFRR1, aFRR2; nothing of the samples yet.
  double delay_s = 0.0;        ///< Light time to the reference point and back.
  radar::PulseClock clock;     ///< How an echo from there is stretched.
  double carrier_hz = 0.0;
};

/// Where everything is as the pulses of a collection leave; each thread has its own.
class CollectionGeometry {
 public:
  /// Keeps a reference.
  explicit CollectionGeometry(const Collection& collection);
  CollectionGeometry(const CollectionGeometry&) = delete;
  CollectionGeometry& operator=(const CollectionGeometry&) = delete;
  ~CollectionGeometry();

  /// The pulse of a row.
  [[nodiscard]] CollectedPulse pulse_of(std::size_t row);
  /// The reference point of a row, world.
  [[nodiscard]] core::Vec3 reference_m(std::size_t row);

 private:
  struct Reference;

  const Collection* collection_;
  std::unique_ptr<Reference> reference_;  // A scene of nothing but the reference point.
  core::Vec3 middle_m_;                   // Of the scene, world: the reference point of the middle pulse,
  core::Vec3 antenna_m_;                  // and where the antenna is then,
  core::Vec3 along_;                      // and the level direction of its flight.
  double height_m_ = 0.0;                 // Of the middle, over the ellipsoid.
};

}  // namespace sarsim::workflow
