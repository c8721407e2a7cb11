#include "workflow/input/world_axes.hpp"

#include "radar/earth/celestial.hpp"
#include "scene/model/world_frame.hpp"

namespace sarsim::workflow {

WorldAxes::WorldAxes(const scene::World& world)
    : earth_(scene::earth_of(world)), epoch_(scene::epoch_of(world).instant), orientation_{world.dut1_s} {}

radar::StateVector WorldAxes::from_ecef(const radar::StateVector& state) const {
  if (!earth_) return state;
  return {earth_->world_from_ecef(state.position_m), earth_->world_axes_from_ecef(state.velocity_mps)};
}

radar::TurningFrame WorldAxes::ecef_from(scene::Frame frame, double time_s) const {
  constexpr core::Mat3 same{{core::Vec3{1.0, 0.0, 0.0}, core::Vec3{0.0, 1.0, 0.0}, core::Vec3{0.0, 0.0, 1.0}}};
  if (frame == scene::Frame::itrf) return {same};
  const radar::Instant at = radar::later(*epoch_, time_s);
  switch (frame) {
    case scene::Frame::teme: return radar::ecef_from_teme(at, orientation_);
    case scene::Frame::eme2000: return radar::ecef_from_eme2000(at, orientation_);
    default: return radar::ecef_from_gcrf(at, orientation_);
  }
}

radar::StateVector WorldAxes::from(scene::Frame frame, const radar::StateVector& state, double time_s) const {
  if (frame == scene::Frame::itrf) return from_ecef(state);
  return from_ecef(ecef_from(frame, time_s).to(state));
}

core::Mat3 WorldAxes::world_from(scene::Frame frame, double time_s) const {
  const core::Mat3 to_ecef = core::transposed(ecef_from(frame, time_s).rotation);
  // Rows are the columns of the result.
  core::Mat3 columns;
  for (std::size_t i = 0; i < 3; ++i) columns.row[i] = earth_->world_axes_from_ecef(to_ecef.row[i]);
  return core::transposed(columns);
}

}  // namespace sarsim::workflow
