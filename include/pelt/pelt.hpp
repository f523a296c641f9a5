#pragma once

/// Exact collision detection for skinned characters. Build a SkinnedModel once, create a Pose for
/// each instance, set its joint palette every frame, and query two poses for contacts.
///
/// Failure: functions that validate outside input return a `Result`, which holds an error if the
/// input is invalid. If memory runs out, functions throw std::bad_alloc (or, on 32-bit platforms,
/// std::length_error); Pelt itself throws no other exception. After that, models, poses, crowds and
/// scratch are still usable, nothing has leaked, and lists to which results are appended are
/// unchanged. If Pelt is compiled with -fno-exceptions, running out of memory must end the program,
/// because such code cannot release what it holds: do not catch exceptions of Pelt then.
///
/// A violated precondition aborts the program where Pelt checks it. Comments name preconditions
/// that are checked in every build; builds without NDEBUG check more.
///
/// Terms: a model has V vertices, T triangles, J joints and M morph targets. Its triangles are
/// stored in the leaves of a tree. To open a node of this tree means to compute its posed vertices
/// and the boxes of its children. Queries open nodes on demand. In a pose, opened nodes stay open
/// for later queries until the joint palette or the morph weights change.
///
/// Headers: queries of poses, and of a pose and points, are in the header that is named after their
/// subject: bounds, collide, contact, distance, farthest, inside. Queries with any other operand
/// are in the header that defines this operand: ray, solid, height_field, vertex_groups, crowd.
/// Rays against a solid or a height field are in the header of the solid or the height field.

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
#include <pelt/shapes.hpp>
#include <pelt/solid.hpp>
#include <pelt/version.hpp>
#include <pelt/vertex_groups.hpp>
