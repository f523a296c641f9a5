"""Exact collision detection for skinned characters, over whole clips.

A model is a mesh with joints and weights. It is built once:

    import pelt
    model = pelt.Model(rest, faces, weights)      # [V, 3], [T, 3], [V, J]
    knight = pelt.load("knight.glb")              # or from a glTF file: knight.model

A clip is an array of palettes, one matrix per frame and joint, row-major as NumPy has them:

    palettes = knight.palettes("Walk", fps=30)    # [F, J, 4, 4]

A query answers for all frames in one call, on all processors:

    contacts = pelt.collide(model_a, palettes_a, model_b, palettes_b)
    contacts.frame, contacts.triangle_a, contacts.triangle_b     # [N] each, sorted
    contacts.per_frame()                                         # [F] number of contacts

Palettes are [F, J, 4, 4] or [F, J, 3, 4], or [J, 4, 4] for a single frame, in float32 or float64, in
any memory layout. Arrays of other libraries are read without a copy if they have `__dlpack__` and
are in the memory of the CPU. A matrix transforms rest positions into the frame that all poses of a
call share: world matrix of the character x transform of the joint x inverse bind matrix. In place
of palettes, each function also takes `Poses`, which adds weights of morph targets and offsets of
vertices, and `Vertices`, which gives the positions of all vertices. A clip of one frame is combined
with all frames of the other clip.

Answers are exact with respect to the float32 posed vertices (`posed_vertices`), and do not depend on
the machine or the number of threads. Lengths are in model units. Triangles and joints are numbered
from 0, as in the arrays of the model.

Which triangles touch?
    collide              triangles of two models that intersect
    self_collide         triangles of one model that intersect each other (see `SelfFilter` and
                         `Character.self_filter`)
    near_joints          joints that are neighbours in the body, for `SelfFilter`
    intersects           only whether anything intersects, in each frame
    clearance            triangles of two models that are close to each other
    collide_crowd        triangles of many characters that intersect
    contact_geometry     positions, normals, depths, curves and patches of contacts
    self_contact_geometry
Between frames:
    collide_moving       triangles that intersect at any time between two frames, and when first
    self_collide_moving
    first_contact        the first contact of each step
Simple solids and terrain:
    collide_solid        triangles that touch a half-space, box, sphere or capsule
    solid_distance       least distance from it
    collide_field        triangles that intersect a height field
    field_distance       least distance from it
Distances, rays, bounds:
    distance             least distance of two models
    closest_points       points of the surface that are closest to given points
    cast_rays            first hits of rays
    bounds               boxes and spheres
Inside and outside of closed surfaces:
    side_of              whether points are inside
    winding_numbers      how often the surface encloses points
    vertices_inside      which vertices of one model are inside another
    deepest_vertex       the vertex that is deepest inside another model
    posed_vertices       positions of all vertices
Datasets, in modules of their own:
    pelt.metrics         metrics of papers, by their definitions
    pelt.body_models     body models of the SMPL family
    pelt.motions         motions of AMASS and Inter-X
    pelt.datasets        tables of many clips or pairs of clips, and `python -m pelt metrics`

Every function takes `threads` (default: all processors; the answer is the same for any number) and
`progress`: True draws a progress bar, None (the default) draws one if the call takes more than two
seconds and a person watches; a function is called with the number of finished frames. Ctrl-C ends
a call. The interpreter lock is released during a call.

Invalid arguments raise `pelt.Error`, a ValueError that names the argument and the frame.
"""

from pelt._arrays import Array
from pelt._bounds import Bounds, bounds
from pelt._character import Character, Clip, Part, load
from pelt._collide import clearance, collide, intersects
from pelt._contact_geometry import ContactGeometry, contact_geometry, self_contact_geometry
from pelt._contacts import Contacts, SelfContacts
from pelt._crowd import CrowdContacts, collide_crowd
from pelt._distance import ClosestPoints, Distances, SurfacePoints, closest_points, distance
from pelt._height_field import HeightField, collide_field, field_distance
from pelt._inside import (Penetrations, deepest_vertex, side_of, vertices_inside,
                          winding_numbers)
from pelt._model import Model
from pelt._motion import (MovingContacts, SelfMovingContacts, collide_moving, first_contact,
                          self_collide_moving)
from pelt._near_joints import NearJoints, near_joints
from pelt._pelt import Error, __version__
from pelt._poses import Poses, PosesLike, Vertices, posed_vertices
from pelt._rays import RayHits, cast_rays
from pelt._self_collide import SelfFilter, self_collide
from pelt._solid import (Box, Capsule, HalfSpace, OrientedBox, Solid, SolidContacts,
                         SolidDistances, Sphere, collide_solid, solid_distance)

Error.__module__ = "pelt"  # the name that messages and users see

__all__ = [
    "Array", "Bounds", "Box", "Capsule", "Character", "Clip", "ClosestPoints", "ContactGeometry",
    "Contacts", "CrowdContacts", "Distances", "Error", "HalfSpace", "HeightField", "Model",
    "MovingContacts", "NearJoints", "OrientedBox", "Part", "Penetrations", "Poses", "PosesLike",
    "RayHits", "SelfContacts", "SelfFilter", "SelfMovingContacts", "Solid", "SolidContacts",
    "SolidDistances", "Sphere", "SurfacePoints", "Vertices", "__version__", "bounds", "cast_rays",
    "clearance", "closest_points", "collide", "collide_crowd", "collide_field", "collide_moving",
    "collide_solid", "contact_geometry", "deepest_vertex", "distance", "field_distance",
    "first_contact", "intersects", "load", "near_joints", "posed_vertices", "self_collide",
    "self_collide_moving", "self_contact_geometry", "side_of", "solid_distance", "vertices_inside",
    "winding_numbers",
]
