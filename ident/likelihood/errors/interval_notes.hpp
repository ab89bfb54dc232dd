#pragma once

#include "ident/likelihood/errors/intervals.hpp"

namespace jointid::ident {

/// Whether a sensor alone or a stretch explains the data better than a gain of all FRFs of a file, or responses to a hit share errors.
bool has_better_explanation(const TriedErrors& tried, const FileGain& gain);

/// Notes what calibration is taken to be, and what it costs: `cost` times the width of exact calibration.
void note_calibration(double cost, const std::optional<FileGain>& estimated, const TriedErrors& tried, Solution& out);

/// Puts errors that responses to a reference share, and the bias of H1 that they may mean, into the intervals, and tells them: a note
/// where they are not seen, too, and status doubtful where the bias is more than half the width of an interval. `information`: of all
/// unknowns.
void tell_shared_errors(const Plan& plan, const TriedErrors& tried, const Eigen::MatrixXd& information, Intervals& intervals,
                        Solution& out);

/// Status doubtful: blocks of lines scatter by more than their errors. Nothing where χ² says so already.
void tell_scatter(const Jackknife& jackknife, Solution& out);

/// Takes a stretch of a file's frequencies into the intervals, from none to all of it; status doubtful from 4.5 standard deviations on,
/// from 3.5 where it moves an unknown by more than half the width of its interval.
/// Of the assembly's the joint itself may be free: all K and D are then as much stiffer or softer as the frequencies' squares. `step`: of
/// the unknowns of the fit with the stretch, beside its answer.
void tell_stretch(const Plan& plan, const LikelihoodFit& fit, const FileGain& stretch, const Eigen::VectorXd& step,
                  Intervals& intervals, Solution& out);

/// Status doubtful: the data call for a common gain that was not taken off, because a sensor or another error explains them better, or it
/// does not explain them. Intervals reach from none to all of it. Where responses to a hit share errors three times as much is asked for,
/// and more than of a stretch.
void tell_unexplained_gain(const TriedErrors& tried, Intervals& intervals, Solution& out);

/// Status doubtful: the data call for this gain.
void tell_common_gain(const FileGain& gain, Solution& out);

}  // namespace jointid::ident
