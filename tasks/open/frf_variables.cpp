#include "tasks/open/frf_variables.hpp"

#include "frf/mat/several_variables.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::tasks {

std::vector<std::string> frf_variables(const std::filesystem::path& file) {
  try {
    frf::open(file);
  } catch (const frf::SeveralVariables& several) {
    return several.names();
  } catch (const InputError&) {
    return {};
  }
  return {};
}

}  // namespace jointid::tasks
