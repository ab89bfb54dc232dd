#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "oscillation/measurement/friction_record.hpp"
#include "records/file/read_series.hpp"

namespace jointid::tasks {

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
struct ContactResult {
  std::string file;
  std::vector<double> velocity, force, normal;  ///< m/s, N, N
  std::size_t missing = 0;                      ///< samples that are left out
  oscillation::FrictionLaw law;
};

/// Reads the channels and fits the law. Stages "reading samples" and "law". Throws InputError, and Interrupted between them.
ContactResult run_contact(const ContactTask& task, const ident::Control& control = {});

/// The same of a record in memory with the channels velocity, force and, where the task has no load, normal; the task's file,
/// columns and rate are not used.
ContactResult run_contact(const ContactTask& task, records::SeriesRecord record);

}  // namespace jointid::tasks
