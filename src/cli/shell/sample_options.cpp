#include "cli/shell/sample_options.hpp"

#include "cli/shell/options.hpp"

namespace sarsim::cli {

void add_sample_arguments(CLI::App& app, workflow::SampleArguments& arguments) {
  add_format(app, "--from", arguments.format, "format of the file, where content and extension mislead");
  add_integer(app, "--columns", arguments.columns, 1, std::int64_t{1} << 40, "samples of a row (BINARY)");
  add_integer(app, "--bits", arguments.bits, 1, 64, "A/D bits of its counts");
  add_real(app, "--lsb", arguments.lsb_v, "V", "volts of a count");
  add_text(app, "--script", arguments.script, "SCENE", "script whose simulation wrote the file, instead of the above");
}

}  // namespace sarsim::cli
