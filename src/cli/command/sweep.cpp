#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <span>

#include <fmt/format.h>

#include "cli/command/commands.hpp"
#include "cli/command/products.hpp"
#include "cli/command/sweep_arguments.hpp"
#include "cli/shell/engine_options.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/output_names.hpp"
#include "cli/shell/progress_display.hpp"
#include "cli/shell/report.hpp"
#include "cli/shell/scene_input.hpp"
#include "core/os/disk_room.hpp"
#include "core/os/output_file.hpp"
#include "core/task/clock.hpp"
#include "core/task/parallel.hpp"
#include "core/text/number_text.hpp"
#include "workflow/sweep/sweep_axes.hpp"
#include "workflow/sweep/sweep_check.hpp"
#include "workflow/sweep/sweep_fields.hpp"
#include "workflow/sweep/sweep_journal.hpp"
#include "workflow/sweep/sweep_run.hpp"
#include "workflow/sweep/sweep_table.hpp"

namespace sarsim::cli {

namespace fs = std::filesystem;

namespace {

using workflow::check_sweep;
using workflow::field_list;
using workflow::modification_time;
using workflow::ProductSize;
using workflow::read_journals;
using workflow::run_variation;
using workflow::safe_word;
using workflow::Sweep;
using workflow::sweep_csv;
using workflow::sweep_json;
using workflow::SweepChecks;
using workflow::SweepFrame;
using workflow::SweepJournal;
using workflow::SweepRow;
using workflow::VariationNames;
using workflow::VariationRules;

constexpr std::size_t most_problems_told = 20;

void write_whole(const fs::path& path, const std::string& text, bool replace) {
  core::OutputFile file(path, replace);
  file.write(std::as_bytes(std::span(text)));
  file.commit();
}

// One sweep, from the text of the script to the table.
class Sweeper {
 public:
  Sweeper(const SweepArguments& arguments, Streams& streams)
      : arguments_(arguments), streams_(streams), part_(read_part(arguments.part)) {
    threads_ = core::thread_count(static_cast<unsigned>(arguments.threads.value_or(0)));
    rules_ = {arguments.folder,
              arguments.engine.value_or(simulate::Engine::automatic),
              arguments.counts,
              arguments.header,
              arguments.force,
              arguments.discard,
              1};
  }

  ExitStatus run() {
    choose_simd(arguments_.simd);
    read_script();
    if (arguments_.fields) {
      write_out(streams_, field_list(input_.scene));
      return exit_done;
    }
    sweep_.emplace(input_.scene, arguments_.settings, arguments_.paired);
    choose_products();
    name_rows();
    if (arguments_.resume) take_journals();
    check_variations();
    if (arguments_.dry_run) return print_plan();
    expect_free_outputs();
    if (!arguments_.discard)
      core::expect_room(arguments_.folder, sum_of(&ProductSize::least_bytes),
                        "choose another folder with --out, or keep the tables alone with --discard");
    announce();
    make_rows();
    return finish();
  }

 private:
  [[nodiscard]] core::WorkControl all_threads() const { return {threads_, streams_.stop}; }

  void read_script() {
    input_ = read_scene(arguments_.scene, arguments_.overrides, Scrutiny::reading, all_threads());
    expect_usable(input_, arguments_.strict);
    if (!arguments_.quiet && !arguments_.fields) print_problems(streams_, input_.problems);
  }

  void choose_products() {
    const OutputNames names = output_names(input_.scene, {".", false, arguments_.overrides.format});
    if (core::has_errors(names.problems)) throw core::Refused(names.problems);
    products_ = chosen_products(input_.scene, names, arguments_.products);
    if (products_.empty()) {
      core::Refused nothing("the script asks for nothing that could vary", "add a $SIMULATION or a $GEOMETRY");
      nothing.problems.front().place.file = arguments_.scene;
      throw nothing;
    }
  }

  void name_rows() {
    const VariationNames names(input_.scene, *sweep_, products_, rules_);
    for (std::size_t variation = part_.index; variation < sweep_->size(); variation += part_.count) {
      variations_.push_back(variation);
      for (std::size_t product = 0; product < products_.size(); ++product)
        rows_.push_back(names.row(variation, product));
    }
    if (variations_.empty())
      throw core::Refused(fmt::format("--part: there are {} for {} parts, and none for part {}",
                                      counted(sweep_->size(), "variation"), part_.count, part_.index + 1),
                          "use no more parts than there are variations");
  }

  [[nodiscard]] std::string stem() const { return arguments_.table.empty() ? "sweep" : safe_word(arguments_.table); }
  [[nodiscard]] std::string part_stem() const {
    return part_.count == 1 ? stem() : fmt::format("{}-{}-of-{}", stem(), part_.index + 1, part_.count);
  }
  [[nodiscard]] fs::path beside(const std::string& name) const { return fs::path(arguments_.folder) / name; }

  // Completes the rows of products that are there already, from the same scene.
  void take_journals() {
    const std::map<std::string, SweepRow> known = read_journals(arguments_.folder, stem());
    for (SweepRow& row : rows_) {
      const auto found = known.find(row.file);
      if (found == known.end() || found->second.stamp != row.stamp) continue;
      if (!arguments_.discard && !holds(found->second)) continue;
      SweepRow done = found->second;
      done.variation = row.variation;
      done.product = row.product;
      row = std::move(done);
    }
  }

  // Whether the file is there as it was written; a sweep that discarded everything vouches for none.
  [[nodiscard]] bool holds(const SweepRow& row) const {
    std::error_code none;
    const auto size = fs::file_size(beside(row.file), none);
    return !none && row.written && static_cast<double>(size) == row.bytes &&
           modification_time(beside(row.file)) == row.written;
  }

  void check_variations() {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < variations_.size(); ++i)
      if (!all_done(i)) open.push_back(variations_[i]);
    checks_ = check_sweep({input_.scene, input_.places, *sweep_, products_, open, arguments_.counts,
                           arguments_.engine.value_or(simulate::Engine::automatic)},
                          all_threads());
    open_ = std::move(open);
    const bool bad = core::has_errors(checks_.problems) ||
                     (arguments_.strict && std::ranges::any_of(checks_.problems, [](const core::Problem& p) {
                        return p.severity == core::Severity::warning;
                      }));
    if (bad) {
      if (arguments_.json) write_out(streams_, sweep_json(frame("bad input"), {}));
      throw core::Refused(shortened(checks_.problems));
    }
    if (!arguments_.quiet) print_problems(streams_, shortened(checks_.problems));
  }

  [[nodiscard]] static core::Problems shortened(core::Problems problems) {
    if (problems.size() <= most_problems_told) return problems;
    core::Problem rest;
    rest.severity = core::Severity::note;
    rest.message = fmt::format("{} more of this kind are not shown", problems.size() - most_problems_told);
    rest.hint = "vary less at once to see all of them";
    problems.resize(most_problems_told);
    problems.push_back(std::move(rest));
    return problems;
  }

  [[nodiscard]] bool all_done(std::size_t place) const {
    for (std::size_t product = 0; product < products_.size(); ++product)
      if (!rows_[place * products_.size() + product].done) return false;
    return true;
  }

  [[nodiscard]] double sum_of(double ProductSize::*member) const {
    double sum = 0.0;
    for (const auto& sizes : checks_.sizes)
      for (const ProductSize& size : sizes) sum += size.*member;
    return sum;
  }

  [[nodiscard]] const ProductSize& size_of(std::size_t variation, std::size_t product) const {
    const auto open = std::ranges::lower_bound(open_, variation);
    return checks_.sizes.at(static_cast<std::size_t>(open - open_.begin())).at(product);
  }

  ExitStatus print_plan() {
    write_out(streams_, arguments_.json ? plan_json() : plan_text());
    if (!arguments_.quiet) announce();
    return exit_done;
  }

  [[nodiscard]] std::string plan_json() const {
    std::vector<SweepRow> rows = rows_;
    for (SweepRow& row : rows) {
      if (row.done || row.table) continue;
      const ProductSize& size = size_of(row.variation, row.product);
      row.run.rows = size.rows;
      row.run.columns = size.columns;
      row.bytes = size.bytes;
    }
    return sweep_json(frame("planned"), rows);
  }

  [[nodiscard]] std::string plan_text() const {
    std::string text;
    for (std::size_t i = 0; i < variations_.size(); ++i) {
      for (std::size_t product = 0; product < products_.size(); ++product) {
        const SweepRow& row = rows_[i * products_.size() + product];
        text += fmt::format("{}  {}  {}", variations_[i] + 1, sweep_->label(variations_[i]), row.file);
        if (row.done) {
          text += "  (done)\n";
        } else if (row.table) {
          text += "  geometry table\n";
        } else {
          const ProductSize& size = size_of(variations_[i], product);
          text += fmt::format("  {} x {} samples, {}\n", size.rows, size.columns, core::bytes_text(size.bytes));
        }
      }
    }
    return text;
  }

  // Nothing is begun where an output stands in the way.
  void expect_free_outputs() {
    const fs::path folder(arguments_.folder);
    if (fs::exists(folder) && !fs::is_directory(folder))
      throw core::Refused("'" + arguments_.folder + "' is not a folder",
                          "name a folder with --out; it is made when missing");
    core::Problems problems;
    std::size_t more = 0;
    const auto look_at = [&](const fs::path& path, bool replace) {
      for (core::Problem& problem : problems_of_output(path, {input_.sources, replace})) {
        if (problems.empty())
          problems.push_back(std::move(problem));
        else
          ++more;
      }
    };
    for (const SweepRow& row : rows_)
      if (!row.done && !arguments_.discard) look_at(beside(row.file), arguments_.force);
    for (const char* extension : {".csv", ".json", ".journal"})
      look_at(beside(part_stem() + extension), arguments_.force || arguments_.resume);
    if (problems.empty()) return;
    if (more > 0) problems.front().message = fmt::format("{}, and {} others", problems.front().message, more);
    if (!arguments_.force)
      problems.front().hint = arguments_.resume
                                  ? "it is not what this sweep would have made, or was changed since; replace with "
                                    "--force, or choose another folder with --out"
                                  : "replace with --force, go on with what is not done with --resume, or choose "
                                    "another folder with --out";
    throw core::Refused(std::move(problems));
  }

  // Variations at a time, and threads of each.
  [[nodiscard]] std::pair<unsigned, unsigned> shares() const {
    const auto wanted = static_cast<unsigned>(arguments_.jobs.value_or(0));
    const unsigned most = wanted > 0 ? wanted : threads_;
    const auto jobs = static_cast<unsigned>(std::clamp<std::size_t>(open_.size(), 1, most));
    return {jobs, std::max(1U, threads_ / jobs)};
  }

  void announce() const {
    if (arguments_.quiet) return;
    const auto [jobs, threads] = shares();
    std::string text = fmt::format("{}: {}", arguments_.scene, counted(sweep_->size(), "variation"));
    if (part_.count > 1) text += fmt::format(", {} in part {} of {}", variations_.size(), part_.index + 1, part_.count);
    if (open_.size() < variations_.size()) text += fmt::format(", {} done before", variations_.size() - open_.size());
    text += fmt::format(
        ", {} to run, {}, {}, {} at a time with {}\n", open_.size(), core::bytes_text(sum_of(&ProductSize::bytes)),
        core::about_duration_text(sum_of(&ProductSize::seconds) / (jobs * threads)), jobs, counted(threads, "thread"));
    streams_.err << text;
  }

  [[nodiscard]] std::size_t mean_samples() const {
    double samples = 0.0;
    for (const auto& sizes : checks_.sizes)
      for (const ProductSize& size : sizes)
        samples += static_cast<double>(size.rows) * static_cast<double>(size.columns);
    return static_cast<std::size_t>(samples / static_cast<double>(std::max<std::size_t>(open_.size(), 1)));
  }

  [[nodiscard]] ProgressDisplay::Style style() const {
    if (arguments_.quiet) return ProgressDisplay::Style::none;
    return streams_.terminal ? ProgressDisplay::Style::bar : ProgressDisplay::Style::lines;
  }

  void make_rows() {
    begin_s_ = core::now_s();
    fs::create_directories(arguments_.folder);
    SweepJournal journal(beside(part_stem() + ".journal"), arguments_.resume);
    const auto [jobs, threads] = shares();
    rules_.threads = threads;
    ProgressDisplay display(streams_.err, style(), "sweep");
    std::mutex lock;
    std::size_t finished = 0;
    const std::size_t samples = mean_samples();
    const auto told = [&](const SweepRow& row) {
      if (row.done) journal.add(row);
    };
    try {
      core::parallel_ranges(open_.size(), 1, {jobs, streams_.stop}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) make_variation(open_[i], told);
        const std::scoped_lock hold(lock);
        display.update({++finished, open_.size(), samples});
      });
    } catch (const core::Interrupted&) {
      if (!arguments_.quiet)
        streams_.err << fmt::format("sweep: {} of {} done; go on with --resume\n",
                                    variations_.size() - open_.size() + finished,
                                    counted(variations_.size(), "variation"));
      throw;
    }
  }

  void make_variation(std::size_t variation, const std::function<void(const SweepRow&)>& told) {
    const std::size_t place = (variation - part_.index) / part_.count;
    std::vector<SweepRow*> rows;
    for (std::size_t product = 0; product < products_.size(); ++product) {
      SweepRow& row = rows_[place * products_.size() + product];
      if (!row.done) rows.push_back(&row);
    }
    core::Problems none;  // `check_variations` has seen that there are none.
    run_variation(sweep_->scene(input_.scene, variation, none), products_, rows, rules_, streams_.stop, told);
  }

  [[nodiscard]] SweepFrame frame(const char* status) const {
    return {arguments_.scene, &*sweep_, &products_, status, &checks_.problems};
  }

  ExitStatus finish() {
    core::Problems failures;
    for (const SweepRow& row : rows_)
      if (!row.failure.empty()) {
        failures.push_back({});
        failures.back().message = fmt::format("{}: {}", sweep_->label(row.variation), row.failure);
      }
    const SweepFrame table = frame(failures.empty() ? "done" : "failed");
    const bool replace = arguments_.force || arguments_.resume;
    write_whole(beside(part_stem() + ".csv"), sweep_csv(table, rows_), replace);
    write_whole(beside(part_stem() + ".json"), sweep_json(table, rows_), replace);
    if (arguments_.json) write_out(streams_, sweep_json(table, rows_));
    if (!arguments_.quiet)
      streams_.err << fmt::format("{}: {} in {}\n", beside(part_stem() + ".csv").string(),
                                  counted(variations_.size(), "variation"),
                                  core::duration_text(core::now_s() - begin_s_));
    if (failures.empty()) return exit_done;
    print_problems(streams_, shortened(std::move(failures)));
    return exit_bad_input;
  }

  const SweepArguments& arguments_;
  Streams& streams_;
  SweepPart part_;
  unsigned threads_ = 1;
  VariationRules rules_;
  SceneInput input_;
  std::optional<Sweep> sweep_;
  std::vector<ProductJob> products_;
  std::vector<std::size_t> variations_;  // Of the part.
  std::vector<SweepRow> rows_;           // Of each of them, each product.
  std::vector<std::size_t> open_;        // Variations that something is left to do for.
  SweepChecks checks_;                   // Of these.
  double begin_s_ = 0.0;
};

}  // namespace

Action add_sweep(CLI::App& app) {
  auto arguments = std::make_shared<SweepArguments>();
  add_sweep_arguments(app, *arguments);
  add_examples(app, {{"sarsim sweep scene.scr --set seed=1..1000 --out runs", "a thousand noises"},
                     {"sarsim sweep scene.scr --set Radar1.bandwidth=10MHz:10MHz:100MHz --set seed=1..10 --dry-run",
                      "what a hundred combinations would be"},
                     {"sarsim sweep scene.scr --set 'Target1.x=1km,2km' --discard", "figures alone, no recordings"},
                     {"sarsim sweep scene.scr --fields", "what can be set"}});
  return [arguments](Streams& streams) { return Sweeper(*arguments, streams).run(); };
}

}  // namespace sarsim::cli
