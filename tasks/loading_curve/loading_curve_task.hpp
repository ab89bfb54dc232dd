#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace jointid::tasks {

/// What is to be fitted to which columns of which files, in the words of `jointid loading-curve`.
struct LoadingCurveTask {
  std::vector<std::filesystem::path> files;
  std::string displacement, force, time;    ///< names or numbers of columns; empty: by the words in their names
  std::string energy, stiffness, damping;   ///< columns of amplitude series
  std::string unit, force_unit, time_unit;  ///< empty: as the header says, else SI
  std::string sign = "auto";                ///< auto, 1 or -1
  bool velocity = false;                    ///< the displacement column is a velocity
  std::string kind = "auto";                ///< auto, loading or loops
  std::vector<std::string> laws;            ///< empty: all
  std::vector<double> ring;                 ///< inner and outer radius, m; empty: translational
  std::vector<double> normal_loads;         ///< none, one for all, or one per file
  std::optional<double> limit;              ///< N or N·m
  bool friction_coefficient = false;
  std::vector<std::string> shared;
  std::optional<double> specimen_stiffness;  ///< N/m
  std::filesystem::path specimen;            ///< a loading curve, columns and units as FILE
  std::string weighting = "largest", minimiser = "best";
  std::optional<std::size_t> slopes;  ///< u(h) from slopes over so many samples is asked for
};

/// Throws InputError (usage) for a task that cannot be carried out, as far as it can be seen without the data.
void check(const LoadingCurveTask& task);

}  // namespace jointid::tasks
