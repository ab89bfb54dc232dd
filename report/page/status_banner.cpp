#include "report/page/status_banner.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "report/text/words.hpp"

namespace jointid::report {
namespace {

Trust trust_in(std::string_view status) {
  constexpr std::array<std::string_view, 3> good = {"ok", "usable", "clean"};
  constexpr std::array<std::string_view, 2> doubtful = {"doubtful", "suspicious"};
  if (std::ranges::find(good, status) != good.end()) return Trust::good;
  return std::ranges::find(doubtful, status) != doubtful.end() ? Trust::doubtful : Trust::bad;
}

}  // namespace

StatusBanner status_banner(const std::string& status, const std::string& message, std::vector<std::string> remarks,
                           std::vector<SuspectLines> suspects) {
  return {trust_in(status), words(status), message, std::move(remarks), std::move(suspects)};
}

StatusBanner trials_banner(std::size_t usable, std::size_t trials, const std::string& none, const std::string& message) {
  if (usable == trials) return {Trust::good, "ok", message};
  return usable > 0 ? StatusBanner{Trust::doubtful, "some trials failed", message} : StatusBanner{Trust::bad, none, message};
}

}  // namespace jointid::report
