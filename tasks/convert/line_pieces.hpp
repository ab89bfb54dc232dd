#pragma once

#include <functional>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::tasks {

/// Goes through all FRFs of a source once, `lines_per_piece` lines at a time: calls `visit` with each block in order until
/// it returns false. True when it got to the end.
bool for_each_piece(const frf::FrfHeader& header, std::size_t lines_per_piece,
                    const std::function<bool(const frf::Block&)>& visit);

/// Lines whose FRF values take about 4 MB, at least one.
std::size_t lines_per_piece(const frf::FrfHeader& header);

}  // namespace jointid::tasks
