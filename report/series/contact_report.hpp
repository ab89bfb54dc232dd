#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"
#include "series/measurement/friction_record.hpp"

namespace jointid::report {

/// The friction law of a contact from a stick–slip record, as it is asked for.
struct ContactTask {
  std::filesystem::path file;
  std::string velocity, force, normal;  ///< columns
  double load = 0.0;                    ///< N where there is no column of it
  double stick_speed = 0.0;             ///< m/s
  std::optional<double> rate_hz;
  double force_delay = 0.0;  ///< s by which the force is late
};

/// The law, and the samples it was found from: those that are there in all channels.
struct ContactReport {
  std::string file;
  std::vector<double> velocity, force, normal;
  std::size_t missing = 0;
  series::FrictionLaw law;
};

/// Throws InputError.
ContactReport contact_report(const ContactTask& task);

std::vector<std::string> contact_remarks(const ContactReport& report);
Table contact_table(const ContactReport& report);
/// The coefficient over the relative velocity, and the law.
PlotGroup contact_law_plots(const ContactReport& report);
/// "A law that falls with speed."
std::string contact_summary(const ContactReport& report);

/// For people.
std::string contact_text(const ContactReport& report);
/// The keys stay.
std::string contact_json(const ContactReport& report);
/// "relative velocity [m/s],friction coefficient": a row a sample.
std::string contact_csv(const ContactReport& report);
/// The page of `jointid series friction`.
std::string contact_page(const ContactReport& report);

}  // namespace jointid::report
