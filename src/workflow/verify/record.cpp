#include "workflow/verify/record.hpp"

#include <cmath>
#include <exception>
#include <utility>

namespace sarsim::workflow::verify {

void Record::group(const std::string& name, const std::function<void(Record&)>& measure) {
  if (rules_.stop != nullptr && rules_.stop->requested()) throw core::Interrupted();
  group_ = name;
  try {
    measure(*this);
  } catch (const core::Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    Finding finding;
    finding.name = "can be measured";
    finding.failure = error.what();
    finding.group = group_;
    findings_.push_back(std::move(finding));
  }
}

void Record::near(const std::string& name, const std::string& unit, double expected, double measured, double tolerance,
                  const std::string& source) {
  add({{},
       name,
       unit,
       source,
       Bound::near,
       expected,
       measured,
       tolerance,
       std::abs(measured - expected) <= tolerance,
       {}});
}

void Record::at_most(const std::string& name, const std::string& unit, double most, double measured,
                     const std::string& source) {
  add({{}, name, unit, source, Bound::at_most, most, measured, 0.0, measured <= most, {}});
}

void Record::at_least(const std::string& name, const std::string& unit, double least, double measured,
                      const std::string& source) {
  add({{}, name, unit, source, Bound::at_least, least, measured, 0.0, measured >= least, {}});
}

void Record::chart(Chart chart) {
  chart.group = group_;
  charts_.push_back(std::move(chart));
}

void Record::add(Finding finding) {
  finding.group = group_;
  findings_.push_back(std::move(finding));
}

}  // namespace sarsim::workflow::verify
