#include "workflow/verify/verify.hpp"

#include <fstream>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/os/output_file.hpp"
#include "core/task/clock.hpp"
#include "core/text/number_text.hpp"
#include "simulate/resolve/simd_level.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/verify/groups.hpp"

namespace sarsim::workflow::verify {

namespace {

// "model name : ..." of the first processor; empty where the system does not say.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  return {};
}

Facts facts_of(bool quick, double seconds) {
  Facts facts{{"Program", fmt::format("sarsim {}", core::program_version)}};
  if (const std::string name = processor(); !name.empty()) facts.emplace_back("Processor", name);
  facts.emplace_back("Instruction set", simulate::simd_level());
  facts.emplace_back("Measured", quick ? "quickly: fewer samples, no speed" : "everything");
  facts.emplace_back("Time", core::duration_text(seconds));
  return facts;
}

}  // namespace

VerifyReport verify_program(const VerifyRequest& request, const core::Observer& observer) {
  std::optional<core::OutputFile> page;
  if (!request.html.empty()) {
    expect_free_outputs({request.html}, {{}, request.force, "--html"});
    page.emplace(request.html, request.force);  // Before anything is measured: where it cannot be, nobody waits.
  }
  const double begin_s = core::now_s();
  VerifyReport report{verify_all({request.quick, observer.stop}), {}, 0.0};
  report.seconds = core::now_s() - begin_s;
  report.facts = facts_of(request.quick, report.seconds);
  if (page) {
    const std::string text = page_of(report.record, report.facts);
    page->write(std::as_bytes(std::span(text)));
    page->commit();
  }
  return report;
}

}  // namespace sarsim::workflow::verify
