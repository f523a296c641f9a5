#pragma once

/// Exact collision detection for skinned characters: a SkinnedModel is built once, a Pose moves it,
/// a query asks two Poses, Contacts come out.

#include <pelt/bounds.hpp>
#include <pelt/check.hpp>
#include <pelt/collide.hpp>
#include <pelt/contact.hpp>
#include <pelt/crowd.hpp>
#include <pelt/distance.hpp>
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
