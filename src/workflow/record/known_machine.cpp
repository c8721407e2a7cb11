#include "workflow/record/known_machine.hpp"

#include <array>
#include <cstddef>
#include <exception>
#include <fstream>
#include <span>
#include <variant>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/hash/checksum.hpp"
#include "core/os/cache_folder.hpp"
#include "core/os/input_file.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "scene/edit/text_file.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "simulate/run/measure_machine.hpp"

namespace sarsim::workflow {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "sarsim machine speed 1\n";
constexpr std::uint64_t max_bytes = 4096;

struct Part {
  std::string_view name;
  double simulate::MachineSpeed::*value;
};
constexpr std::array<Part, 6> parts{{{"samples", &simulate::MachineSpeed::samples},
                                     {"noise", &simulate::MachineSpeed::noise},
                                     {"compression", &simulate::MachineSpeed::compression},
                                     {"direct", &simulate::MachineSpeed::direct},
                                     {"spectral", &simulate::MachineSpeed::spectral},
                                     {"reference", &simulate::MachineSpeed::reference}}};

// As Linux says it; empty elsewhere.
std::string processor_name() {
  constexpr int max_lines = 64;
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  for (int i = 0; i < max_lines && std::getline(file, line); ++i)
    if (line.starts_with("model name")) return line;
  return {};
}

std::optional<std::string> short_text_of(const fs::path& path) {
  auto opened = core::InputFile::open(path);
  const core::InputFile* file = std::get_if<core::InputFile>(&opened);
  if (file == nullptr || file->size() > max_bytes) return std::nullopt;
  std::string text(file->size(), '\0');
  file->read_all_at(0, std::as_writable_bytes(std::span(text)));
  return text;
}

}  // namespace

std::string text_of(const simulate::MachineSpeed& speed) {
  std::string text(first_line);
  for (const Part& part : parts) text += fmt::format("{} {:.4g}\n", part.name, speed.*part.value);
  return text;
}

std::optional<simulate::MachineSpeed> machine_speed_from(std::string_view text) {
  constexpr double farthest = 1000.0;
  if (!text.starts_with(first_line)) return std::nullopt;
  text.remove_prefix(first_line.size());
  simulate::MachineSpeed speed;
  for (const Part& part : parts) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos || !text.starts_with(part.name) || text.size() <= part.name.size() ||
        text[part.name.size()] != ' ')
      return std::nullopt;
    const std::optional<double> value =
        core::parse_number(text.substr(part.name.size() + 1, end - part.name.size() - 1));
    if (!value || !(*value >= 1.0 / farthest && *value <= farthest)) return std::nullopt;
    speed.*part.value = *value;
    text.remove_prefix(end + 1);
  }
  return speed;
}

fs::path machine_file(const fs::path& folder) {
  const std::string machine = fmt::format("{}\n{}\n{}\n{}", core::program_version, processor_name(),
                                          simulate::simd_level(), core::thread_count(0));
  return folder / fmt::format("{:016x}.speed", core::checksum_of(machine));
}

simulate::MachineSpeed known_machine(const fs::path& folder, const core::StopFlag* stop) {
  const fs::path path = machine_file(folder);
  try {
    if (const auto text = short_text_of(path))
      if (const auto speed = machine_speed_from(*text)) return *speed;
  } catch (const std::exception&) {
    // A file that cannot be read is as none.
  }
  const simulate::MachineSpeed speed = simulate::measure_machine(stop);
  try {
    std::error_code error;
    fs::create_directories(folder, error);
    scene::write_text_file(path, text_of(speed));
  } catch (const std::exception&) {
    // What cannot be kept is measured again.
  }
  return speed;
}

simulate::MachineSpeed known_machine(const core::StopFlag* stop) {
  const fs::path folder = core::user_cache_folder();
  return folder.empty() ? simulate::MachineSpeed{} : known_machine(folder, stop);
}

}  // namespace sarsim::workflow
