#include "gui/runs/product_kind.hpp"

#include <QCoreApplication>

#include <filesystem>
#include <utility>

#include "workflow/focus/focus.hpp"
#include "workflow/focus/focus_options.hpp"
#include "workflow/search/search_options.hpp"
#include "workflow/stepped/isar_options.hpp"
#include "workflow/stepped/profiles_options.hpp"

namespace sarsim::gui {

namespace {

std::vector<std::filesystem::path> images_of(const workflow::FocusReport& /*report*/,
                                             const workflow::FocusRequest& request) {
  return {request.output};
}

std::vector<std::filesystem::path> images_of(const workflow::ProfilesReport& report,
                                             const workflow::ProfilesRequest& /*request*/) {
  return {report.output};
}

std::vector<std::filesystem::path> images_of(const workflow::IsarReport& report,
                                             const workflow::IsarRequest& /*request*/) {
  std::vector<std::filesystem::path> images;
  for (const workflow::WrittenIsarImage& image : report.images) images.push_back(image.file);
  return images;
}

std::vector<std::filesystem::path> images_of(const workflow::PulseReport& /*report*/,
                                             const workflow::PulseRequest& request) {
  if (!request.image) return {};
  return {request.output};
}

// The report stays on the worker's thread, with what of it is on disk.
template <auto workflow_of, class Request>
ProductJob::Work work_of(Request request) {
  return [request = std::move(request)](const core::Observer& observer) {
    const auto report = workflow_of(request, observer);
    return ProductResult{images_of(report, request), picture::pages_of(report), report.problems};
  };
}

const std::vector<ProductKind>& all_kinds() {
  using Words = workflow::GivenWords;
  using std::string;
  static const std::vector<ProductKind> kinds{
      {"focus",
       QT_TRANSLATE_NOOP("ProductKind", "Focused image (synthetic aperture)"),
       "--algorithm",
       QT_TRANSLATE_NOOP("ProductKind", "Algorithm"),
       {"omega-k", "range-doppler", "chirp-scaling", "back-projection"},
       [] { return workflow::focus_option_table().options(); },
       [](const string& script, const Words& words) {
         return work_of<workflow::focus>(workflow::focus_request(script, words));
       }},
      {"profiles",
       QT_TRANSLATE_NOOP("ProductKind", "Range profiles of stepped frequencies"),
       "--group",
       QT_TRANSLATE_NOOP("ProductKind", "A profile for"),
       {"bursts", "scans", "encounter"},
       [] { return workflow::profiles_option_table().options(); },
       [](const string& script, const Words& words) {
         return work_of<workflow::profiles>(workflow::profiles_request(script, words));
       }},
      {"isar",
       QT_TRANSLATE_NOOP("ProductKind", "ISAR image"),
       "--algorithm",
       QT_TRANSLATE_NOOP("ProductKind", "Algorithm"),
       {"range-doppler", "back-projection"},
       [] { return workflow::isar_option_table().options(); },
       [](const string& script, const Words& words) {
         return work_of<workflow::isar>(workflow::isar_request(script, words));
       }},
      {"doppler",
       QT_TRANSLATE_NOOP("ProductKind", "Range-Doppler maps"),
       "--canceller",
       QT_TRANSLATE_NOOP("ProductKind", "Canceller"),
       {"none", "two", "three"},
       [] { return workflow::doppler_option_table().options(); },
       [](const string& script, const Words& words) {
         return work_of<workflow::doppler>(workflow::doppler_request(script, words));
       }},
      {"search",
       QT_TRANSLATE_NOOP("ProductKind", "PPI (search radar)"),
       "--canceller",
       QT_TRANSLATE_NOOP("ProductKind", "Canceller"),
       {"none", "two", "three"},
       [] { return workflow::search_option_table().options(); },
       [](const string& script, const Words& words) {
         return work_of<workflow::search>(workflow::search_request(script, words));
       }}};
  return kinds;
}

}  // namespace

std::span<const ProductKind> product_kinds() { return all_kinds(); }

}  // namespace sarsim::gui
