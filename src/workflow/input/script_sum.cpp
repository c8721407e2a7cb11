#include "workflow/input/script_sum.hpp"

#include <span>

#include <fmt/format.h>

#include "core/hash/checksum.hpp"

namespace sarsim::workflow {

namespace {

// The points of functions that the script only names the file of.
class DataFiles {
 public:
  explicit DataFiles(core::Checksum& sum) : sum_(sum) {}

  template <std::size_t N>
  void add(const scene::UserFunction<N>& function) {
    if (function.file.empty()) return;
    for (const core::SampledFunction& part : function.part) sum_.add(std::as_bytes(std::span(part.knots)));
  }

  void add(const scene::Scene& scene) {
    for (const scene::Platform& p : scene.platforms) {
      add(p.trajectory_m);
      add(p.rotation_deg);
      add(p.position_envelope);
      add(p.rotation_envelope);
    }
    for (const scene::Target& target : scene.targets) add(target.gain_db);
    for (const scene::Radar& r : scene.radars) {
      add(r.pulse_iq);
      add(r.envelope_gain);
      add(r.pri_s);
      add(r.carrier_list_hz);
      add(r.transmit_antenna.gain_db);
      add(r.receive_antenna.gain_db);
      add(r.beam_target_world_m);
      add(r.window_gain);
      add(r.stc_gain);
    }
  }

 private:
  core::Checksum& sum_;
};

}  // namespace

std::string script_sum(const scene::Scene& scene, const std::string& script) {
  core::Checksum sum;
  sum.add(script);
  DataFiles(sum).add(scene);
  return fmt::format("{:016x}", sum.value());
}

}  // namespace sarsim::workflow
