#pragma once

#include <string>
#include <string_view>

namespace jointid::frf {

/// The DOF that a text of another program may mean, "12X+", "12+X", "12:x", "Pt12Z-", "plate:12:+X", as it should be written; empty where
/// there is none.
std::string proposed_dof(std::string_view text);

}  // namespace jointid::frf
