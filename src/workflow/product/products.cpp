#include "workflow/product/products.hpp"

#include <fstream>
#include <sstream>
#include <utility>

namespace sarsim::workflow {

void keep_unnamed(FocusRequest& request, const GivenWords& given) {
  if (!given.contains("--out")) request.output.clear();
}

std::vector<MadeImage> take_images(FocusReport& report, const FocusRequest& request) {
  std::vector<MadeImage> images{{request.output}};
  if (request.output.empty()) images.front().kept = in_memory_image(report);
  return images;
}

std::vector<MadeImage> take_images(ProfilesReport& report, const ProfilesRequest& /*request*/) {
  return {{report.output, std::exchange(report.kept, std::nullopt)}};
}

std::vector<MadeImage> take_images(IsarReport& report, const IsarRequest& /*request*/) {
  std::vector<MadeImage> images;
  for (WrittenIsarImage& image : report.images) images.push_back({image.file, std::exchange(image.kept, std::nullopt)});
  return images;
}

std::vector<MadeImage> take_images(PulseReport& report, const PulseRequest& request) {
  if (!request.image) return {};
  return {{request.output, std::exchange(report.kept, std::nullopt)}};
}

std::vector<std::string> tables_of(const FocusReport& /*report*/) { return {}; }

std::vector<std::string> tables_of(const ProfilesReport& report) { return {csv_of(report.targets)}; }

std::vector<std::string> tables_of(const IsarReport& /*report*/) { return {}; }

std::vector<std::string> tables_of(const PulseReport& report) {
  if (!report.options.detect) return {};
  if (report.table.empty()) return {report.kept_table};
  const std::ifstream file(report.table, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return {text.str()};
}

}  // namespace sarsim::workflow
