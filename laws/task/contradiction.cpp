#include "laws/task/contradiction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jointid::laws {
namespace {

using response::DataFault;

bool is_near(Complex gain, double number) { return std::abs(gain - number) < 0.03 * std::abs(number); }

/// "-1", "1.4", or "0.98 at 31°".
std::string gain_text(Complex gain) {
  const double degrees = std::arg(gain) * 180.0 / std::numbers::pi, turned = std::min(std::abs(degrees), 180.0 - std::abs(degrees));
  if (turned < 3.0) return fmt::format("{:.2g}", gain.real() < 0.0 ? -std::abs(gain) : std::abs(gain));
  return fmt::format("{:.2g} at {:.0f}°", std::abs(gain), degrees);
}

/// What makes such a gain.
std::string cause(const DataFault& fault) {
  const bool force = fault.kind == DataFault::Kind::force;
  if (is_near(fault.gain, -1.0)) return "a wrong sign: key flip of its file";
  if (force && (is_near(fault.gain, std::numbers::sqrt2) || is_near(fault.gain, std::numbers::sqrt2 / 2.0)))
    return "root mean squares beside peaks";
  if (std::abs(fault.gain.imag()) > 0.05 * std::abs(fault.gain)) return "a phase: another trigger, delay or filter, or conjugates";
  return "a wrong unit or sensitivity: key gain of its file";
}

}  // namespace

std::string fault_text(const DataFault& fault, const std::vector<frf::Dof>& responses, const std::vector<std::string>& levels) {
  const auto name = [&](Eigen::Index response) { return responses[static_cast<std::size_t>(response)].name(); };
  switch (fault.kind) {
    case DataFault::Kind::exchanged:
      return "responses " + name(fault.first) + " and " + name(fault.second) + " exchanged (wrong labels: key rename of their file)";
    case DataFault::Kind::force:
      return "the forces of " + (fault.level ? levels[*fault.level] : "every level") + " times " + gain_text(fault.gain) + " (" +
             cause(fault) + ")";
    case DataFault::Kind::levels:
      return "the forces of " + levels[*fault.level] + " and " + levels[fault.other_level] +
             " exchanged (files in another order)";
    case DataFault::Kind::response:
      break;
  }
  return "response " + name(fault.first) + " times " + gain_text(fault.gain) + " (" + cause(fault) + ")";
}

std::string contradiction_text(const response::Consistency& test, const std::vector<frf::Dof>& responses,
                               const std::vector<std::string>& levels) {
  std::string text = fmt::format("the data contradict each other before any law: χ² = {:.4g} of {} degrees of freedom; ", test.chi_square,
                                 static_cast<long>(test.freedom));
  if (test.faults.empty()) {
    return text + fmt::format("no single sign, gain or exchange explains it: the parts as measured are not those of the assembly, or the "
                              "stated errors are too small (by a factor of {:.2g})",
                              std::sqrt(test.chi_square / static_cast<double>(test.freedom)));
  }
  for (std::size_t i = 0; i < test.faults.size(); ++i) {
    text += (i == 0 ? "with " : ", with ") + fault_text(test.faults[i], responses, levels) +
            fmt::format(" it is {:.4g}", test.faults[i].chi_square);
  }
  return text;
}

}  // namespace jointid::laws
