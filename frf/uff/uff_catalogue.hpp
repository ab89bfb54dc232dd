#pragma once

#include <map>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "frf/uff/uff58_data.hpp"
#include "frf/uff/uff_units.hpp"

namespace jointid::frf::uff {

/// The record behind one element of the response × reference grid.
struct GridRecord {
  std::size_t dataset = npos;  ///< index into Catalogue::datasets
  Quantity quantity = Quantity::receptance;
  double factor = 1.0;           ///< to SI and to the signs of the header's DOFs
  std::size_t coherence = npos;  ///< index of the coherence record of the same DOFs
};

/// The FRF records of a file as a grid.
struct Catalogue {
  FrfHeader header;
  std::vector<Dataset> datasets;
  std::map<std::size_t, GridRecord> grid;  ///< by r·C + c; what is not there was not measured, and takes no memory
  std::size_t first_record = npos;         ///< index of the first FRF record, whose axis is the header's
};

/// Throws InputError naming both records unless `abscissa` (in the record's units) is the header's axis.
void require_axis(const Catalogue& catalogue, const Dataset& dataset, std::vector<double> abscissa);

/// Whether both axes have the same length and all lines differ by less than 0.1 of the smaller distance to a
/// neighbour.
bool same_axis(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace jointid::frf::uff
