#include "workflow/sweep/sweep_plan.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/report/invalid_request.hpp"
#include "core/task/parallel.hpp"
#include "core/text/counted.hpp"
#include "core/text/number_text.hpp"
#include "raster/format/sinks.hpp"
#include "workflow/input/output_names.hpp"
#include "workflow/sweep/sweep_files.hpp"
#include "workflow/sweep/sweep_journal.hpp"
#include "workflow/sweep/sweep_run.hpp"

namespace sarsim::workflow {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t max_problems_told = 20;

std::vector<ProductJob> products_of(const SweepRequest& request) {
  const OutputNames names = output_names(request.scene, {".", false, request.format});
  if (core::has_errors(names.problems)) throw core::InvalidRequest(names.problems);
  std::vector<ProductJob> products = chosen_products(request.scene, names, request.products);
  if (!products.empty()) return products;
  core::InvalidRequest nothing("the script defines no recording or geometry table to vary",
                               "add a [[recording]] or a [[geometry]]; in a .scr, a $SIMULATION or a $GEOMETRY");
  nothing.problems.front().place.file = request.script;
  throw nothing;
}

void name_rows(const SweepRequest& request, SweepPlan& plan) {
  const VariationNames names(request.scene, plan.sweep, plan.products, variation_rules(request));
  const SweepPart& part = request.part;
  for (std::size_t variation = part.index; variation < plan.sweep.size(); variation += part.count) {
    plan.variations.push_back(variation);
    for (std::size_t product = 0; product < plan.products.size(); ++product)
      plan.rows.push_back(names.row(variation, product));
  }
  if (plan.variations.empty())
    throw core::InvalidRequest(fmt::format("--part: there are {} for {} parts, and none for part {}",
                                           core::counted(plan.sweep.size(), "variation"), part.count, part.index + 1),
                               "use no more parts than there are variations");
}

// Whether the file is there as it was written; of a sweep that discarded everything none is.
bool holds(const fs::path& file, const SweepRow& row) {
  const auto bytes = static_cast<double>(raster::stored_bytes(file));
  return row.written && bytes == row.bytes && modification_time(file) == row.written;
}

// Whether a recording was followed up as the request wants it, and what was made of it is there.
bool is_followed(const SweepRequest& request, const SweepRow& row) {
  if (!request.post_processing || row.table) return true;
  if (row.followed != mark_of(request.post_processing)) return false;
  if (request.discard) return true;
  const std::vector<fs::path> made =
      files_of(request.post_processing, fs::path(request.folder) / fs::path(row.file).stem());
  return std::ranges::all_of(made, [](const fs::path& file) {
    std::error_code none;
    return fs::exists(file, none);
  });
}

std::vector<std::size_t> open_variations(const SweepPlan& plan) {
  std::vector<std::size_t> open;
  for (const SweepRow& row : plan.rows)  // In the order of their variations.
    if (!row.done && (open.empty() || open.back() != row.variation)) open.push_back(row.variation);
  return open;
}

bool is_fatal(const core::Problems& problems, bool strict) {
  return core::has_errors(problems) || (strict && std::ranges::any_of(problems, [](const core::Problem& p) {
                                          return p.severity == core::Severity::warning;
                                        }));
}

void share_threads(const SweepRequest& request, unsigned threads, SweepPlan& plan) {
  const unsigned most = request.jobs > 0 ? request.jobs : threads;
  plan.jobs = static_cast<unsigned>(std::clamp<std::size_t>(plan.open.size(), 1, most));
  plan.threads = std::max(1U, threads / plan.jobs);
}

}  // namespace

void take_finished(const SweepRequest& request, std::vector<SweepRow>& rows) {
  if (!request.resume) return;
  const std::map<std::string, SweepRow> known = read_journals(request.folder, SweepFiles(request).stem());
  for (SweepRow& row : rows) {
    const auto found = known.find(row.file);
    if (found == known.end() || found->second.stamp != row.stamp) continue;
    row.begun = found->second.begun && !request.discard;
    if (!found->second.done) continue;
    if (!request.discard && !holds(fs::path(request.folder) / row.file, found->second)) continue;
    SweepRow done = found->second;
    done.variation = row.variation;
    done.product = row.product;
    if (!is_followed(request, done)) {
      if (request.discard) continue;
      done.done = false;
      done.recorded = true;
      done.figures.clear();
      done.followed.clear();
    }
    row = std::move(done);
  }
}

SweepPlan plan_sweep(const SweepRequest& request, const core::Observer& observer) {
  const unsigned threads = core::thread_count(request.threads);
  validate(request.post_processing);
  Sweep sweep(request.scene, request.values, {request.script, request.overrides, request.names, request.sources});
  SweepPlan plan{std::move(sweep), products_of(request)};
  if (request.post_processing && std::ranges::all_of(plan.products, &ProductJob::table))
    throw core::InvalidRequest(
        fmt::format("--{}: no recording is made that it could process", word_of(request.post_processing.kind)),
        "choose a recording");
  name_rows(request, plan);
  take_finished(request, plan.rows);
  plan.open = open_variations(plan);
  share_threads(request, threads, plan);
  plan.checks =
      check_sweep({request.scene, request.places, plan.sweep, plan.products, plan.open, request.counts, request.engine},
                  observer.control(threads));
  core::append(plan.checks.problems, plan.sweep.remarks(request.scene));
  plan.refused = is_fatal(plan.checks.problems, request.strict);
  if (!plan.refused) observer.remarks(shortened(plan.checks.problems));
  return plan;
}

void expect_sound(const SweepPlan& plan) {
  if (plan.refused) throw core::InvalidRequest(shortened(plan.checks.problems));
}

const ProductSize& size_of(const SweepPlan& plan, std::size_t variation, std::size_t product) {
  const auto open = std::ranges::lower_bound(plan.open, variation);
  return plan.checks.sizes.at(static_cast<std::size_t>(open - plan.open.begin())).at(product);
}

std::string announcement(const SweepRequest& request, const SweepPlan& plan) {
  const std::size_t all = plan.variations.size();
  const std::size_t open = plan.open.size();
  const SweepPart& part = request.part;
  std::string text = fmt::format("{}: {}", request.script, core::counted(plan.sweep.size(), "variation"));
  if (part.count > 1) text += fmt::format(", {} in part {} of {}", all, part.index + 1, part.count);
  if (open < all) text += fmt::format(", {} done before", all - open);
  const double seconds = sum_of(plan.checks, &ProductSize::seconds) / (plan.jobs * plan.threads);
  return text + fmt::format(", {} to run, {}, {}, {} at a time with {}", open,
                            core::bytes_text(sum_of(plan.checks, &ProductSize::bytes)),
                            core::about_duration_text(seconds), plan.jobs, core::counted(plan.threads, "thread"));
}

SweepFrame frame_of(const SweepRequest& request, const SweepPlan& plan, std::string status) {
  return {request.script, &plan.sweep, &plan.products, std::move(status), &plan.checks.problems};
}

core::Problems shortened(core::Problems problems) {
  if (problems.size() <= max_problems_told) return problems;
  core::Problem rest =
      core::note(fmt::format("{} more of this kind are not shown", problems.size() - max_problems_told))
          .hint("vary less at once to see all of them");
  problems.resize(max_problems_told);
  problems.push_back(std::move(rest));
  return problems;
}

}  // namespace sarsim::workflow
