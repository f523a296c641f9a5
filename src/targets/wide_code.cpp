/// Compiled once for each target, like all that it names.

#include "base/wide_code.hpp"

#include "bounds/bounding_box.hpp"
#include "bounds/bounding_radius.hpp"
#include "collide/pair_traversal.hpp"
#include "distance/pair_search.hpp"
#include "distance/point_search.hpp"
#include "field/field_collide.hpp"
#include "field/field_distance.hpp"
#include "pose/open_fully.hpp"
#include "pose/open_node.hpp"
#include "pose/root_box.hpp"
#include "ray/ray_traversal.hpp"
#include "region/region_descent.hpp"
#include "skin/palette_scan.hpp"
#include "solid/solid_search.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

extern const WideCode kWideCode;

const WideCode kWideCode = {scan_palette,
                            box_root,
                            pose_vertices,
                            root_box,
                            open_node,
                            open_all_exactly,
                            open_fully,
                            collide_trees,
                            bounding_box,
                            bounding_radius,
                            bound_of_set,
                            box_places,
                            first_hits,
                            any_hits,
                            all_hits,
                            winding_number,
                            descend_in_faces,
                            descend_in_capsule,
                            collide_field,
                            nearest_field_triangle,
                            nearest_triangles,
                            triangles_within,
                            nearest_to_point,
                            nearest_to_solid};

}  // namespace PELT_TARGET
}  // namespace pelt::detail
