#include <memory>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "core/os/output_file.hpp"
#include "core/report/invalid_request.hpp"
#include "core/text/json.hpp"
#include "scene/language/explanation.hpp"
#include "scene/language/json_schema.hpp"
#include "scene/language/reference.hpp"
#include "workflow/input/output_names.hpp"

namespace sarsim::cli {

namespace {

struct ExplainArguments {
  std::vector<std::string> field;
  std::string output;
  bool schema = false;
  bool reference = false;
  bool json = false;
  bool force = false;
};

std::string explanation_of(const ExplainArguments& arguments) {
  const scene::language::Explanation explanation =
      scene::language::explain(fmt::format("{}", fmt::join(arguments.field, " ")));
  if (!explanation.failure.empty()) throw core::InvalidRequest(explanation.failure, explanation.hint);
  if (!arguments.json) return scene::language::text_of(explanation);
  core::JsonWriter json;
  scene::language::write_json(json, explanation);
  return json.text();
}

std::string answer_to(const ExplainArguments& arguments) {
  if (arguments.schema) return scene::language::json_schema();
  if (arguments.reference) return scene::language::reference();
  return explanation_of(arguments);
}

ExitStatus explain(const ExplainArguments& arguments, Streams& streams) {
  const std::string text = answer_to(arguments);
  if (arguments.output.empty()) {
    write_out(streams, text);
    return exit_done;
  }
  workflow::expect_free_outputs({arguments.output}, {{}, arguments.force, "-o"});
  core::OutputFile file(arguments.output, arguments.force);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
  return exit_done;
}

}  // namespace

Action add_explain(CLI::App& app) {
  auto arguments = std::make_shared<ExplainArguments>();
  auto* field = app.add_option("field", arguments->field,
                               "a field, a choice, a kind of object, or any radar term; without it, an overview");
  field->type_name("WORD")->expected(0, -1);
  auto* schema = app.add_flag("--schema", arguments->schema, "the JSON Schema of the language, for editors");
  auto* reference = app.add_flag("--reference", arguments->reference, "the reference of the language, in Markdown");
  auto* json = app.add_flag("--json", arguments->json, "the explanation as JSON");
  add_text(app, "-o,--out", arguments->output, "FILE", "file to write (default: standard output)");
  app.add_flag("--force", arguments->force, "replace the file where it exists");
  schema->excludes(field)->excludes(reference)->excludes(json);
  reference->excludes(field)->excludes(json);
  add_examples(app, {{"sarsim explain", "what a scene of format 2 can contain"},
                     {"sarsim explain radar", "the fields of a kind of object"},
                     {"sarsim explain radar.pulse", "a choice with its alternatives"},
                     {"sarsim explain radar.pulse.width", "one field: unit, range, default, example"},
                     {"sarsim explain prf", "a field by its name in --set"},
                     {"sarsim explain wavelength", "which field sets it, and how it is converted"},
                     {"sarsim explain range migration", "related fields and pages"},
                     {"sarsim explain --schema -o sarsim-2.schema.json", "for an editor that completes and checks"}});
  return [arguments](Streams& streams) { return explain(*arguments, streams); };
}

}  // namespace sarsim::cli
