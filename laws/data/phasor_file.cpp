#include "laws/data/phasor_file.hpp"

#include <numeric>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/plan/data_source.hpp"
#include "response/structure/frf_variances.hpp"

namespace jointid::laws {
namespace {

[[noreturn]] void fail(const ident::DataFile& file, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = file.path.string(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace

std::vector<frf::Dof> phasor_dofs(const ident::DataFile& file) { return ident::open_all({file}).front()->header().response; }

Phasors read_phasors(const ident::DataFile& file, const std::vector<frf::Dof>& dofs) {
  frf::FrfSystem system(file.path.string(), ident::open_all({file}), frf::Composition::merged, false);
  if (system.references().size() != 1) {
    fail(file, "references", "there are " + std::to_string(system.references().size()) + ", phasors of one state belong to one",
         "write the phasors of one level and harmonic to a file of their own");
  }
  for (const frf::Dof& dof : dofs) {
    if (frf::has(system.responses(), dof)) continue;
    const std::string nearest = nearest_word(dof.name(), frf::names(system.responses()));
    fail(file, "response " + dof.name(), "the file does not have it", nearest.empty() ? "" : "did you mean " + nearest + "?");
  }
  Phasors out;
  out.file = file.path.string();
  out.frequency_hz = system.frequency_hz();
  std::vector<std::size_t> lines(out.frequency_hz.size());
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  RowMatrixXc values(at(lines.size()), at(dofs.size()));
  frf::BlockReader(system, dofs, system.references())
      .read(lines, std::span(values.data(), static_cast<std::size_t>(values.size())));
  out.values = values;
  const std::vector<Eigen::MatrixXcd> variances = response::read_variances(system, dofs, system.references());
  if (variances.empty()) return out;
  out.variances.resize(out.values.rows(), out.values.cols());
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const Eigen::VectorXcd own = variances[line].col(0);
    out.variances.row(at(line)) = 0.5 * (own.real() + own.imag()).transpose();
  }
  return out;
}

}  // namespace jointid::laws
