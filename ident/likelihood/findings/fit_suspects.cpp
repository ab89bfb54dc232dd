#include "ident/likelihood/findings/fit_suspects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "ident/likelihood/errors/gain_scores.hpp"

namespace jointid::ident {
namespace {

constexpr double suspect_confidence = 0.7;
constexpr double telling_stretch = 4.5;  ///< standard deviations of a stretch

/// By how many standard deviations a shift of the joint moves the unknown that it moves most.
double in_deviations(const Eigen::VectorXd& shift, const Eigen::MatrixXd& covariance) {
  double most = 0.0;
  for (Eigen::Index u = 0; u < covariance.rows(); ++u) {
    if (covariance(u, u) > 0.0) most = std::max(most, std::abs(shift[u]) / std::sqrt(covariance(u, u)));
  }
  return most;
}

/// Each file whose responses to a hit are seen to share errors. The hammer is one: the others may be as low, which moves the
/// joint in proportion.
void add_force_noise(const TriedErrors& tried, const Eigen::VectorXd& joint, const Eigen::MatrixXd& covariance,
                     std::vector<Suspect>& found) {
  if (!tried.shared.are_seen()) return;
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(covariance.rows());
  for (std::size_t f = 0; f < tried.files.size(); ++f)
    shift += tried.shared.bias(f) * tried.files[f].answer.head(covariance.rows());
  double most = 0.0;
  for (std::size_t f = 0; f < tried.files.size(); ++f) most = std::max(most, tried.shared.bias(f));
  const double moved = std::max(in_deviations(shift, covariance), in_deviations(most * joint, covariance));
  if (!(moved > 1.0)) return;
  for (std::size_t f = 0; f < tried.files.size(); ++f) {
    const double bias = tried.shared.bias(f);
    if (!(bias > 0.0)) continue;
    found.push_back(
        {.kind = SuspectKind::force_noise,
         .file = tried.files[f].file.name,
         .dofs = {},
         .evidence = "the errors of the FRFs of one hit are alike, as noise of the force's signal makes them. H1 is then too "
                     "low by up to " +
                     percent(bias) + ", which is what the coherences leave open and moves the joint by up to " + digits(moved) +
                     " standard deviations",
         .confidence = suspect_confidence,
         .remedy = "# estimate the FRFs by H2 or Hv, or measure the force with less noise"});
  }
}

Suspect gain_of(const FileGain& gain) {
  return {.kind = SuspectKind::gain,
          .file = gain.file.name,
          .dofs = {},
          .evidence = fmt::format(
              "the joint explains the FRFs better where all of the file are {:.4f} ± {:.1g} times as large ({} standard "
              "deviations from 1): is a calibration off? The inverse factor in the other files would do as well",
              1.0 + gain.gain, gain.error, digits(std::abs(gain.score))),
          .confidence = suspect_confidence,
          .remedy = fmt::format("[data.files.\"{}\"]\ngain = {:.5g}", gain.file.name, 1.0 + gain.gain)};
}

void add_sensors(const TriedErrors& tried, std::size_t known, std::vector<Suspect>& found) {
  for (const GainSuspect& each : suspect_gains(tried, known)) {
    found.push_back(
        {.kind = SuspectKind::gain,
         .file = each.file,
         .dofs = {each.dof},
         .evidence = fmt::format("the joint explains the FRFs better with a gain of {:.4f} ± {:.1g} of this sensor ({} standard "
                                 "deviations from 1){}",
                                 each.gain, each.error, digits(std::abs(each.score)),
                                 each.instead.empty() ? "" : ", or with its inverse in " + each.instead),
         .confidence = suspect_confidence,
         .remedy = "# calibrate it, or let [[data.gains]] estimate it with the joint"});
  }
}

void add_stretch(const TriedErrors& tried, std::vector<Suspect>& found) {
  const FileGain* const stretch = tried.stretch();
  if (stretch == nullptr || !(std::abs(stretch->score) >= telling_stretch)) return;
  found.push_back({.kind = SuspectKind::axis,
                   .file = stretch->file.name,
                   .dofs = {},
                   .evidence = fmt::format(
                       "{} with frequencies {:.2g} % {} ({} standard deviations): another temperature, or another clock",
                       stretch->file.of_assembly ? "the assembly fits the parts better" : "it fits the other files better",
                       100.0 * std::abs(stretch->gain), stretch->gain > 0.0 ? "lower" : "higher", digits(std::abs(stretch->score))),
                   .confidence = suspect_confidence,
                   .remedy = ""});
}

void add_scatter(const TriedErrors& tried, std::size_t known, std::vector<Suspect>& found) {
  const auto jackknife = tried.jackknife(known, nullptr);
  if (!jackknife || !jackknife->tells_more()) return;
  found.push_back(
      {.kind = SuspectKind::nonlinear,
       .file = "",
       .dofs = {},
       .evidence = "blocks of lines disagree on the joint by " + digits(std::sqrt(jackknife->mean)) +
                   " times what their errors explain: the parts may have changed between the tests (temperature, supports)",
       .confidence = 0.6,
       .remedy = ""});
}

}  // namespace

std::vector<Suspect> fit_suspects(const TriedErrors& tried, const std::optional<FileGain>& without,
                                  const Eigen::MatrixXd& covariance, const std::vector<double>& theta) {
  constexpr double beyond_shared = 3.0;  // as much is asked for where responses to a hit share errors
  std::vector<Suspect> found;
  if (!covariance.allFinite()) return found;
  add_force_noise(tried, Eigen::Map<const Eigen::VectorXd>(theta.data(), covariance.rows()), covariance, found);
  const bool shared = tried.shared.are_seen();
  if (without) {
    found.push_back(gain_of(*without));
  } else if (const FileGain* gain = tried.is_calibration_stated ? nullptr : telling_gain(tried.files);
             gain != nullptr && (!shared || std::abs(gain->score) >= beyond_shared * telling_stretch)) {
    found.push_back(gain_of(*gain));
  }
  add_stretch(tried, found);
  if (shared) return found;
  add_sensors(tried, theta.size(), found);
  if (found.empty() && tried.blocks) add_scatter(tried, theta.size(), found);
  return found;
}

}  // namespace jointid::ident
