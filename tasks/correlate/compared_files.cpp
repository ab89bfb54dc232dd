#include "tasks/correlate/compared_files.hpp"

#include <memory>
#include <numeric>

#include "base/error.hpp"
#include "frf/file/open_as_one.hpp"
#include "models/model_file.hpp"
#include "tasks/correlate/modes_of_result.hpp"
#include "tasks/json_file.hpp"
#include "tasks/source_doubts.hpp"

namespace jointid::tasks {
namespace {

using Path = std::filesystem::path;

frf::FrfSet read_frfs(const Path& file, std::vector<std::string>& notes) {
  const std::unique_ptr<frf::FrfSource> source = frf::open_as_one({file});
  for (const std::string& doubt : source_doubts(*source)) notes.push_back(file.filename().string() + ": " + doubt);
  return frf::load(*source);
}

/// At the lines of `beside`: between all coordinates, or of a large model between those of `beside`.
frf::FrfSet frfs_of_model(const Path& file, const frf::FrfHeader& beside) {
  constexpr std::size_t most = 300;
  const auto model = models::open_model(file, beside.frequency_hz);
  const frf::FrfHeader& header = model->header();
  if (header.response.size() <= most) return frf::load(*model);
  std::vector<std::size_t> places, lines(beside.frequency_hz.size());
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  for (std::size_t k = 0; k < header.response.size(); ++k) {
    if (frf::has(beside.response, header.response[k]) || frf::has(beside.reference, header.response[k])) places.push_back(k);
  }
  return frf::load(*model, {lines, places, places});
}

frf::FrfSet read_beside(const Path& file, const frf::FrfHeader& beside, std::vector<std::string>& notes) {
  return models::is_model_file(file) ? frfs_of_model(file, beside) : read_frfs(file, notes);
}

}  // namespace

ComparedFrfs read_compared(const Path& one, const Path& other) {
  if (models::is_model_file(one) && models::is_model_file(other)) {
    throw InputError({ErrorKind::usage, one.string(), "", "both files describe models, which have every frequency",
                      "give FRFs of one of them, at the lines that are to be compared"});
  }
  std::vector<std::string> notes;
  if (models::is_model_file(one)) {
    frf::FrfSet measured = read_frfs(other, notes);
    return {frfs_of_model(one, measured.header), std::move(measured), std::move(notes)};
  }
  frf::FrfSet measured = read_frfs(one, notes);
  frf::FrfSet second = read_beside(other, measured.header, notes);
  return {std::move(measured), std::move(second), std::move(notes)};
}

correlation::ModeFile read_modes(const Path& file) {
  return {file.string(), is_json_file(file) ? modes_of_result(file) : frf::read_uff55(file)};
}

ExpandedFiles expanded_files(const Path& parent, const Path& measured, const std::string& way, std::size_t modes) {
  std::vector<std::string> notes;
  const frf::FrfSet set = read_frfs(measured, notes);
  if (way == "serep") return {correlation::expanded(read_modes(parent), set, modes), std::move(notes)};
  const auto semm = way == "semm" ? correlation::Semm::basic : correlation::Semm::extended;
  const frf::FrfSet of_parent = read_beside(parent, set.header, notes);
  return {correlation::expanded(of_parent, set, semm), std::move(notes)};
}

std::vector<ident::NamedFile> compared_inputs(const Path& file, const std::string& place) {
  std::vector<ident::NamedFile> all = {{file, place}};
  if (models::is_model_file(file)) {
    for (const Path& named : models::files_of_model(file)) all.push_back({named, place + ", " + file.filename().string()});
  }
  return all;
}

}  // namespace jointid::tasks
