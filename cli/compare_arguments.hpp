#pragma once

#include "cli/arguments.hpp"
#include "ident/comparison.hpp"

namespace jointid::cli {

/// What the lists of the command line name. Throws InputError (usage) that names the option, the word and the nearest valid one.
ident::Alternatives alternatives(const CompareArguments& arguments);

/// Throws InputError (usage) for a command line that cannot be carried out.
void check(const CompareArguments& arguments);

}  // namespace jointid::cli
