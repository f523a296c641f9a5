#pragma once

/// Exact collision detection for skinned characters. Build a `SkinnedModel` once and create a
/// `Pose` for each instance. In every frame, set the joint palettes of the poses and query pairs of
/// poses for contacts.
///
/// Terms: a model has V vertices, T triangles, J joints and M morph targets. A joint palette is one
/// matrix per joint. `[V][K]` is the shape of an array: V rows with K elements each. The triangles
/// of a model are stored in a tree of nodes. To open a node means to compute, for the current
/// palette and morph weights, its posed vertices and the boxes of its children. Queries open nodes
/// on demand. A node of a pose stays open for later queries until the joint palette, the morph
/// weights, the offsets or the given vertices change.
///
/// Queries are declared in these headers:
///
///     one or two poses              bounds, collide, contact, distance, inside, search, volume
///     two poses in motion           motion, first_contact_search
///     a pose and itself             self_collide, self_tracker, contact
///     a pose in motion and itself   self_motion
///     a pose and a point            distance, inside
///     a pose and a direction        farthest
///     a pose and a ray              ray
///     a pose and a region or solid  solid
///     a solid and a ray             solid
///     a pose and a height field     height_field
///     a pose in motion and a region or height field   solid, height_field
///     a height field and a ray      height_field
///     a pose and vertex groups      vertex_groups
///     a crowd                       crowd
///
/// Failure: functions that validate outside input return a `Result`, which contains an error if the
/// input is invalid. If memory runs out, functions throw std::bad_alloc or, on 32-bit platforms,
/// possibly std::length_error. After such an exception, models, poses, crowds and scratch are still
/// usable, nothing has leaked, and lists to which results are appended are unchanged. Pelt throws
/// no other exception.
///
/// In a build with -fno-exceptions, operator new can still throw, because it belongs to the
/// standard library. Pelt's functions then do not release their memory. Do not catch the exception
/// in such a build: let the program end.
///
/// Preconditions: if a comment says that the program aborts, every build checks the precondition.
/// Builds without NDEBUG check further preconditions and abort if one is violated.
///
/// This header includes all headers of the library except two. pelt/asset.hpp reads glTF files and
/// needs the asset library. pelt/instruction_set.hpp is for measurements and tests.

#include <pelt/cxx20.hpp>

#include <pelt/bounds.hpp>
#include <pelt/check.hpp>
#include <pelt/collide.hpp>
#include <pelt/contact.hpp>
#include <pelt/crowd.hpp>
#include <pelt/distance.hpp>
#include <pelt/farthest.hpp>
#include <pelt/first_contact_search.hpp>
#include <pelt/height_field.hpp>
#include <pelt/inside.hpp>
#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/model.hpp>
#include <pelt/motion.hpp>
#include <pelt/near_joints.hpp>
#include <pelt/pose.hpp>
#include <pelt/prepared.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>
#include <pelt/result.hpp>
#include <pelt/search.hpp>
#include <pelt/self_collide.hpp>
#include <pelt/self_motion.hpp>
#include <pelt/self_tracker.hpp>
#include <pelt/shapes.hpp>
#include <pelt/solid.hpp>
#include <pelt/version.hpp>
#include <pelt/vertex_groups.hpp>
#include <pelt/volume.hpp>
