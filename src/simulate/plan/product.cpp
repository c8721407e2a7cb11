#include "simulate/plan/product.hpp"

#include <array>
#include <memory>
#include <utility>

#include "core/report/expect.hpp"

namespace sarsim::simulate {

namespace {

// What files hold of a pose.
raster::RowPose row_pose(const radar::Pose& pose) {
  const auto numbers = [](const core::Vec3& v) { return std::array{v.x, v.y, v.z}; };
  return {numbers(pose.position_world_m), numbers(pose.velocity_world_mps), pose.rotation_rad};
}

}  // namespace

raster::Product product_of(const Acquisition& acquisition, std::string script) {
  CORE_EXPECT(acquisition.scene != nullptr);
  CORE_EXPECT(acquisition.reception.column_range_m.size() == acquisition.reception.columns);
  raster::Product product;
  product.radar = acquisition.link.name;
  product.processing = acquisition.simulation.processing;
  product.rows = acquisition.timing.rows;
  product.columns = acquisition.reception.columns;
  // The axes are functions so that a long recording costs no memory; they keep the schedule, not the acquisition.
  const auto pulse_of = [timing = acquisition.timing](std::size_t row) { return timing.first_pulse_of_row(row); };
  product.row_time_s = [pulse_of, repetition = acquisition.link.repetition](std::size_t row) {
    return repetition.send_time_s(pulse_of(row));
  };
  product.row_carrier_hz = [pulse_of, carrier = acquisition.link.carrier](std::size_t row) {
    return carrier.carrier_hz(pulse_of(row));
  };
  const radar::Track& track = acquisition.scene->platforms[acquisition.link.platform].track;
  product.row_pose = [pulse_of, repetition = acquisition.link.repetition,
                      track = std::make_shared<const radar::Track>(track)](std::size_t row) {
    const std::int64_t pulse = pulse_of(row);
    return row_pose(track->at(repetition.send_time_s(pulse), pulse));
  };
  product.column_range_m = [ranges = acquisition.reception.column_range_m](std::size_t column) {
    return ranges[column];
  };
  product.sample_rate_hz = acquisition.reception.sample_rate_hz;
  product.bits = acquisition.simulation.bits;
  product.lsb_v = acquisition.simulation.lsb_v;
  product.options = acquisition.scene->options;
  product.script = std::move(script);
  return product;
}

}  // namespace sarsim::simulate
