#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "records/file/sample_stream.hpp"
#include "report/page/contents.hpp"
#include "report/text/table.hpp"
#include "series/measurement/strain.hpp"

namespace jointid::report {

/// Displacements of a clamped beam from strain gauges, as they are asked for.
struct StrainTask {
  std::filesystem::path file;
  std::vector<std::string> channels;     ///< of the gauges; empty: all but the time
  double length = 0.0, thickness = 0.0;  ///< m
  std::vector<double> gauges, points;    ///< m from the clamp; no points: the tip
  std::size_t shapes = 0;                ///< 0: as many as gauges
  bool static_shapes = false;            ///< two of them are of a tip force and a tip moment
};

struct StrainReport {
  StrainTask task;  ///< points and shapes filled in
  series::StrainMap map;
};

/// The map; reads nothing. Throws InputError.
StrainReport strain_report(const StrainTask& task);

/// The gauges' channels. Throws InputError where they are not as many as the gauges.
std::unique_ptr<records::SampleStream> open_gauges(const StrainTask& task);

/// Displacements of all samples of the gauges a block at a time, as CSV: "y(0.4) [m],…" and a row a sample. Returns how many
/// samples there were. Throws InputError, and Interrupted.
std::size_t write_displacements(const StrainReport& report, records::SampleStream& gauges,
                                const std::function<void(const std::string& text)>& write,
                                const std::function<bool()>& interrupted);

/// That nothing shows a wrong gauge, where there are as many shapes as gauges; that the shapes are hard to tell apart.
std::vector<std::string> strain_remarks(const StrainReport& report);
/// Points, and what errors of the strains do to them.
Table strain_table(const StrainReport& report);
/// Displacements of the first samples, which it reads. Throws InputError.
PlotGroup strain_plots(const StrainReport& report);
/// "4 gauges, 4 shapes, condition 12."
std::string strain_summary(const StrainReport& report);

/// For people.
std::string strain_text(const StrainReport& report);
/// The keys stay.
std::string strain_json(const StrainReport& report);
/// The page of `jointid series strain` with its strain_plots().
std::string strain_page(const StrainReport& report, const PlotGroup& plots);

}  // namespace jointid::report
