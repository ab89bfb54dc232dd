#pragma once

#include <ostream>

#include "cli/arguments.hpp"

/// One function per command; the report goes to `out`. Bad input throws InputError.
namespace jointid::cli {

ExitCode execute(const InfoArguments& arguments, std::ostream& out);
ExitCode execute(const ConvertArguments& arguments, std::ostream& out);
ExitCode execute(const ProblemListArguments& arguments, std::ostream& out);
ExitCode execute(const ProblemWriteArguments& arguments, std::ostream& out);
ExitCode execute(const SolveArguments& arguments, std::ostream& out);
ExitCode execute(const PlanArguments& arguments, std::ostream& out);
ExitCode execute(const CheckArguments& arguments, std::ostream& out);
ExitCode execute(const StudyArguments& arguments, std::ostream& out);
ExitCode execute(const CompareArguments& arguments, std::ostream& out);
ExitCode execute(const LoadingCurveArguments& arguments, std::ostream& out);
ExitCode execute(const CoupleArguments& arguments, std::ostream& out);
ExitCode execute(const EquivalentArguments& arguments, std::ostream& out);
ExitCode execute(const ModalfitArguments& arguments, std::ostream& out);
ExitCode execute(const StabilityArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
