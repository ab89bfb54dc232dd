#include "frf/uff/uff_coherence.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <span>

#include "base/text.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

using Coordinates = std::pair<std::int64_t, std::int64_t>;

Coordinates coordinates(const Header58& header) {
  return {coordinate_key(header.response.dof()), coordinate_key(header.reference.dof())};
}

/// Uneven records are compared with the axis when they are read.
bool usable(const Dataset& dataset, const std::vector<double>& axis) {
  const Header58& header = *dataset.function;
  if (header.function_type != function_coherence || !header.response.is_dof() || !header.reference.is_dof() ||
      header.points != axis.size()) {
    return false;
  }
  if (!header.even) return true;
  std::vector<double> own = even_abscissa(header);
  const double to_hz = abscissa_to_hz(header, dataset.place);
  for (double& line : own) line *= to_hz;
  return same_axis(axis, own);
}

/// The number next to the word "average" or "averages" in a line, 0 if there is none.
double averages_in(std::string line) {
  std::transform(line.begin(), line.end(), line.begin(),
                 [](unsigned char c) { return static_cast<char>(std::isalnum(c) ? std::tolower(c) : ' '); });
  const auto fields = words(line);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i] != "average" && fields[i] != "averages") continue;
    for (const std::size_t beside : {i + 1, i - 1}) {
      const auto count = beside < fields.size() ? parse_integer(fields[beside]) : std::nullopt;
      if (count && *count > 0) return static_cast<double>(*count);
    }
  }
  return 0.0;
}

/// 0 where no line says it.
double averages_of(const Dataset& dataset) {
  for (const std::string& line : dataset.function->id) {
    if (const double averages = averages_in(line); averages > 0.0) return averages;
  }
  return 0.0;
}

class Attachment {
 public:
  Attachment(ByteFile& file, Catalogue& catalogue) : file_(file), catalogue_(catalogue), doubts_(catalogue.header.doubts) {}

  void run() {
    find_records();
    if (multiple_ > 0)
      doubts_.push_back("multiple coherences (function type 26, " + std::to_string(multiple_) +
                        " of them) are not used: they belong to no single FRF");
    if (found_.empty() || !all_have_one()) return;
    for (auto& [at, record] : catalogue_.grid) {
      record.coherence = found_.at(coordinates(function_of(record))).front();
      require_readable(catalogue_.datasets[record.coherence]);
      require_plausible_size(file_, catalogue_.datasets[record.coherence]);
    }
    catalogue_.header.noise = NoiseRecord::coherence;
    take_averages();
  }

 private:
  const Header58& function_of(const GridRecord& record) const { return *catalogue_.datasets[record.dataset].function; }
  std::string name_of(const GridRecord& record) const {
    return function_of(record).response.name() + "/" + function_of(record).reference.name();
  }

  void find_records() {
    for (std::size_t i = 0; i < catalogue_.datasets.size(); ++i) {
      const Dataset& dataset = catalogue_.datasets[i];
      if (!dataset.function) continue;
      if (dataset.function->function_type == function_multiple_coherence) ++multiple_;
      if (usable(dataset, catalogue_.header.frequency_hz)) found_[coordinates(*dataset.function)].push_back(i);
    }
  }

  bool same_numbers(const std::vector<std::size_t>& records) {
    const Points first = read_points(file_, catalogue_.datasets[records.front()]);
    return std::ranges::all_of(
        records, [&](std::size_t record) { return read_points(file_, catalogue_.datasets[record]).values == first.values; });
  }

  /// Names those that have none, or several.
  bool all_have_one() {
    std::vector<std::string> without, several;
    bool differ = false;
    for (const auto& [at, record] : catalogue_.grid) {
      const auto match = found_.find(coordinates(function_of(record)));
      if (match == found_.end()) without.push_back(name_of(record));
      if (match == found_.end() || match->second.size() == 1) continue;
      several.push_back(name_of(record));
      differ = differ || !same_numbers(match->second);
    }
    if (!without.empty()) {
      doubts_.push_back("coherences are not used, as " + std::to_string(without.size()) + " of " +
                        std::to_string(catalogue_.grid.size()) + " FRFs have none: " + first_of(without));
    }
    if (differ) doubts_.push_back("coherences are not used, as some FRFs have several that differ: " + first_of(several));
    if (!differ && !several.empty()) doubts_.push_back("the same coherence is there several times: " + first_of(several));
    return without.empty() && !differ;
  }

  static std::string first_of(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 5;
    return comma_list(std::span(names).first(std::min(shown, names.size()))) + (names.size() > shown ? ", …" : "");
  }

  void take_averages() {
    double least = 0.0, most = 0.0;
    for (const auto& [at, record] : catalogue_.grid) {
      double averages = averages_of(catalogue_.datasets[record.coherence]);
      if (averages == 0.0) averages = averages_of(catalogue_.datasets[record.dataset]);
      if (averages == 0.0) continue;
      least = least == 0.0 ? averages : std::min(least, averages);
      most = std::max(most, averages);
    }
    catalogue_.header.averages = least;
    if (most > least)
      doubts_.push_back("FRFs have " + digits(least, "%.0f") + " to " + digits(most, "%.0f") +
                        " averages: " + digits(least, "%.0f") + " are taken for all");
  }

  ByteFile& file_;
  Catalogue& catalogue_;
  std::vector<std::string>& doubts_;
  std::map<Coordinates, std::vector<std::size_t>> found_;  ///< coherence records
  std::size_t multiple_ = 0;
};

}  // namespace

void attach_coherences(ByteFile& file, Catalogue& catalogue) { Attachment(file, catalogue).run(); }

}  // namespace jointid::frf::uff
