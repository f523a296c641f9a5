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
/// Read these six headers first: math, mesh, model, pose, query, collide. The other headers can be
/// read when they are needed:
///
///     a pose and another pose       collide, distance, inside, surface
///     a pose and itself             self, self_filter, surface, inside
///     a pose alone                  bounds, inside
///     a pose and a point            distance, inside
///     a pose and a ray              ray
///     a pose and a region or solid  solid
///     a pose and a height field     height_field
///     a step from pose to pose      motion, self, solid, height_field
///     a query in slices of work     search
///     many instances                crowd
///     glTF files                    asset
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
/// This header includes all headers except pelt/asset.hpp, which needs the asset library.

#include <pelt/config.hpp>

#include <pelt/bounds.hpp>
#include <pelt/collide.hpp>
#include <pelt/crowd.hpp>
#include <pelt/distance.hpp>
#include <pelt/height_field.hpp>
#include <pelt/inside.hpp>
#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/model.hpp>
#include <pelt/motion.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>
#include <pelt/result.hpp>
#include <pelt/search.hpp>
#include <pelt/self.hpp>
#include <pelt/self_filter.hpp>
#include <pelt/solid.hpp>
#include <pelt/surface.hpp>
#include <pelt/version.hpp>
