#include "scene/edit/data_functions.hpp"

#include <algorithm>
#include <cmath>

#include "scene/edit/edit_runs.hpp"

namespace sarsim::scene {

namespace {

namespace blocks = function_blocks;

template <std::size_t N>
FunctionUse use(const FunctionBlock& block, const UserFunction<N>& function) {
  return {&block, function.part, &function.file};
}

std::vector<FunctionUse> uses(const Platform& platform) {
  return {use(blocks::trajectory, platform.trajectory_m), use(blocks::rotation, platform.rotation_deg),
          use(blocks::position_envelope, platform.position_envelope),
          use(blocks::rotation_envelope, platform.rotation_envelope)};
}

std::vector<FunctionUse> uses(const Target& target) { return {use(blocks::target_gain, target.traits->gain_db)}; }

std::vector<FunctionUse> uses(const Cloud& cloud) { return {use(blocks::target_gain, cloud.traits.gain_db)}; }

std::vector<FunctionUse> uses(const Radar& radar) {
  return {use(blocks::pulse_iq, radar.pulse_iq),
          use(blocks::envelope_gain, radar.envelope_gain),
          use(blocks::pri, radar.pri_s),
          use(blocks::carrier_list, radar.carrier_list_hz),
          use(blocks::transmit_gain, radar.transmit_antenna.gain_db),
          use(blocks::receive_gain, radar.receive_antenna.gain_db),
          use(blocks::beam_target, radar.beam_target_world_m),
          use(blocks::window_gain, radar.window_gain),
          use(blocks::stc_gain, radar.stc_gain)};
}

template <class Object>
std::vector<FunctionUse> uses(const Object&) {
  return {};
}

bool finite(const FunctionUse& function) {
  return std::ranges::all_of(function.parts, [](const core::SampledFunction& part) {
    return std::ranges::all_of(part.knots,
                               [](const core::Knot& k) { return std::isfinite(k.x) && std::isfinite(k.y); });
  });
}

bool same_points(std::span<const core::SampledFunction> parts, const std::vector<std::vector<core::Knot>>& points) {
  return std::ranges::equal(parts, points, {}, &core::SampledFunction::knots);
}

bool same_data(const FunctionUse& a, const FunctionUse& b) {
  return *a.file == *b.file &&
         std::ranges::equal(a.parts, b.parts, {}, &core::SampledFunction::knots, &core::SampledFunction::knots);
}

}  // namespace

std::vector<FunctionUse> functions_of(const SharedObject& object) {
  return object.visit([](const auto& any) { return uses(any); });
}

void PendingData::follow(const Edit& edit, bool forwards, const DataFileLoader& disk) {
  for (const ListChange& change : list_changes(edit, forwards)) {
    if (change.in == nullptr) continue;
    const std::vector<FunctionUse> now = functions_of(*change.in);
    const std::vector<FunctionUse> before = change.out != nullptr ? functions_of(*change.out) : now;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i].file->empty() || !finite(now[i])) continue;
      if (change.out == nullptr || !same_data(now[i], before[i])) note(now[i], disk);
    }
  }
}

void PendingData::note(const FunctionUse& function, const DataFileLoader& disk) {
  const DataFileText found = disk ? disk(*function.file) : DataFileText{};
  if (!found.path.empty() && found.failure.empty()) {
    const DataFileReading reading = read_data_file(found.text, found.path, *function.block);
    if (!core::has_errors(reading.problems) && same_points(function.parts, reading.functions)) {
      texts_.erase(*function.file);
      return;
    }
  }
  texts_[*function.file] = write_data_file(function.parts, *function.block);
}

DataFileLoader PendingData::loader(DataFileLoader disk) {
  return [this, disk = std::move(disk)](const std::string& name) {
    const auto pending = texts_.find(name);
    if (pending == texts_.end()) return disk ? disk(name) : DataFileText{};
    DataFileText found = disk ? disk(name) : DataFileText{};
    if (found.text == pending->second) {
      texts_.erase(pending);
      return found;
    }
    return DataFileText{name, pending->second, {}};
  };
}

}  // namespace sarsim::scene
