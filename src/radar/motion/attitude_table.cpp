#include "radar/motion/attitude_table.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace sarsim::radar {

namespace {

using Components = std::array<double, 4>;  // w, x, y, z of a quaternion or of a derivative of one

double product(const Components& p, const Components& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
}

// The symmetric bilinear form whose value for p = q is the matrix of q times its squared length.
core::Mat3 bilinear(const Components& p, const Components& q) {
  const auto s = [&](std::size_t i, std::size_t k) { return 0.5 * (p[i] * q[k] + p[k] * q[i]); };
  const double ww = s(0, 0), xx = s(1, 1), yy = s(2, 2), zz = s(3, 3);
  const double wx = 2.0 * s(0, 1), wy = 2.0 * s(0, 2), wz = 2.0 * s(0, 3);
  const double xy = 2.0 * s(1, 2), xz = 2.0 * s(1, 3), yz = 2.0 * s(2, 3);
  return {{core::Vec3{ww + xx - yy - zz, xy - wz, xz + wy}, core::Vec3{xy + wz, ww - xx + yy - zz, yz - wx},
           core::Vec3{xz - wy, yz + wx, ww - xx - yy + zz}}};
}

// A quaternion of any length and its derivatives in time.
struct MovingQuaternion {
  Components value, rate, acceleration;
};

// M |q|^2 = bilinear(q, q).
TurningMatrix turning_of(const MovingQuaternion& q) {
  const double length2 = product(q.value, q.value);
  const core::Mat3 m = (1.0 / length2) * bilinear(q.value, q.value);
  const double length2_rate = 2.0 * product(q.value, q.rate);
  return {m, (1.0 / length2) * (2.0 * bilinear(q.value, q.rate) + -length2_rate * m)};
}

core::Mat3 second_derivative_of(const MovingQuaternion& q, const TurningMatrix& m) {
  const double length2 = product(q.value, q.value);
  const double rate = 2.0 * product(q.value, q.rate);
  const double acceleration = 2.0 * (product(q.rate, q.rate) + product(q.value, q.acceleration));
  const core::Mat3 whole = 2.0 * (bilinear(q.rate, q.rate) + bilinear(q.value, q.acceleration));
  return (1.0 / length2) * (whole + -2.0 * rate * m.rate + -acceleration * m.matrix);
}

MovingQuaternion moving_quaternion(const std::array<core::Interpolator, 4>& parts, double time_s) {
  MovingQuaternion q;
  for (std::size_t i = 0; i < 4; ++i) {
    const core::Jet jet = parts[i].jet(time_s);
    q.value[i] = jet.value;
    q.rate[i] = jet.slope;
    q.acceleration[i] = jet.curvature;
  }
  return q;
}

Components components(const Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

std::optional<core::Problem> fault_of_attitudes(const AttitudeSamples& samples) {
  const std::size_t count = samples.time_s.size();
  if (count == 0) return core::error("there are no attitudes").found("0 attitudes").expected("1 or more");
  if (samples.world_from_platform.size() != count)
    return core::error("attitudes and times differ in number")
        .found(fmt::format("{}", samples.world_from_platform.size()))
        .expected(fmt::format("{}", count));
  for (std::size_t i = 0; i < count; ++i) {
    const Components q = components(samples.world_from_platform[i]);
    const double length = std::sqrt(product(q, q));
    if (!std::isfinite(samples.time_s[i]) || !std::isfinite(length))
      return core::error(fmt::format("attitude {} is not finite", i + 1)).expected("finite numbers");
    if (!(std::abs(length - 1.0) <= 1e-3))
      return core::error(fmt::format("quaternion {} has not the length 1", i + 1))
          .found(fmt::format("{:g}", length))
          .expected("1 within 0.001");
    if (i > 0 && !(samples.time_s[i] > samples.time_s[i - 1]))
      return core::error(fmt::format("the time of attitude {} does not ascend", i + 1))
          .found(fmt::format("{} s", samples.time_s[i]))
          .expected(fmt::format("above {} s", samples.time_s[i - 1]));
  }
  return std::nullopt;
}

// Of length 1, each on the side of the one before it.
std::vector<Components> continuous(const std::vector<Quaternion>& attitudes) {
  std::vector<Components> result;
  result.reserve(attitudes.size());
  for (const Quaternion& attitude : attitudes) {
    Components q = components(attitude);
    const bool other_side = !result.empty() && product(q, result.back()) < 0.0;
    const double scale = (other_side ? -1.0 : 1.0) / std::sqrt(product(q, q));
    for (double& part : q) part *= scale;
    result.push_back(q);
  }
  return result;
}

}  // namespace

core::Mat3 matrix_of(const Quaternion& rotation) { return turning_of({components(rotation), {}, {}}).matrix; }

// The largest of the four squares comes from the diagonal, the others from sums and differences (Shepperd 1978).
Quaternion quaternion_of(const core::Mat3& m) {
  const auto& [x, y, z] = m.row;
  const std::array<double, 4> squares{1.0 + x.x + y.y + z.z, 1.0 + x.x - y.y - z.z, 1.0 - x.x + y.y - z.z,
                                      1.0 - x.x - y.y + z.z};
  const auto largest = std::ranges::max_element(squares) - squares.begin();
  const double wx = z.y - y.z, wy = x.z - z.x, wz = y.x - x.y;
  const double xy = x.y + y.x, xz = x.z + z.x, yz = y.z + z.y;
  const std::array<Components, 4> rows{Components{squares[0], wx, wy, wz}, Components{wx, squares[1], xy, xz},
                                       Components{wy, xy, squares[2], yz}, Components{wz, xz, yz, squares[3]}};
  const Components& q = rows[static_cast<std::size_t>(largest)];
  const double scale = (q[0] < 0.0 ? -1.0 : 1.0) / std::sqrt(product(q, q));
  return {scale * q[0], scale * q[1], scale * q[2], scale * q[3]};
}

std::variant<AttitudeTable, core::Problem> AttitudeTable::from(const AttitudeSamples& samples) {
  if (std::optional<core::Problem> fault = fault_of_attitudes(samples)) return *std::move(fault);
  const std::vector<Components> attitudes = continuous(samples.world_from_platform);
  AttitudeTable table;
  table.first_s_ = samples.time_s.front();
  table.last_s_ = samples.time_s.back();
  for (std::size_t part = 0; part < 4; ++part) {
    core::SampledFunction function{core::Interpolation::cubic, {}};
    for (std::size_t i = 0; i < attitudes.size(); ++i)
      function.knots.push_back({samples.time_s[i], attitudes[i][part]});
    table.parts_[part] = core::Interpolator(function, {core::LowPassRule::first_knot, core::CubicEnds::not_a_knot});
  }
  return table;
}

TurningMatrix AttitudeTable::turning_at(double time_s) const {
  if (time_s >= first_s_ && time_s < last_s_) return turning_of(moving_quaternion(parts_, time_s));
  MovingQuaternion end = moving_quaternion(parts_, time_s < first_s_ ? first_s_ : last_s_);
  end.rate = {};
  return turning_of(end);
}

AttitudeMotion AttitudeTable::at(double time_s) const {
  if (!(time_s >= first_s_ && time_s < last_s_))
    return {turning_at(time_s), {{core::Vec3{}, core::Vec3{}, core::Vec3{}}}};
  const MovingQuaternion q = moving_quaternion(parts_, time_s);
  const TurningMatrix m = turning_of(q);
  return {m, second_derivative_of(q, m)};
}

}  // namespace sarsim::radar
