#pragma once

#include <filesystem>

#include "python/outcome.hpp"
#include "python/scene_text.hpp"

namespace jointid::python {

/// `jointid solve` of a scene whose [joint] has `lines`. Throws InputError and Interrupted, as decouple() does.
Outcome solve_lines(const SceneText& scene, const ident::Control& control);

/// `jointid plan` of Z at every line, with `--bound` or without.
Outcome plan_lines(const SceneText& scene, bool with_bound, const ident::Control& control);

/// `jointid decouple`. `out`: where the FRFs of B are written; empty: they stay in memory.
Outcome decouple(const SceneText& scene, const std::filesystem::path& out, const ident::Control& control);

}  // namespace jointid::python
