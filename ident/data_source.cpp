#include "ident/data_source.hpp"

#include "frf/repeats.hpp"

namespace jointid::ident {
namespace {

std::unique_ptr<frf::FrfSource> open(const DataFile& file) {
  if (file.repeats.empty()) return frf::open(file.path, file.options);
  std::vector<std::unique_ptr<frf::FrfSource>> runs;
  runs.push_back(frf::open(file.path, file.options));
  for (const DataFile& run : file.repeats) runs.push_back(frf::open(run.path, run.options));
  return frf::mean_of_repeats(std::move(runs));
}

}  // namespace

std::vector<std::unique_ptr<frf::FrfSource>> open_all(const std::vector<DataFile>& files) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  for (const DataFile& file : files) sources.push_back(open(file));
  return sources;
}

}  // namespace jointid::ident
