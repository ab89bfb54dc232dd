#include "ident/check/trial/group_trials.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "ident/check/test/reference_groups.hpp"
#include "ident/check/trial/trials.hpp"

namespace jointid::ident {
namespace {

using Files = std::vector<CheckedFile>;

/// The references of an assembly file whose columns leave much.
Dofs references_that_differ(const Files& files, std::size_t file, const std::vector<SpanSetup>& setups,
                            const Screening& screening) {
  std::vector<double> levels(files[file].references.size(), 0.0);
  for (std::size_t s = 0; s < setups.size(); ++s) {
    if (setups[s].assembly != file || setups[s].transposed || screening.span[s].lines == 0) continue;
    std::vector<Eigen::Index> columns = setups[s].assembly_columns;
    columns.insert(columns.end(), setups[s].outer_columns.begin(), setups[s].outer_columns.end());
    const double level = screening.span[s].level;
    for (std::size_t c = 0; c < columns.size(); ++c)
      levels[static_cast<std::size_t>(columns[c])] += level * level * screening.span[s].column[c];
  }
  std::vector<double> tested;
  Dofs dofs;
  for (std::size_t c = 0; c < levels.size(); ++c) {
    if (!(levels[c] > 0.0)) continue;
    tested.push_back(levels[c]);
    dofs.push_back(files[file].references[c]);
  }
  Dofs out;
  for (const std::size_t c : upper_group(tested)) out.push_back(dofs[c]);
  return out;
}

void put_back(CheckedFile& whole, const CheckedFile& part) {
  for (std::size_t c = 0; c < part.references.size(); ++c) {
    const Eigen::Index to = at(place_of(whole.references, part.references[c]));
    for (std::size_t l = 0; l < whole.frfs.size(); ++l) whole.frfs[l].col(to) = part.frfs[l].col(at(c));
  }
}

/// Lines for the scene that mend it for these references; where the scene has no key for that, those for a file of their own.
std::string remedy_for(const MistakeTrial& trial, const std::string& file, const Dofs& references) {
  const std::string names = comma_list(references, quoted_dof);
  if (trial.kind == SuspectKind::sign && trial.dofs.empty()) return trial.remedy;
  return "# of the references " + names + " alone: write them to a file of their own, and\n# there, in place of " + file +
         ":\n" + trial.remedy;
}

MistakeTrial in_group(MistakeTrial trial, const std::string& file, const Dofs& references) {
  const std::size_t f = trial.files.front();
  trial.in_others = [trial, file](const Dofs& others) { return in_group(trial, file, others); };
  trial.references = references;
  trial.remedy = remedy_for(trial, file, references);
  trial.what = "for the references " + group_text(references) + " alone, " + trial.what;
  if (trial.dofs.empty()) trial.dofs = references;
  trial.undo = [f, references, undo = std::move(trial.undo)](Files& all) {
    Files alone(all.size());
    alone[f] = part_of(all[f], all[f].responses, references);
    undo(alone);
    put_back(all[f], alone[f]);
  };
  return trial;
}

}  // namespace

std::vector<MistakeTrial> group_trials(const Files& files, const Dofs& joint, const std::vector<SpanSetup>& setups,
                                       const Screening& screening, std::size_t threads) {
  std::vector<MistakeTrial> out;
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (!files[f].assembly) continue;
    const Dofs references = references_that_differ(files, f, setups, screening);
    if (references.empty()) continue;
    Files with_group = files;
    with_group[f] = part_of(files[f], files[f].responses, references);
    const std::vector<SpanSetup> group_setups = span_setups(with_group, joint);
    Screening of_group = screen(with_group, group_setups, threads);
    of_group.chosen_from = screening.chosen_from * static_cast<double>(1 + files[f].references.size());  // cuts of their order
    const Misfit misfit = misfit_of(with_group, group_setups, of_group.noise, threads);
    for (MistakeTrial& trial : trials_of(with_group, group_setups, of_group, misfit)) {
      if (trial.files == std::vector{f} && !trial.leave) out.push_back(in_group(std::move(trial), files[f].name, references));
    }
  }
  return out;
}

}  // namespace jointid::ident
