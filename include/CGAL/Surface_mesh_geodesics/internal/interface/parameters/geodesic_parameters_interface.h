// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

// The named parameters that this package adds to those of CGAL, in the form of CGAL's parameters_interface.h: tag, name
// of the tag's value, name of the function. There is no include guard: as CGAL's file, this one is included several
// times, each time with another meaning of CGAL_add_named_parameter(). Without a meaning it is empty.
//
// On submission these lines become lines of CGAL's file; scripts/lay_out_in_cgal.sh writes them there.

// CGAL has this one since its Shape_detection takes named parameters. It keeps CGAL's tag there (Parameter_sequence.h).
#ifdef CGAL_add_named_parameter_of_newer_CGAL
CGAL_add_named_parameter_of_newer_CGAL(maximum_distance_t, maximum_distance, maximum_distance)
#endif

#ifdef CGAL_add_named_parameter
// List of named parameters used in the package 'Surface_mesh_geodesics'
// distances: the vertices whose distances are wanted
CGAL_add_named_parameter(targets_t, targets, targets)
// distances: the lengths that are added to the distances from each source
CGAL_add_named_parameter(source_offsets_t, source_offsets, source_offsets)
// distances: receives the number of the nearest source of each vertex
CGAL_add_named_parameter(nearest_source_map_t, nearest_source_map, nearest_source_map)
// distances and sampling: a pointer to the counts of the work
CGAL_add_named_parameter(statistics_t, statistics, statistics)
// distances: the faces through which no path may lead
CGAL_add_named_parameter(faces_to_avoid_t, faces_to_avoid, faces_to_avoid)
// distances: the edges that no path may cross
CGAL_add_named_parameter(edges_to_avoid_t, edges_to_avoid, edges_to_avoid)
// labels: receives the distance of each vertex from its nearest site
CGAL_add_named_parameter(vertex_distance_map_t, vertex_distance_map, vertex_distance_map)
// labels: the lengths by which the distances from each site are reduced
CGAL_add_named_parameter(site_weights_t, site_weights, site_weights)
// sampling: the vertices with which it begins
CGAL_add_named_parameter(first_samples_t, first_samples, first_samples)
// sampling and relaxation: the curves from which samples and sites keep away
CGAL_add_named_parameter(first_curves_t, first_curves, first_curves)
// sampling: the distance of the farthest vertex from its sample at which it ends
CGAL_add_named_parameter(covering_radius_t, covering_radius, covering_radius)
// stored matrices: whether distances are rounded to 32 bits
CGAL_add_named_parameter(use_float32_t, use_float32, use_float32)
// stored matrices: whether each pair of vertices is stored once
CGAL_add_named_parameter(use_symmetry_t, use_symmetry, use_symmetry)
// stored matrices: the number of rows of a shard
CGAL_add_named_parameter(rows_per_shard_t, rows_per_shard, rows_per_shard)
// stored matrices: the first row that a call computes
CGAL_add_named_parameter(first_row_t, first_row, first_row)
// stored matrices: the row behind the last one that a call computes
CGAL_add_named_parameter(end_row_t, end_row, end_row)
// stored matrices: the number of bytes for rows that are not written yet
CGAL_add_named_parameter(memory_limit_t, memory_limit, memory_limit)
// stored matrices: the name of the mesh in the manifest
CGAL_add_named_parameter(mesh_name_t, mesh_name, mesh_name)
// stored matrices: whether files of shards that are done are compared with their checksums
CGAL_add_named_parameter(compare_checksums_t, compare_checksums, compare_checksums)
#endif
