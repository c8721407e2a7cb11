#include "gui/runs/product_kind.hpp"

#include <QCoreApplication>

#include <utility>

#include "workflow/product/products.hpp"

namespace sarsim::gui {

namespace {

// The report stays on the worker's thread, with what of it is on disk.
template <class Request, class Report>
ProductJob::Work work_of(const workflow::Product<Request, Report>& product, Request request) {
  return [product, request = std::move(request)](const core::Observer& observer) {
    Report report = product.make(request, observer);
    ProductResult result{{}, picture::pages_of(report), report.problems};
    for (const workflow::MadeImage& image : workflow::take_images(report, request)) result.images.push_back(image.file);
    return result;
  };
}

template <class Request, class Report>
ProductKind kind_of(const workflow::Product<Request, Report>& product, const char* title, const char* option,
                    const char* option_title, std::vector<const char*> values) {
  return {product.name,
          title,
          option,
          option_title,
          std::move(values),
          [product] { return product.options().options(); },
          [product](const std::string& script, const workflow::GivenWords& words) {
            return work_of(product, product.request(script, words));
          }};
}

const std::vector<ProductKind>& all_kinds() {
  static const std::vector<ProductKind> kinds{
      kind_of(workflow::focus_product, QT_TRANSLATE_NOOP("ProductKind", "Focused image (synthetic aperture)"),
              "--algorithm", QT_TRANSLATE_NOOP("ProductKind", "Algorithm"),
              {"omega-k", "range-doppler", "chirp-scaling", "back-projection"}),
      kind_of(workflow::profiles_product, QT_TRANSLATE_NOOP("ProductKind", "Range profiles of stepped frequencies"),
              "--group", QT_TRANSLATE_NOOP("ProductKind", "A profile for"), {"bursts", "scans", "encounter"}),
      kind_of(workflow::isar_product, QT_TRANSLATE_NOOP("ProductKind", "ISAR image"), "--algorithm",
              QT_TRANSLATE_NOOP("ProductKind", "Algorithm"), {"range-doppler", "back-projection"}),
      kind_of(workflow::doppler_product, QT_TRANSLATE_NOOP("ProductKind", "Range-Doppler maps"), "--canceller",
              QT_TRANSLATE_NOOP("ProductKind", "Canceller"), {"none", "two", "three"}),
      kind_of(workflow::search_product, QT_TRANSLATE_NOOP("ProductKind", "PPI (search radar)"), "--canceller",
              QT_TRANSLATE_NOOP("ProductKind", "Canceller"), {"none", "two", "three"})};
  return kinds;
}

}  // namespace

std::span<const ProductKind> product_kinds() { return all_kinds(); }

}  // namespace sarsim::gui
