#include "laws/data/phasor_file.hpp"

#include <numeric>
#include <span>

#include "base/eigen.hpp"
#include "base/error.hpp"
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

void require_dofs(const ident::DataFile& file, const frf::FrfSystem& system, const std::vector<frf::Dof>& dofs) {
  if (system.references().size() != 1) {
    fail(file, "references", "there are " + std::to_string(system.references().size()) + ", phasors of one state belong to one",
         "write the phasors of one level and harmonic to a file of their own");
  }
  for (const frf::Dof& dof : dofs) {
    if (frf::has(system.responses(), dof)) continue;
    const std::string nearest = nearest_word(dof.name(), frf::names(system.responses()));
    fail(file, "response " + dof.name(), "the file does not have it", nearest.empty() ? "" : "did you mean " + nearest + "?");
  }
}

Phasors phasors_of(frf::FrfSystem& system, const std::vector<frf::Dof>& dofs) {
  Phasors out;
  out.file = system.name();
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

}  // namespace

PhasorFiles::PhasorFiles() : opener_(ident::open_all) {}

PhasorFiles::Opened& PhasorFiles::opened(const ident::DataFile& file) {
  Opened& found = files_[{file.path, file.options.quantity, file.options.spectra}];
  if (!found.system) found.system.emplace(file.path.string(), opener_({file}), frf::Composition::merged, false);
  return found;
}

const std::vector<frf::Dof>& PhasorFiles::dofs(const ident::DataFile& file) { return opened(file).system->responses(); }

std::shared_ptr<const Phasors> PhasorFiles::read(const ident::DataFile& file, const std::vector<frf::Dof>& dofs) {
  Opened& found = opened(file);
  if (found.phasors && found.dofs == dofs) return found.phasors;
  require_dofs(file, *found.system, dofs);
  found.phasors = std::make_shared<const Phasors>(phasors_of(*found.system, dofs));
  found.dofs = dofs;
  return found.phasors;
}

}  // namespace jointid::laws
