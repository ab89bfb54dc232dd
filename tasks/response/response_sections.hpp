#pragma once

#include "scene/reader.hpp"
#include "tasks/response/response_scene.hpp"

namespace jointid::tasks {

/// A coordinate of [structure] by its number from 1, or a DOF of the files of [data].
SceneDof read_dof(const scene::Item& item, const ResponseScene& scene);

/// [structure]: matrices inline, or from files "m.mtx", "model.mat:M".
void read_structure(const scene::Item& item, const ident::Path& folder, ResponseScene& scene);

/// Throws InputError (usage) at `item`, which needs full matrices, where the scene has none: files, or more coordinates than
/// most_full.
void require_full(const scene::Item& item, const ResponseScene& scene);

/// The same at an item that marches in time, unless [structure] names modes for that.
void require_marching(const scene::Item& item, const ResponseScene& scene);

/// The friction of a joint: `law` with `parameters`, or "series" and "parallel" with `parts`, each such a law itself; none where
/// there is no law.
std::shared_ptr<const friction::Element> read_friction(const scene::Table& table);

/// One of [[joints]]; `number` counts from 1.
SceneJoint read_joint(const scene::Item& item, const ResponseScene& scene, std::size_t number);

/// The joint of [[joints]] with this number from 1, or this name.
std::size_t read_joint_place(const scene::Item& item, const ResponseScene& scene);

/// One of [[curves]], [clamping], [equivalent] and [transient]; they stand behind the joints.
SceneCurve read_curve(const scene::Item& item, const ResponseScene& scene);
SceneClamping read_clamping(const scene::Item& item, const ResponseScene& scene);
SceneEquivalent read_equivalent(const scene::Item& item, const ResponseScene& scene);
SceneTransient read_transient(const scene::Item& item, const ident::Path& folder, const ResponseScene& scene);

}  // namespace jointid::tasks
