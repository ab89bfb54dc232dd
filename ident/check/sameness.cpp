#include "ident/check/sameness.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {
namespace {

constexpr double identical_numbers = 1e-9;
constexpr double no_motion = 0.02;  ///< FRFs across parts below 2 % of the others: nothing is transmitted

bool anyone_has(const std::vector<CheckedFile>& files, bool assembly, const frf::Dof& dof) {
  return std::ranges::any_of(files, [&](const CheckedFile& file) {
    return file.assembly == assembly &&
           (place_of(file.responses, dof) != frf::npos || place_of(file.references, dof) != frf::npos);
  });
}

/// Responses of the assembly's files (or the parts') that nobody on the other side has.
struct Unmatched {
  std::size_t file;
  frf::Dof dof;
};

std::vector<Unmatched> unmatched_responses(const std::vector<CheckedFile>& files, bool assembly) {
  std::vector<Unmatched> found;
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (files[f].assembly != assembly) continue;
    for (const frf::Dof& dof : files[f].responses) {
      const bool elsewhere = std::ranges::any_of(files, [&](const CheckedFile& other) {
        return other.assembly != assembly && place_of(other.responses, dof) != frf::npos;
      });
      if (!elsewhere) found.push_back({f, dof});
    }
  }
  return found;
}

/// How far the row of `dof` is from its place: |gain − 1| and its share, by the span test with the label changed.
struct LabelFit {
  double level = 1.0, gain = 0.0;
};

LabelFit fit_of_label(std::vector<CheckedFile> files, const Unmatched& wrong, const frf::Dof& right, const Dofs& joint) {
  files[wrong.file].responses[place_of(files[wrong.file].responses, wrong.dof)] = right;
  LabelFit fit;
  for (const SpanSetup& setup : span_setups(files, joint)) {
    const std::size_t k = place_of(setup.rows, right);
    if (setup.transposed || k == frf::npos || (setup.part != wrong.file && setup.assembly != wrong.file)) continue;
    const SpanTest test = span_test(setup, files, SpanDetail::rows);
    fit = {test.level, test.gain[k]};
  }
  return fit;
}

}  // namespace

Sameness sameness(const SpanSetup& setup, const std::vector<CheckedFile>& files) {
  Sameness out;
  double differences = 0.0, crossing = 0.0, largest = 0.0;
  std::size_t lines = 0;
  for (std::size_t l = 0; l < files[setup.part].frfs.size(); ++l) {
    const Eigen::MatrixXcd& all = files[setup.assembly].frfs[l];
    const Eigen::MatrixXcd a = all(setup.assembly_rows, setup.assembly_columns),
                           outer = all(setup.assembly_rows, setup.outer_columns);
    const Eigen::MatrixXcd p = files[setup.part].frfs[l](setup.part_rows, setup.part_columns);
    if (!a.allFinite() || !p.allFinite() || !outer.allFinite() || a.size() == 0) continue;
    const Eigen::ArrayXXd size = a.cwiseAbs2().array() + p.cwiseAbs2().array() + 1e-300;
    const Eigen::ArrayXXd relative = (a - p).cwiseAbs2().array() / size;
    largest = std::max(largest, relative.maxCoeff());
    differences += std::log(relative.mean() + 1e-18);
    if (outer.size() > 0) crossing += std::log((outer.cwiseAbs2().mean() + 1e-300) / (a.cwiseAbs2().mean() + 1e-300));
    ++lines;
  }
  if (lines == 0) return out;
  out.difference = std::exp(0.5 * differences / static_cast<double>(lines));
  out.across = setup.outer_columns.empty() ? 0.0 : std::exp(0.5 * crossing / static_cast<double>(lines));
  out.identical = largest < identical_numbers * identical_numbers;
  return out;
}

std::vector<Suspect> find_sameness(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                   const std::vector<double>& noise) {
  std::vector<Suspect> found;
  bool all_the_same = true;
  double largest = 0.0, across = 0.0;
  std::size_t tested = 0, assembly = 0;
  for (const SpanSetup& setup : setups) {
    if (setup.transposed) continue;
    const Sameness same = sameness(setup, files);
    ++tested;
    assembly = setup.assembly;
    largest = std::max(largest, same.difference);
    across = std::max(across, same.across);
    all_the_same = all_the_same && same.difference < 2.0 * noise[setup.part] + 0.005 && same.across < no_motion;
    if (same.identical && same.across >= no_motion) {
      found.push_back({.kind = SuspectKind::exchange,
                       .file = files[setup.part].name,
                       .dofs = {},
                       .evidence = "the FRFs of the part are the same numbers as those of " + files[setup.assembly].name +
                                   ": one measurement under two names, as the joint passes on " + percent(same.across) +
                                   " to the other side",
                       .confidence = 0.97,
                       .remedy = "give the file of the part measured alone in place of " + files[setup.part].name});
    }
  }
  if (tested > 0 && all_the_same) {
    found.push_back({.kind = SuspectKind::loose,
                     .file = files[assembly].name,
                     .dofs = {},
                     .evidence = "the assembly moves as its parts do alone, to " + percent(largest) +
                                 ", which is their noise; FRFs from one side to the other are " + percent(across) +
                                 " of the rest: nothing holds the parts together",
                     .confidence = 0.95,
                     .remedy = ""});
  }
  return found;
}

std::vector<Suspect> find_labels(const std::vector<CheckedFile>& files, const Dofs& joint) {
  std::vector<Suspect> found;
  const std::vector<Unmatched> of_assembly = unmatched_responses(files, true), of_parts = unmatched_responses(files, false);
  for (const Unmatched& a : of_assembly) {
    const Unmatched* best = nullptr;
    LabelFit best_fit;
    for (const Unmatched& p : of_parts) {
      const LabelFit fit = fit_of_label(files, a, p.dof, joint);
      if (fit.gain > 0.7 && fit.gain < 1.4 && fit.level < best_fit.level) {
        best = &p;
        best_fit = fit;
      }
    }
    if (best == nullptr || best_fit.level > 0.3) continue;
    // A label that its own side has in no other role is the wrong one; the assembly's where both are alike.
    const bool part_is_wrong = anyone_has(files, false, a.dof) && !anyone_has(files, true, best->dof);
    const std::size_t file = part_is_wrong ? best->file : a.file;
    const frf::Dof wrong = part_is_wrong ? best->dof : a.dof, right = part_is_wrong ? a.dof : best->dof;
    found.push_back(
        {.kind = SuspectKind::label,
         .file = files[file].name,
         .dofs = {wrong, right},
         .evidence = "no other file has a response " + wrong.name() + ", and " + right.name() +
                     " lacks its counterpart; taken for it, the FRFs fit to " + percent(best_fit.level),
         .confidence = 0.9,
         .remedy = remedy_in(files[file].name, "rename = { " + quoted_dof(wrong) + " = " + quoted_dof(right) + " }")});
  }
  return found;
}

}  // namespace jointid::ident
