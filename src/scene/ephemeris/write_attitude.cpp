#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/text/number_text.hpp"
#include "scene/ephemeris/motion_checks.hpp"
#include "scene/ephemeris/write_motion.hpp"

namespace sarsim::scene {

namespace {

using Fault = std::optional<core::Problem>;

// By how much a matrix fails to be a rotation; NaN where it is not finite.
double rotation_error(const core::Mat3& m) {
  double error = std::abs(core::dot(core::cross(m.row[0], m.row[1]), m.row[2]) - 1.0);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) error += std::abs(core::dot(m.row[i], m.row[k]) - (i == k ? 1.0 : 0.0));
  return error;
}

Fault fault_of_attitudes(std::span<const AttitudeSample> samples) {
  constexpr double largest_error = 1e-6;
  if (Fault fault = ephemeris::fault_of_times(samples, ephemeris::closest_dates_s)) return fault;
  for (const AttitudeSample& sample : samples)
    if (const double error = rotation_error(sample.world_from_platform); !(error <= largest_error))
      return core::error(fmt::format("the attitude at {} s is not a rotation", core::format_number(sample.time_s)))
          .found(fmt::format("off by {:.3g}", error))
          .expected(fmt::format("within {}", largest_error));
  return std::nullopt;
}

double dot(const Quaternion& a, const Quaternion& b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }

// The axes of ITRF to those of the platform.
Quaternion body_from_itrf(const core::Mat3& world_from_platform, const radar::EarthFrame& earth) {
  core::Mat3 rotation = core::transposed(world_from_platform);
  for (core::Vec3& axis : rotation.row) axis = earth.ecef_axes_from_world(axis);
  return quaternion_of(rotation);
}

}  // namespace

Quaternion quaternion_of(const core::Mat3& turned_from_first) {
  const core::Vec3& a = turned_from_first.row[0];
  const core::Vec3& b = turned_from_first.row[1];
  const core::Vec3& c = turned_from_first.row[2];
  // Rows of 4 q q^T: each is q times one of its parts.
  const std::array<Quaternion, 4> products{{{1.0 + a.x + b.y + c.z, b.z - c.y, c.x - a.z, a.y - b.x},
                                            {b.z - c.y, 1.0 + a.x - b.y - c.z, a.y + b.x, a.z + c.x},
                                            {c.x - a.z, a.y + b.x, 1.0 - a.x + b.y - c.z, b.z + c.y},
                                            {a.y - b.x, a.z + c.x, b.z + c.y, 1.0 - a.x - b.y + c.z}}};
  const Quaternion* largest = &products[0];
  for (const Quaternion& product : products)
    if (dot(product, product) > dot(*largest, *largest)) largest = &product;
  const double length = std::sqrt(dot(*largest, *largest));
  const double scale = largest->w < 0.0 ? -1.0 / length : 1.0 / length;
  return {scale * largest->w, scale * largest->x, scale * largest->y, scale * largest->z};
}

MotionText write_attitude_aem(std::span<const AttitudeSample> samples, const MotionFacts& facts,
                              InterpolationHint interpolation) {
  if (Fault fault = fault_of_attitudes(samples)) return ephemeris::refused(*std::move(fault));
  const double first_s = samples.front().time_s;
  const double last_s = samples.back().time_s;
  if (Fault fault = ephemeris::fault_of_message(first_s, last_s, facts)) return ephemeris::refused(*std::move(fault));
  MotionText result{
      ephemeris::message_head("CCSDS_AEM_VERS", "1.0", "attitude of one platform over the Earth-fixed axes", facts),
      {}};
  result.text += "REF_FRAME_A = ITRF\nREF_FRAME_B = SC_BODY_1\nATTITUDE_DIR = A2B\n";
  result.text += ephemeris::time_lines(first_s, last_s, *facts.epoch);
  result.text += "ATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = LAST\n";
  result.text += ephemeris::interpolation_lines("INTERPOLATION_METHOD", interpolation);
  result.text += "META_STOP\nDATA_START\n";
  Quaternion before;
  for (const AttitudeSample& sample : samples) {
    Quaternion q = body_from_itrf(sample.world_from_platform, *facts.earth);
    if (dot(q, before) < 0.0) q = {-q.w, -q.x, -q.y, -q.z};
    before = q;
    result.text += ephemeris::stamp_of(*facts.epoch, sample.time_s);
    ephemeris::append_vector(result.text, {q.x, q.y, q.z}, " ", 0);
    result.text += ' ';
    core::append_number(result.text, q.w);
    result.text += '\n';
  }
  result.text += "DATA_STOP\n";
  return result;
}

}  // namespace sarsim::scene
