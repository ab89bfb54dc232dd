#include "frf/uff/uff_unit_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

UnitFactors parse_factors(ByteFile& file, const Dataset& dataset) {
  std::string line;
  std::string_view next;
  file.seek(dataset.payload_begin);
  for (int lines = 0; lines < 2 && file.position() < dataset.payload_end && file.next_line(next);) {
    if (trim(next).empty()) continue;
    if (++lines == 2) line = next;
  }
  const auto length = parse_real(column(line, 0, 25));
  const auto force = parse_real(column(line, 25, 25));
  if (!length || !force || !(*length > 0.0) || !(*force > 0.0) || std::isinf(*length) || std::isinf(*force)) {
    dataset.place.fail("record 2", "'" + line + "' does not begin with two positive unit factors",
                       "correct the factors of length and force");
  }
  return {*length, *force};
}

}  // namespace

UnitTable::UnitTable(ByteFile& file, const std::vector<Dataset>& datasets) {
  for (const Dataset& dataset : datasets) {
    if (dataset.number == 164 && !dataset.binary) entries_.push_back({dataset.place.byte, parse_factors(file, dataset)});
  }
}

UnitFactors UnitTable::at(const Dataset& dataset) const {
  if (entries_.empty()) return {};
  const auto after =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.byte > dataset.place.byte; });
  return after == entries_.begin() ? after->factors : std::prev(after)->factors;
}

}  // namespace jointid::frf::uff
