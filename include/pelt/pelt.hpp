#pragma once

/// Exact collision detection for skinned characters. Build a SkinnedModel once, create a Pose for
/// each instance, set its joint palette every frame, and query two poses for contacts.
///
/// Failure: functions that validate outside input return a `Result`, which holds an error if the
/// input is invalid. If memory runs out, functions throw std::bad_alloc (or, on 32-bit platforms,
/// std::length_error). Models, poses, crowds and scratch are then still usable, nothing has leaked,
/// and lists to which results are appended are unchanged. Pelt itself throws no other exception.
///
/// Even if Pelt is compiled with -fno-exceptions, operator new can throw, because it belongs to the
/// standard library. Pelt's functions then do not release their memory. Do not catch the exception
/// in this case: the program must end.
///
/// A precondition is checked in every build if its comment says that the program aborts. Builds
/// without NDEBUG check more preconditions, and also abort if one is violated.
///
/// Terms: a model has V vertices, T triangles, J joints and M morph targets. Its triangles are
/// stored in the leaves of a tree. To open a node of this tree means to compute its posed vertices
/// and the boxes of its children. Queries open nodes on demand. In a pose, opened nodes stay open
/// for later queries until the joint palette or the morph weights change.
///
/// Queries are declared in these headers:
///
///     one or two poses              bounds, collide, contact, distance, inside
///     a pose and itself             self_collide, self_tracker, contact
///     a pose and a point            distance, inside
///     a pose and a direction        farthest
///     a pose and a ray              ray
///     a pose and a region or solid  solid
///     a solid and a ray             solid
///     a pose and a height field     height_field
///     a height field and a ray      height_field
///     a pose and vertex groups      vertex_groups
///     a crowd                       crowd
///
/// This header includes all headers of the library except pelt/asset.hpp, which reads glTF files
/// and needs the asset library, and pelt/instruction_set.hpp, which is for measurements and tests.

#include <pelt/cxx20.hpp>

#include <pelt/bounds.hpp>
#include <pelt/check.hpp>
#include <pelt/collide.hpp>
#include <pelt/contact.hpp>
#include <pelt/crowd.hpp>
#include <pelt/distance.hpp>
#include <pelt/farthest.hpp>
#include <pelt/height_field.hpp>
#include <pelt/inside.hpp>
#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>
#include <pelt/prepared.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>
#include <pelt/result.hpp>
#include <pelt/self_collide.hpp>
#include <pelt/self_tracker.hpp>
#include <pelt/shapes.hpp>
#include <pelt/solid.hpp>
#include <pelt/version.hpp>
#include <pelt/vertex_groups.hpp>
