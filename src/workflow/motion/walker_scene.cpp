#include <array>
#include <filesystem>
#include <span>
#include <string>

#include <fmt/format.h>

#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/number_text.hpp"
#include "radar/motion/walker.hpp"
#include "scene/language/scene_writer.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/motion/motion_files.hpp"

namespace sarsim::workflow {

namespace {

// Cubics through so many points of a cycle are within 0.15 mm.
constexpr double points_per_cycle = 200.0;
constexpr double part_rcs_m2 = 0.02;
constexpr std::size_t max_points = 1'000'000;

std::string part_name(std::size_t part) {
  return fmt::format("walker {}", radar::name_of(static_cast<radar::BodyPart>(part)));
}

scene::Scene scene_of(const WalkerRequest& request, const radar::WalkingBody& body) {
  scene::Scene scene;
  const double step_s = body.gait().cycle_s / points_per_cycle;
  const auto steps = static_cast<std::size_t>((request.end_s - request.start_s) / step_s) + 2;
  if (steps > max_points)
    throw core::InvalidRequest("the walk is too long",
                               fmt::format("at most {:.0f} s", step_s * static_cast<double>(max_points)));
  scene.platforms.resize(radar::body_part_count);
  for (std::size_t part = 0; part < radar::body_part_count; ++part) {
    scene::Platform& platform = scene.platforms[part];
    platform.name = part_name(part);
    platform.parent = request.parent;
    platform.path = scene::Platform::Path::trajectory;
    for (core::SampledFunction& function : platform.trajectory_m.part) function.method = core::Interpolation::cubic;
    scene::Target target;
    target.platform = platform.name;
    target.rcs_m2 = part_rcs_m2;
    scene.targets.push_back(target);
  }
  for (std::size_t step = 0; step < steps; ++step) {
    const double time_s = request.start_s + static_cast<double>(step) * step_s;
    const radar::WalkerBody at = body.at(time_s);
    for (std::size_t part = 0; part < radar::body_part_count; ++part) {
      auto& functions = scene.platforms[part].trajectory_m.part;
      functions[0].knots.push_back({time_s, at[part].x});
      functions[1].knots.push_back({time_s, at[part].y});
      functions[2].knots.push_back({time_s, at[part].z});
    }
  }
  return scene;
}

}  // namespace

void write_walker(const WalkerRequest& request) {
  if (!request.output.ends_with(".toml"))
    throw core::InvalidRequest(fmt::format("'{}': a walker is a scene of format 2", request.output),
                               "end it with .toml");
  if (!(request.start_s < request.end_s))
    throw core::InvalidRequest("the walk has no duration", "give an --end behind --start");
  const radar::Walker walker = radar::walker_at(request.height_m, request.speed_mps);
  if (const std::string fault = radar::fault_of(walker); !fault.empty()) throw core::InvalidRequest(fault, "");
  expect_free_outputs({request.output}, {{}, request.force, "--out"});
  const std::string text = scene::write_format_2(scene_of(request, radar::WalkingBody(walker)));
  core::OutputFile file(request.output, request.force);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
}

}  // namespace sarsim::workflow
