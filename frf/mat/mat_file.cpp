#include "frf/mat/mat_file.hpp"

#include <set>
#include <string_view>

#include "base/error.hpp"
#include "frf/mat/mat_lookup.hpp"
#include "frf/mat/mat_reader.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

std::unique_ptr<FrfSource> open_mat(const std::unique_ptr<MatFile>& file, const OpenOptions& options) {
  return from_memory(read_mat_frfs(*file, options));
}

}  // namespace

const std::multimap<std::string, const MatInfo*>& MatFile::by_lower_name() const {
  if (by_lower_name_.size() != variables_.size()) {
    by_lower_name_.clear();
    for (const MatInfo& info : variables_) by_lower_name_.emplace(lower_case(info.name), &info);
  }
  return by_lower_name_;
}

MatVariable MatFile::read(const MatInfo& info) {
  MatVariable variable = read_variable(info);
  if (info.kind != MatKind::real && info.kind != MatKind::complex) return variable;
  std::size_t size = 1;
  for (const std::size_t extent : info.dims) size *= extent;
  if (variable.values.size() != size)
    fail(info.name, "holds " + std::to_string(variable.values.size()) + " numbers where its size states " + std::to_string(size),
         "the file is damaged; save it again");
  return variable;
}

void MatFile::require_distinct_names() const {
  std::set<std::string_view> known;
  for (const MatInfo& info : variables_) {
    if (!info.name.empty() && !known.insert(info.name).second)
      fail(info.name, "is there twice, and the file does not state which of the two holds",
           "save the variables again, each with a name of its own");
  }
}

std::string MatFile::note(const MatInfo*, std::string_view) { return {}; }

std::vector<std::pair<std::string, std::string>> MatFile::notes(const MatInfo&) { return {}; }

std::vector<std::string> MatFile::scales(const MatInfo&) { return {}; }

std::vector<double> MatFile::read_samples(const MatInfo& info, std::size_t, std::size_t) {
  fail(info.name, "cannot be read in parts");
}

void MatFile::fail(const std::string& variable, std::string problem, std::string remedy) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = file_,
                    .place = variable.empty() ? std::string() : place_of(variable),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

std::unique_ptr<FrfSource> open_mat_v5(const std::filesystem::path& path, const OpenOptions& options) {
  return open_mat(open_mat_variables_v5(path), options);
}

std::unique_ptr<FrfSource> open_mat_v73(const std::filesystem::path& path, const OpenOptions& options) {
  return open_mat(open_mat_variables_v73(path), options);
}

}  // namespace jointid::frf
