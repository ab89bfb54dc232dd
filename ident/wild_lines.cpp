#include "ident/wild_lines.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/noise/variance_law.hpp"
#include "frf/noise/wild_values.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_searched = 1'000'000;
constexpr std::size_t neighbours = 3;
constexpr double absurd_factor = 1e6;  ///< times the neighbour lines

std::vector<std::size_t> counted(std::size_t first, std::size_t last) {
  std::vector<std::size_t> all;
  for (std::size_t i = first; i <= last; ++i) all.push_back(i);
  return all;
}

bool is_used(const Dofs& own, const Dofs& joint, const frf::Dof& dof) {
  return frf::find_coordinate(own, dof) != frf::npos || frf::find_coordinate(joint, dof) != frf::npos;
}

/// One file of a plan.
struct WatchedFile {
  const Plan& plan;
  frf::FrfSystem& system;
  std::size_t source;
  bool of_assembly;

  const frf::FrfHeader& header() const { return system.source(source).header(); }

  /// Lines of the file that the plan uses, in order.
  std::vector<std::size_t> lines() const {
    std::vector<std::size_t> out;
    for (const Line& line : plan.lines)
      out.push_back(system.source_line(source, of_assembly ? line.assembly : line.substructures));
    std::ranges::sort(out);
    return out;
  }

  bool uses(const frf::WildValue& value) const {
    if (value.response == frf::npos) return true;
    const Coordinates& own = plan.coordinates;
    return is_used(own.responses, own.joint, header().response[value.response]) &&
           is_used(own.references, own.joint, header().reference[value.reference]);
  }

  std::string name(const frf::WildValue& value, double hz) const {
    const frf::FrfHeader& of = header();
    const double factor = std::sqrt(std::max(frf::squared_factor(of.quantity, hz), 1e-300));
    const std::string which = value.response == frf::npos
                                  ? "all FRFs"
                                  : "the " + frf::name(of.quantity) + " of " + of.response[value.response].name() + " over " +
                                        of.reference[value.reference].name();
    return which + " in " + Path(of.file).filename().string() + " at " + digits(hz, "%.6g") + " Hz " +
           (value.response == frf::npos ? "are" : "is") + " " + digits(std::abs(value.value) / factor, "%.3g") + ", " +
           digits(value.factor, "%.2g") + " times the size of the neighbour lines";
  }

  void find(WildLines& found) const {
    const std::vector<std::size_t> used = lines();
    const std::size_t first = used.front() - std::min(used.front(), neighbours),
                      last = std::min(used.back() + neighbours, header().lines() - 1);
    frf::FrfHeader some = header();
    some.frequency_hz.assign(header().frequency_hz.begin() + static_cast<std::ptrdiff_t>(first),
                             header().frequency_hz.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const std::vector<std::size_t> all = counted(first, last), rows = counted(0, some.response.size() - 1),
                                   columns = counted(0, some.reference.size() - 1);
    std::vector<Complex> values(all.size() * some.entries());
    system.source(source).read({all, rows, columns}, values);
    frf::WildSearch search(some);
    search.add(values);
    for (const frf::WildValue& value : search.finish().found) {
      if (value.kind != frf::WildKind::large || !uses(value)) continue;
      note(value, some.frequency_hz, first, used, found);
    }
  }

 private:
  void note(const frf::WildValue& value, const std::vector<double>& hz, std::size_t first, const std::vector<std::size_t>& used,
            WildLines& found) const {
    bool any = false;
    for (std::size_t l = value.line; l <= value.last_line; ++l) {
      if (!std::ranges::binary_search(used, first + l)) continue;
      any = true;
      if (value.factor > absurd_factor) found.absurd_hz.push_back(hz[l]);
    }
    if (!any) return;
    (value.factor > absurd_factor ? found.absurd : found.named).push_back(name(value, hz[value.line]));
  }
};

std::vector<WatchedFile> files_of(const Plan& plan) {
  std::vector<WatchedFile> files;
  for (const bool of_assembly : {false, true}) {
    frf::FrfSystem& system = of_assembly ? *plan.assembly : *plan.substructures;
    for (std::size_t s = 0; s < system.source_count(); ++s) files.push_back({plan, system, s, of_assembly});
  }
  return files;
}

}  // namespace

WildLines find_wild_lines(const Plan& plan, const Control& control) {
  WildLines found;
  const std::vector<WatchedFile> files = files_of(plan);
  std::size_t values = 0;
  for (const WatchedFile& file : files) values += file.header().entries() * file.header().lines();
  if (values > most_searched || plan.lines.empty()) return found;
  for (const WatchedFile& file : files) {
    stop_if(control.interrupted);
    // What passes many joints falls by orders of magnitude between two lines.
    if ((plan.why_by_parts || plan.solver == Solver::by_parts) && file.of_assembly) continue;
    if (file.header().entries() > 0 && file.header().entries() <= frf::most_judged_frfs) file.find(found);
  }
  return found;
}

}  // namespace jointid::ident
