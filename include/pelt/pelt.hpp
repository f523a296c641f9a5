#pragma once

/// Exact collision detection for skinned characters. Build a SkinnedModel once, create a Pose for
/// each instance, set its joint palette every frame, and query two poses for contacts.
///
/// Failure: functions report invalid input with `Result` and throw nothing themselves. If memory
/// runs out, std::bad_alloc leaves the function that needed it. Models, poses, crowds and scratch
/// stay usable then, nothing leaks, and lists to which results are appended are unchanged.

#include <pelt/cxx20.hpp>

#include <pelt/bounds.hpp>
#include <pelt/check.hpp>
#include <pelt/collide.hpp>
#include <pelt/contact.hpp>
#include <pelt/crowd.hpp>
#include <pelt/distance.hpp>
#include <pelt/farthest.hpp>
#include <pelt/groups.hpp>
#include <pelt/height_field.hpp>
#include <pelt/inside.hpp>
#include <pelt/math.hpp>
#include <pelt/mesh.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>
#include <pelt/prepared.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>
#include <pelt/region.hpp>
#include <pelt/result.hpp>
#include <pelt/shapes.hpp>
#include <pelt/solid.hpp>
#include <pelt/version.hpp>
