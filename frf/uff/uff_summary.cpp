#include <algorithm>
#include <array>
#include <utility>

#include "base/error.hpp"
#include "frf/uff/uff58_data.hpp"
#include "frf/uff/uff_file.hpp"

namespace jointid::frf {
namespace {

constexpr std::pair<int, const char*> data_type_names[] = {{0, "unknown"},
                                                           {1, "general"},
                                                           {2, "stress"},
                                                           {3, "strain"},
                                                           {5, "temperature"},
                                                           {6, "heat flux"},
                                                           {8, "displacement"},
                                                           {9, "reaction force"},
                                                           {11, "velocity"},
                                                           {12, "acceleration"},
                                                           {13, "excitation force"},
                                                           {15, "pressure"},
                                                           {16, "mass"},
                                                           {17, "time"},
                                                           {18, "frequency"},
                                                           {19, "rpm"},
                                                           {20, "order"}};

std::string data_type_name(int type) {
  for (const auto& [code, text] : data_type_names) {
    if (code == type) return text;
  }
  return "type " + std::to_string(type);
}

/// "numerator / denominator", or the numerator alone when record 10 is not used.
std::string over(const std::string& numerator, const std::string& denominator) {
  if (denominator.empty()) return numerator;
  return numerator + " / " + denominator;
}

UffSummary::Function describe(const uff::Dataset& dataset) {
  const uff::Header58& header = *dataset.function;
  const bool ratio = header.denominator.data_type != 0;
  std::array<std::string, 5> id;
  std::ranges::copy(header.id, id.begin());
  return {.dataset = dataset.name(),
          .id = std::move(id),
          .function_type = header.function_type,
          .function = uff::function_name(header.function_type),
          .response = header.response.name(),
          .reference = header.reference.name(),
          .points = header.points,
          .quantity = over(data_type_name(header.numerator.data_type),
                           ratio ? data_type_name(header.denominator.data_type) : std::string()),
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
