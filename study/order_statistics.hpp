#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace jointid::study {

using PieceVisitor = std::function<void(std::span<const double>)>;

/// A pass over a column: gives all of its numbers to the visitor, piece by piece. Every pass gives the same numbers.
using ColumnPass = std::function<void(const PieceVisitor& visit)>;

/// How many numbers of the column are no NaN.
std::size_t count_numbers(const ColumnPass& column);

/// The numbers that stand at `places` (from 0, each below count_numbers()) once the column without its NaN is sorted, −0 before
/// +0: the same bits as sorting gives. Takes no more memory than `most_kept` numbers and a histogram per place, however long
/// the column: while more are left, a pass counts them by the next 11 bits of their order-preserving image as integers and
/// keeps the bins with the places; the last pass sorts what is left. At most 7 passes, 3 for a million noisy numbers.
std::vector<double> order_statistics(const ColumnPass& column, std::span<const std::size_t> places,
                                     std::size_t most_kept = std::size_t{1} << 16);

}  // namespace jointid::study
