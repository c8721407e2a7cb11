#include "cli/command/part_options.hpp"

#include <fmt/format.h>

#include "core/text/number_text.hpp"

namespace sarsim::cli {

namespace {

[[noreturn]] void refuse(const char* name, const std::string& text, const char* expected) {
  throw CLI::ValidationError(name, fmt::format("'{}' is not {}", text, expected));
}

template <class Value>
void take(const char* name, const std::string& text, const std::optional<Value>& meant, std::optional<Value>& value,
          const char* expected) {
  if (!meant) refuse(name, text, expected);
  value = meant;
}

}  // namespace

void add_part_options(CLI::App& app, workflow::PartChoice& choice) {
  auto* part = app.add_option_function<std::string>(
      "--part",
      [&choice](const std::string& text) {
        take("--part", text, workflow::share_from(text), choice.share, "a part such as 3/8: the third of eight");
      },
      "only this share of the pulses of each recording, such as 3/8; all shares together give the file of a single "
      "run");
  part->type_name("K/N");
  auto* pulses = app.add_option_function<std::string>(
      "--pulses",
      [&choice](const std::string& text) {
        take("--pulses", text, workflow::span_from(text), choice.span,
             "a range of pulses such as 101:200, counted from 1");
      },
      "only these pulses of each recording (bursts of range profiles), counted from 1");
  pulses->type_name("A:B");
  part->excludes(pulses);
  app.add_flag("--part-file", choice.own_file, "keep the share in a file of its own, for sarsim merge");
  app.add_flag("--resume", choice.resume, "keep a journal, and continue an interrupted run");
  const auto read = [&choice](const std::string& text) {
    choice.save_every_s = core::parse_number(text);
    if (!choice.save_every_s || *choice.save_every_s < 0.0 || *choice.save_every_s > 86400.0)
      refuse("--save-every", text, "a number of seconds from 0 to 86400");
  };
  app.add_option_function<std::string>("--save-every", read, "seconds from one entry of the journal to the next (1)")
      ->type_name("S");
}

}  // namespace sarsim::cli
