#pragma once

#include <string>

namespace jointid::python {

/// The commit that the module was built from, as that of the command.
std::string built_from();

}  // namespace jointid::python
