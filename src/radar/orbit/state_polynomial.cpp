#include "radar/orbit/state_polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/report/expect.hpp"

namespace sarsim::radar {

namespace {

using core::Vec3;

constexpr std::size_t max_conditions = 2 * max_polynomial_states;

// Conditions of a polynomial in Newton's form: scaled places, and differences that are divided in place.
struct NewtonForm {
  std::array<double, max_conditions> places{};
  std::array<Vec3, max_conditions> c{};
  std::size_t count = 0;
};

// The mean distance of the states, in which times are counted: powers neither vanish nor grow.
double time_unit_s(const StateView& states, std::span<const std::size_t> through) {
  const auto [low, high] = std::ranges::minmax(through);
  return through.size() < 2 ? 1.0 : (states.time_s[high] - states.time_s[low]) / static_cast<double>(high - low);
}

NewtonForm newton_form(const StateView& states, std::span<const std::size_t> through, double unit_s) {
  const bool pairs = !states.velocity_mps.empty();
  const std::size_t first = through.front();
  NewtonForm form;
  for (const std::size_t state : through) {
    const double place = (states.time_s[state] - states.time_s[first]) / unit_s;
    form.places[form.count] = place;
    form.c[form.count++] = states.position_m[state] - states.position_m[first];
    if (!pairs) continue;
    form.places[form.count] = place;
    form.c[form.count++] = unit_s * states.velocity_mps[state];
  }
  for (std::size_t level = 1; level < form.count; ++level)
    for (std::size_t k = form.count - 1; k >= level; --k) {
      if (pairs && level == 1 && k % 2 == 1) continue;  // The slope of its pair already.
      // On the first level the left neighbour of a pair is the value of the pair before.
      const Vec3& left = pairs && level == 1 ? form.c[k - 2] : form.c[k - 1];
      form.c[k] = (1.0 / (form.places[k] - form.places[k - level])) * (form.c[k] - left);
    }
  return form;
}

}  // namespace

void polynomial_sums(const StateView& states, std::span<const std::size_t> through, double time_s,
                     std::span<OrbitState> sums) {
  CORE_EXPECT(!through.empty() && through.size() <= max_polynomial_states && sums.size() == through.size());
  const double unit_s = time_unit_s(states, through);
  const NewtonForm form = newton_form(states, through, unit_s);
  const std::size_t per_state = states.velocity_mps.empty() ? 1 : 2;
  const double x = (time_s - states.time_s[through.front()]) / unit_s;
  Vec3 value, slope;
  double product = 1.0;  // of x - place over the conditions so far, and its slope
  double product_slope = 0.0;
  for (std::size_t k = 0; k < form.count; ++k) {
    value = value + product * form.c[k];
    slope = slope + product_slope * form.c[k];
    product_slope = product_slope * (x - form.places[k]) + product;
    product *= x - form.places[k];
    if ((k + 1) % per_state == 0)
      sums[k / per_state] = {states.position_m[through.front()] + value, (1.0 / unit_s) * slope};
  }
}

std::vector<std::size_t> neighbours_of(std::size_t left, std::size_t begin, std::size_t end, std::size_t count) {
  std::vector<std::size_t> order;
  std::size_t below = left + 1;  // one above the next of that side
  std::size_t above = left + 1;
  while (order.size() < count && (below > begin || above < end)) {
    const bool take_below = above >= end || (below > begin && left + 1 - below <= above - left - 1);
    order.push_back(take_below ? --below : above++);
  }
  return order;
}

}  // namespace sarsim::radar
