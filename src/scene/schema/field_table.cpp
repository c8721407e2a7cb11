#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

bool operator==(const ConstListRef& a, const ConstListRef& b) {
  return a.kind == b.kind && visit_elements(a.kind, a.list, [&]<class List>(const List& list) {
           return list == *static_cast<const List*>(b.list);
         });
}

void begin_constant(core::SampledFunction& function, double value) {
  if (function.knots.empty()) function.knots.push_back({0.0, value});
}

}  // namespace sarsim::scene
