#pragma once

/// Each adapter's file provides the method and the version of its library.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>
#include <string>

namespace pelt::peers {

std::unique_ptr<rivals::PosedMeshMethod> make_fcl();
std::string fcl_version();

std::unique_ptr<rivals::PosedMeshMethod> make_embree();
std::string embree_version();

/// With Pelt's predicate, and with Bullet's triangle test.
std::unique_ptr<rivals::PosedMeshMethod> make_bullet();
std::unique_ptr<rivals::PosedMeshMethod> make_bullet_own();
std::string bullet_version();

std::unique_ptr<rivals::PosedMeshMethod> make_ode();
std::string ode_version();

std::unique_ptr<rivals::PosedMeshMethod> make_cgal_tree();
std::unique_ptr<rivals::PosedMeshMethod> make_cgal_boxes();
std::string cgal_version();

}  // namespace pelt::peers
