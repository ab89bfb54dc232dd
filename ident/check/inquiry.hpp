#pragma once

#include "ident/check/test/checked_file.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// What is wrong with the files: channels without signal, copies and labels first; then the mistake whose undoing heals most, and
/// on the files without it the next, until none counts. `with_axis`: stretched axes are looked for, which takes neighbouring
/// lines.
CheckResult inquire(std::vector<CheckedFile> files, const Dofs& joint, const Control& control, bool with_axis);

/// The same of many parts, one after the other, so that work grows with the number of files and coordinates: every part is held against
/// what the assembly's files say of its own coordinates, and those that stand out most, 16 at most, are inquired. What takes two parts is
/// not looked for: exchanged files, labels of other parts.
CheckResult inquire_by_parts(const std::vector<CheckedFile>& files, const Dofs& joint, const Control& control, bool with_axis);

/// Of suspects, by the surest.
Verdict verdict_of(const std::vector<Suspect>& suspects);

}  // namespace jointid::ident
