#include "friction/law/arrangement.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "friction/path/parallel.hpp"
#include "friction/path/series.hpp"

namespace jointid::friction {
namespace {

constexpr std::string_view series_word = "series:", parallel_word = "parallel:";
constexpr std::size_t most_arranged = 4;

}  // namespace

bool is_arrangement(std::string_view name) { return name.starts_with(series_word) || name.starts_with(parallel_word); }

ArrangementName parse_arrangement(std::string_view name) {
  ArrangementName found{.series = name.starts_with(series_word), .parts = {}};
  std::string_view rest = name.substr(found.series ? series_word.size() : parallel_word.size());
  while (true) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    found.parts.emplace_back(rest.substr(0, end));
    if (end == rest.size()) break;
    rest.remove_prefix(end + 1);
  }
  if (found.parts.size() >= 2 && found.parts.size() <= most_arranged) return found;
  refuse("'" + std::string(name) + "' has " + std::to_string(found.parts.size()) +
         " laws; name two to four: parallel:ren:spring");
}

ArrangementLaw::ArrangementLaw(std::string name, const ArrangementName& arrangement, const std::vector<const Law*>& parts)
    : name_(std::move(name)) {
  bool limited = !arrangement.series;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    title_ += (i == 0 ? "" : arrangement.series ? " in series with " : " beside ") + std::string(parts[i]->title);
    limited = arrangement.series ? limited || parts[i]->has_limit : limited && parts[i]->has_limit;
    for (LawParameter parameter : parts[i]->parameters) {
      parameter.name = names_.emplace_back(std::to_string(i + 1) + "." + std::string(parameter.name));
      parameters_.push_back(parameter);
    }
  }
  law_ = {.name = name_, .title = title_, .parameters = parameters_, .start = {{}, nullptr}, .has_limit = limited};
}

std::unique_ptr<Element> arranged(bool series, Parts parts) {
  if (series) return std::make_unique<Series>(std::move(parts));
  return std::make_unique<Parallel>(std::move(parts));
}

}  // namespace jointid::friction
