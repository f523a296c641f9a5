"""Metrics of papers on bodies and motions, by their published definitions.

    from pelt import metrics

    share = metrics.colliding_triangles(model, poses)         # one number for each frame
    share.percent.mean()

Each function names the source of its definition, its units, and where the published convention
saturates or misjudges. Models and poses are those of `pelt.collide`. Thresholds are in model units;
the defaults assume metres. Decisions about triangles and insides are exact with respect to the
float32 posed vertices.

A body with itself:
    colliding_triangles        pairs of colliding triangles, as a share of all triangles
    capped_colliding_triangles  the same, with the cap of torch-mesh-isect
    smplify_x_filter           leaves out the pairs that SMPLify-X leaves out
    self_contact               vertices near others that are far along the surface (TUCH)
    BodyParts                  closed parts of a body, and vertices of one part inside another
Two bodies:
    vertices_inside            vertices of each body inside the other
    penetration_frames         frames with penetration (multiphys)
    depth                      depth of the deepest vertex
    summed_depth               depths of all vertices, summed (PhysiGen)
A body and the ground:
    ground                     penetration, floating and skating (PhysDiff)
Volumes of closed surfaces:
    intersection_volume        inside both of two bodies, exact but for rounding
    self_intersection_volume   of one body with itself
    volume                     of one body
    voxel_intersection_volume  inside two or more bodies, by voxels
    voxel_self_intersection_volume  of one body with itself, by the voxels of humansphereproxy
"""

from pelt.metrics._body_parts import BodyParts
from pelt.metrics._collisions import (SMPLIFY_X_IGNORED, CappedCollisions, CollidingTriangles,
                                      capped_colliding_triangles, colliding_triangles,
                                      smplify_x_filter)
from pelt.metrics._ground import Ground, ground
from pelt.metrics._penetration import (Depth, InsideVertices, PenetrationFrames, SummedDepth,
                                       depth, penetration_frames, summed_depth,
                                       vertices_inside)
from pelt.metrics._self_contact import Geodesics, SelfContact, self_contact
from pelt.metrics._volume import (Volumes, VoxelVolume, intersection_volume,
                                  self_intersection_volume, volume, voxel_intersection_volume,
                                  voxel_self_intersection_volume)

__all__ = [
    "BodyParts", "CappedCollisions", "CollidingTriangles", "Depth", "Geodesics", "Ground",
    "InsideVertices", "PenetrationFrames", "SMPLIFY_X_IGNORED", "SelfContact", "SummedDepth", "Volumes", "VoxelVolume",
    "capped_colliding_triangles", "colliding_triangles", "depth", "ground", "intersection_volume",
    "penetration_frames", "self_contact", "self_intersection_volume", "smplify_x_filter",
    "summed_depth", "vertices_inside", "volume", "voxel_intersection_volume",
    "voxel_self_intersection_volume",
]
