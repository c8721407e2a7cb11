#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "workflow/focus/focus_options.hpp"
#include "workflow/focus/focus_report.hpp"
#include "workflow/search/search_options.hpp"
#include "workflow/search/search_report.hpp"
#include "workflow/stepped/isar_options.hpp"
#include "workflow/stepped/profiles_options.hpp"
#include "workflow/stepped/stepped_report.hpp"

/// The products that are made of echoes: one table for the command line, the workbench and the C interface, which ask
/// `facts_of` for what a report says.
namespace sarsim::workflow {

/// How a product is asked for and made.
template <class Request, class Report>
struct Product {
  const char* name;  ///< Of the command.
  OptionTable<Request> (*options)();
  /// @param input  as the command takes it
  Request (*request)(const std::string& input, const GivenWords& given);
  /// Makes it, and writes what the request asks for.
  Report (*make)(const Request& request, const core::Observer& observer);
};

/// What a product is made of tells its kinds.
template <class Request, class Report>
Product(const char*, OptionTable<Request> (*)(), Request (*)(const std::string&, const GivenWords&),
        Report (*)(const Request&, const core::Observer&)) -> Product<Request, Report>;

inline constexpr Product focus_product{"focus", focus_option_table, focus_request, focus};
inline constexpr Product profiles_product{"profiles", profiles_option_table, profiles_request, profiles};
inline constexpr Product isar_product{"isar", isar_option_table, isar_request, isar};
inline constexpr Product doppler_product{"doppler", doppler_option_table, doppler_request, doppler};
inline constexpr Product search_product{"search", search_option_table, search_request, search};

/// All of them, as lists show them.
inline constexpr std::tuple products{focus_product, profiles_product, isar_product, doppler_product, search_product};

/// Lets what no name was given for stay in memory.
void keep_unnamed(FocusRequest& request, const GivenWords& given);
template <class Request>
void keep_unnamed(Request& request, const GivenWords& /*given*/) {
  request.keep = true;
}

/// An image that was made.
struct MadeImage {
  std::filesystem::path file;           ///< As it is named.
  std::optional<InMemoryImage> kept{};  ///< Where it was not written.
};

/// The images of a report, which gives those in memory away.
[[nodiscard]] std::vector<MadeImage> take_images(FocusReport& report, const FocusRequest& request);
[[nodiscard]] std::vector<MadeImage> take_images(ProfilesReport& report, const ProfilesRequest& request);
[[nodiscard]] std::vector<MadeImage> take_images(IsarReport& report, const IsarRequest& request);
[[nodiscard]] std::vector<MadeImage> take_images(PulseReport& report, const PulseRequest& request);

/// The tables of a report, as comma-separated values: the scene's targets in a profile, detections.
[[nodiscard]] std::vector<std::string> tables_of(const FocusReport& report);
[[nodiscard]] std::vector<std::string> tables_of(const ProfilesReport& report);
[[nodiscard]] std::vector<std::string> tables_of(const IsarReport& report);
[[nodiscard]] std::vector<std::string> tables_of(const PulseReport& report);

}  // namespace sarsim::workflow
