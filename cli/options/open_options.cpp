#include "cli/options/open_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/options/of_option.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/set/units.hpp"

namespace jointid::cli {

std::vector<frf::Dof> parse_dofs(const std::vector<std::string>& texts) {
  std::vector<frf::Dof> dofs;
  for (const std::string& text : texts) dofs.push_back(frf::Dof::parse(text));
  return dofs;
}

void add_open_options(CLI::App* command, frf::OpenOptions& open) {
  command->add_option_function<std::string>(
      "--quantity",
      [&open](const std::string& text) { open.quantity = of_option("--quantity", [&] { return frf::parse_quantity(text); }); },
      "receptance, mobility or accelerance, for files without a quantity or with a wrong one");
  const auto checked = [command](const char* name, std::string& to, auto check, const char* what) {
    command->add_option_function<std::string>(
        name,
        [&to, name, check](const std::string& text) {
          of_option(name, [&] { check(text); });
          to = text;
        },
        what);
  };
  checked("--unit", open.unit, [](const std::string& text) { frf::require_frf_unit(text); },
          "UFF, CSV, text exports: unit of the FRFs in place of the file's, e.g. g/lbf");
  const auto dofs = [command](const char* name, std::vector<frf::Dof>& to, const char* what) {
    command
        ->add_option_function<std::vector<std::string>>(
            name, [&to, name](const std::vector<std::string>& texts) { to = of_option(name, [&] { return parse_dofs(texts); }); },
            what)
        ->delimiter(',');
  };
  dofs("--response", open.response,
       "Response DOFs, e.g. 4:+Y,4:+RZ, for files without DOFs (MAT, CSV, UFF without directions, text exports); with several "
       "files one each");
  dofs("--reference", open.reference, "Reference DOFs; default: those of the responses");
  command->add_option("--variable", open.variable, "MAT, HDF5, npz: name of the FRF variable; S.field of a struct");
  command->add_option("--frequency-variable", open.frequency_variable,
                      "MAT, HDF5, npz: name of the variable with the frequencies; for .npy the file with them");
  checked("--frequency-unit", open.frequency_unit, [](const std::string& text) { frf::hertz_per(text); },
          "Unit of the frequencies in place of the file's, e.g. kHz, rad/s or rpm");
}

}  // namespace jointid::cli
