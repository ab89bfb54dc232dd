#include "ident/plan/data_source.hpp"

#include "frf/noise/repeats.hpp"
#include "frf/set/corrections.hpp"
#include "virtualpoint/virtual_source.hpp"

namespace jointid::ident {
namespace {

std::unique_ptr<frf::FrfSource> open_run(const DataFile& file) {
  auto source = frf::corrected(frf::open(file.path, file.options), file.corrections);
  if (file.virtual_points.empty()) return source;
  return virtualpoint::virtual_source(std::move(source), file.virtual_points, file.virtual_noise);
}

std::unique_ptr<frf::FrfSource> open(const DataFile& file) {
  if (file.repeats.empty()) return open_run(file);
  std::vector<std::unique_ptr<frf::FrfSource>> runs;
  runs.push_back(open_run(file));
  for (const DataFile& run : file.repeats) runs.push_back(open_run(run));
  return frf::mean_of_repeats(std::move(runs));
}

}  // namespace

std::vector<std::unique_ptr<frf::FrfSource>> open_all(const std::vector<DataFile>& files) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  for (const DataFile& file : files) sources.push_back(open(file));
  return sources;
}

}  // namespace jointid::ident
