#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "frf/file/write.hpp"
#include "frf/set/frf_source.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"

using namespace jointid;

/// Whether the module of HDF5 files is found: a set is read as it was written.
bool reads_hdf5(const frf::FrfSet& set, const std::filesystem::path& folder) {
  frf::write(set, folder / "assembly.h5");
  return frf::load(*frf::open(folder / "assembly.h5")).values == set.values;
}

/// Solves a built-in problem without noise: the unknowns must come out as they went in.
int main(int, char** arguments) {
  const auto problem = problems::make("A1");
  const auto scene = ident::parse_scene(problem.scene, "A1.toml");
  const auto plan = ident::make_plan(scene, problem.substructures, {problem.assembly});
  const auto solution = ident::solve(*plan);
  std::cout << ident::name(solution.status) << ", rms relative error of K "
            << solution.quality.at(restrictions::Kind::stiffness).rms_relative_error << '\n';
  const bool exact = solution.quality.at(restrictions::Kind::stiffness).rms_relative_error < 1e-6;
  return solution.status == ident::Status::ok && exact && reads_hdf5(problem.assembly, arguments[1]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
