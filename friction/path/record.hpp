#pragma once

#include <span>
#include <vector>

/// What is done to a measured record before an element is fitted to it. Plain functions; units are the caller's.
namespace jointid::friction {

/// Relative displacement and force of a joint, sample by sample in time order; equally long.
struct Record {
  std::vector<double> displacement, force;
};

/// Displacement from velocity by the trapezoidal rule, 0 at the first sample. Exact for a velocity that is linear between
/// samples. Throws InputError unless `time` increases and both are equally long.
std::vector<double> integrated(std::span<const double> time, std::span<const double> velocity);

/// The record without the elastic deformation u = F/stiffness of the specimen around the joint (docs/formulas.md §10f).
Record without_elastic(Record record, double stiffness);

/// The same by the measured loading curve of a specimen without joint: u_s(F) is interpolated linearly between its points and
/// through the origin, continued by its last slope, and odd in F. Throws InputError when the specimen's forces,
/// without signs, do not increase.
Record without_elastic(Record record, const Record& specimen);

/// Work Σ F du done on the joint along the record (trapezoidal rule). A joint takes energy, so a record over whole cycles, or of
/// loading from rest, with negative work has the direction of one channel reversed.
double work(const Record& record);

/// The record with forces times `factor`, e.g. −1.
Record with_force_times(Record record, double factor);

/// The record without its samples that are not finite.
Record finite_samples(const Record& record);

}  // namespace jointid::friction
