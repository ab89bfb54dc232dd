#include "records/estimate/stretches.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"

namespace jointid::records {
namespace {

[[noreturn]] void refuse_stretch(const char* place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::usage, {}, place, std::move(problem), std::move(remedy)});
}

}  // namespace

std::vector<Blow> find_stretches(std::span<const Record> records, const FrfOptions& options) {
  std::vector<Blow> out;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (options.segments) {
      const double samples = options.segments->block_s * records[i].rate_hz;
      if (!(samples >= 4.0 && samples <= static_cast<double>(records[i].samples()))) {
        refuse_stretch("--block",
                       fmt::format("{:g} s are {:.0f} samples; {} has {}", options.segments->block_s, samples, records[i].file,
                                   records[i].samples()),
                       "give a block within the record");
      }
      const auto found = find_segments(records[i], i, static_cast<std::size_t>(std::llround(samples)), options.segments->overlap);
      out.insert(out.end(), found.begin(), found.end());
    } else {
      const auto found = find_blows(records[i], i, options.hammer);
      out.insert(out.end(), found.begin(), found.end());
    }
  }
  for (const std::size_t number : options.reject) {
    if (number < 1 || number > out.size())
      refuse_stretch("--reject", fmt::format("there is no segment {} of {}", number, out.size()), "give numbers of the table");
    if (out[number - 1].rejected.empty()) out[number - 1].rejected = "by the user";
  }
  for (Blow& blow : out) {
    if (blow.rejected.empty() && !options.keep_faulty) blow.rejected = fault_of(records[blow.record], blow, options.hammer);
  }
  return out;
}

}  // namespace jointid::records
