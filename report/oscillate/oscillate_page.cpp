#include "report/oscillate/oscillate_page.hpp"

#include <fmt/format.h>

#include "report/oscillate/oscillate_plots.hpp"
#include "report/oscillate/oscillate_report.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::report {
namespace {

StatusBanner banner_of(const tasks::OscillateResult& run) {
  const std::string failure = failure_of(run);
  if (run.interrupted) return status_banner("doubtful", "Interrupted: only what was found so far.", run.remarks);
  if (!failure.empty()) return status_banner("not_converged", failure, run.remarks);
  return status_banner("ok", "All that the scene asks for was found.", run.remarks);
}

void add_modes(const tasks::OscillateResult& run, ReportPage& page) {
  page.section("Proper orthogonal modes");
  page.add(mode_plots(run));
  page.add(fractions_table(*run.modes), "Shares");
  page.add(shapes_table(run), "Shapes");
  page.add(Text{
      "Shares of Σσ², mean removed; standard errors by a jackknife over 20 segments, which mean nothing for a periodic motion. "
      "Values are mean squares, not energies.",
      true});
}

void add_orbit(const tasks::OscillateResult& run, ReportPage& page) {
  page.section("Periodic orbit");
  page.add(Text{orbit_line(run)});
  if (run.orbit->converged) page.add(multipliers_table(*run.orbit), "Multipliers");
}

void add_exponents(const tasks::OscillateResult& run, ReportPage& page) {
  page.section("Exponents of the model");
  page.add(exponents_table(*run.exponents, time_unit(run)));
  page.add(Text{"Tangents through the events, made orthonormal (Benettin); standard errors of batch means.", true});
}

void add_reduction(const tasks::OscillateResult& run, ReportPage& page) {
  page.section("Reduced models");
  page.add(reduction_plots(*run.reduction));
  page.add(reduction_table(*run.reduction));
  page.add(Text{
      "craig_bampton: static shape of a force at the contact and modes with the contact held. ΔX and ΔE of sums over the samples "
      "(Kappagantu 3.37, 3.36). The stick force follows from the reduced model itself.",
      true});
}

}  // namespace

std::string oscillate_report(const tasks::OscillateResult& run) {
  ReportPage page(run.title.empty() ? "Stick–slip motion" : run.title, "jointid oscillate");
  page.status(banner_of(run));
  page.section("Motion");
  page.add(Text{motion_line(run)});
  page.add(phase_plots(run));
  page.section("Contact");
  page.add(contact_plots(run));
  if (run.modes) add_modes(run, page);
  if (run.orbit) add_orbit(run, page);
  if (run.exponents) add_exponents(run, page);
  if (run.swept) {
    page.section("Bifurcation diagram");
    page.add(Text{sweep_line(run)});
    page.add(sweep_plot(run));
  }
  if (run.reduction) add_reduction(run, page);
  if (run.normal_vibrations) {
    page.section("Normal load");
    page.add(Text{normal_line(*run.normal_vibrations)});
    page.add(normal_table(*run.normal_vibrations));
  }
  if (!run.thick_modes.empty()) {
    page.section("Shear and rotary inertia");
    page.add(thick_table(run.thick_modes));
  }
  return page.html();
}

}  // namespace jointid::report
