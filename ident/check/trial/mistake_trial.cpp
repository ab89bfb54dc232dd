#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {

std::string remedy_in(const std::string& file, const std::string& line) { return "[data.files.\"" + file + "\"]\n" + line; }

std::string quoted_dof(const frf::Dof& dof) { return "\"" + dof.name() + "\""; }

}  // namespace jointid::ident
