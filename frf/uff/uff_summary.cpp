#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "frf/uff/uff58_data.hpp"
#include "frf/uff/uff_file.hpp"
#include "frf/uff/uff_units.hpp"

namespace jointid::frf {
namespace {

/// "numerator / denominator", or the numerator alone when record 10 is not used.
std::string over(const std::string& numerator, const std::string& denominator) {
  if (denominator.empty()) return numerator;
  return numerator + " / " + denominator;
}

UffSummary::Function describe(const uff::Dataset& dataset) {
  const uff::Header58& header = *dataset.function;
  std::array<std::string, 5> id;
  std::ranges::copy(header.id, id.begin());
  return {.dataset = dataset.name(),
          .id = std::move(id),
          .function_type = header.function_type,
          .function = uff::function_name(header.function_type),
          .response = header.response.name(),
          .reference = header.reference.name(),
          .points = header.points,
          .quantity = uff::quantity_in_words(header),
          .unit = over(header.numerator.unit, header.denominator.unit),
          .abscissa_unit = header.abscissa.unit};
}

}  // namespace

UffSummary summarize_uff(const std::filesystem::path& path) {
  uff::ByteFile file(path);
  UffSummary summary;
  for (const uff::Dataset& dataset : uff::scan(file)) {
    const auto same =
        std::find_if(summary.datasets.begin(), summary.datasets.end(),
                     [&](const UffSummary::Count& count) { return count.dataset == dataset.name(); });
    if (same == summary.datasets.end()) {
      summary.datasets.push_back({dataset.name(), 1});
    } else {
      ++same->count;
    }
    if (dataset.function) summary.functions.push_back(describe(dataset));
  }
  return summary;
}

Uff58 read_uff58(const std::filesystem::path& path, std::size_t index) {
  uff::ByteFile file(path);
  std::size_t next = 0;
  for (const uff::Dataset& dataset : uff::scan(file)) {
    if (!dataset.function || next++ != index) continue;
    uff::Points points = uff::read_points(file, dataset);
    if (dataset.function->even) points.abscissa = uff::even_abscissa(*dataset.function);
    return {describe(dataset), std::move(points.abscissa), std::move(points.values)};
  }
  throw InputError({.kind = ErrorKind::data,
                    .file = file.name(),
                    .place = {},
                    .problem = "record " + std::to_string(index + 1) +
                               " of dataset 58 does not exist, there are " + std::to_string(next),
                    .remedy = {}});
}

}  // namespace jointid::frf
