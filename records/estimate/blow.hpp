#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "records/file/record.hpp"

namespace jointid::records {

/// A stretch of a record that is averaged: a blow of a hammer and what follows it, or a segment of a long record.
struct Blow {
  std::size_t record = 0;             ///< index into the records
  std::size_t first = 0;              ///< sample at which the stretch begins
  std::size_t length = 0;             ///< samples
  std::optional<std::size_t> peak{};  ///< sample of the record with the largest force; none of a segment
  double force = 0.0;                 ///< N, there, with its sign; of a segment the rms of the first force
  std::string rejected{};             ///< why it is left out, or empty
};

/// How blows are found and judged.
struct HammerOptions {
  std::optional<double> block_s;  ///< length of a stretch; default: every record is one blow, whole
  double pretrigger_s = 0.0;      ///< how long before the trigger a stretch begins, with block_s
  double trigger = 0.1;           ///< a blow begins where the force passes this share of the record's largest, 0 < trigger < 1
  double second_peak = 0.1;  ///< a force above this share of the peak, before or after its pulse, is a second blow; 0 < … < 1
};

/// The blows of a record, in time; those that the record cuts off are rejected.
std::vector<Blow> find_blows(const Record& record, std::size_t index, const HammerOptions& options);

/// Segments of `length` samples that overlap by `overlap` of their length, 0 ≤ overlap < 1, the last whole one included.
std::vector<Blow> find_segments(const Record& record, std::size_t index, std::size_t length, double overlap);

/// Why a stretch should not be averaged, or empty: a sample that is no number; no force or no motion at all; a channel that was
/// overloaded; a second blow. Overloaded is a channel with three samples or more in a row that equal the largest or smallest of
/// the stretch, at least half of the channel's largest, as a clipped signal has, where the sample before or after differs by more
/// than four times the smallest step of the stretch (of at most a hundredth of the largest sample), so that the round top of a
/// signal of few bits is none.
std::string fault_of(const Record& record, const Blow& blow, const HammerOptions& options);

}  // namespace jointid::records
