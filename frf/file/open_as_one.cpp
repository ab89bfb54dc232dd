#include "frf/file/open_as_one.hpp"

#include "frf/set/merged_set.hpp"

namespace jointid::frf {

OpenOptions options_of_file(const OpenOptions& options, std::size_t k, std::size_t count) {
  OpenOptions own = options;
  const auto choose = [&](std::vector<Dof>& dofs) {
    if (count > 1 && dofs.size() == count) dofs = {Dof(dofs[k])};
  };
  choose(own.response);
  choose(own.reference);
  return own;
}

std::unique_ptr<FrfSource> open_as_one(const std::vector<std::filesystem::path>& files, const OpenOptions& options) {
  if (files.size() == 1) return open(files.front(), options);
  std::vector<FrfSet> sets;
  for (std::size_t k = 0; k < files.size(); ++k) {
    sets.push_back(load_with_covariance(*open(files[k], options_of_file(options, k, files.size()))));
  }
  return from_memory(merged(std::move(sets)));
}

}  // namespace jointid::frf
