"""The faults that check_mutations.py puts into the headers, one at a time.

A row has the name of the mutant, the header, a text that occurs there once, its replacement, why that is a
fault, and the tests that should find it, the cheapest first. The row of a mutant that changes no answer ends with the
reason why no test can find it.
"""

INTERNAL = "CGAL/Surface_mesh_geodesics/internal/"

PRUNING_RULES = INTERNAL + "window/Pruning_rules.h"
WINDOW_PRUNING = INTERNAL + "window/window_pruning.h"
RIVAL = INTERNAL + "window/Vertex_rival.h"
WINDOW_NUMBERS = INTERNAL + "window/lanes/Window_numbers.h"
LANE_PRUNING = INTERNAL + "window/lanes/lane_pruning.h"
LIST_LOOPS = INTERNAL + "window/lanes/List_loops.h"
VECTORS = INTERNAL + "window/lanes/Lanes.h"
SIMD = INTERNAL + "window/simd.h"
DOUBLE_PAIR = INTERNAL + "window/Double_pair.h"
WINDOW = INTERNAL + "window/Window.h"
WINDOW_LISTS = INTERNAL + "window/Window_lists.h"
LIST_CROSSING = INTERNAL + "window/Window_list_crossing.h"
GEOMETRY = INTERNAL + "numeric/planar_geometry.h"
TOLERANCE = INTERNAL + "numeric/Tolerance.h"
ANGLE_SUM = INTERNAL + "numeric/Angle_sum.h"
FIRST_WINDOW = INTERNAL + "window/window_of_pseudo_source.h"
STARS = INTERNAL + "propagation/Star_propagation.h"
SECTOR = INTERNAL + "propagation/Emission_sector.h"
NORMALS = INTERNAL + "propagation/Sector_between_normals.h"
WAVEFRONT = INTERNAL + "propagation/Wavefront.h"
SOURCES = INTERNAL + "surface/Source_insertion.h"
PARALLEL = INTERNAL + "propagation/parallel/Parallel_distance_propagation.h"
PART = INTERNAL + "propagation/parallel/Wavefront_part.h"
DIVISION = INTERNAL + "propagation/parallel/Wavefront_division.h"
VERTEX_RECORDS = INTERNAL + "propagation/parallel/Vertex_records.h"
SHARING = INTERNAL + "propagation/parallel/Work_sharing.h"
FARTHEST = INTERNAL + "surface/Farthest_vertex_queue.h"
STRIP = INTERNAL + "window/strips/Strip.h"
STRIP_SPLITTING = INTERNAL + "window/lanes/strip_splitting.h"
STRIP_LOOPS = INTERNAL + "window/lanes/Strip_loops.h"
STRIP_FRONT = INTERNAL + "propagation/curves/Strip_front.h"
CURVE_RUN = INTERNAL + "propagation/curves/Curve_run.h"
CURVE_ARRIVALS = INTERNAL + "window/strips/Curve_arrivals.h"
PATH_RUN = INTERNAL + "propagation/curves/Path_run_from_curves.h"
SURFACE_SOURCES = INTERNAL + "interface/Surface_with_sources.h"
PATH_SOLVER = INTERNAL + "interface/Path_solver.h"
LOCATION_DISTANCE = INTERNAL + "paths/distance_at_location.h"
CURVE_INSERTION = INTERNAL + "surface/curves/Curve_insertion.h"
DISTANCE_FIELD = INTERNAL + "surface/Vertex_distance_field.h"
SOURCE_SET = INTERNAL + "surface/Source_set.h"
CURVE_SIDES = INTERNAL + "surface/curves/Curve_sides.h"
ISOLINE_CHOICE = INTERNAL + "interface/isolines/Isoline_choice.h"
CURVE_PATH_WRITER = INTERNAL + "interface/curves/Curve_path_writer.h"
CURVE_SEGMENTS = INTERNAL + "interface/curves/curve_segments.h"
SURFACE_CURVE = "CGAL/Surface_mesh_geodesics/Surface_curve.h"
BORDER_CYCLES = INTERNAL + "interface/curves/border_cycles.h"
PATH_CURVE = "CGAL/Surface_mesh_geodesics/shortest_path_curve.h"
RAY_SECTORS = INTERNAL + "paths/Ray_sectors.h"
PATH_DIRECTIONS = INTERNAL + "interface/directions/path_directions.h"
STRAIGHT = INTERNAL + "paths/Straight_piece.h"
ISOLINES = INTERNAL + "paths/isoline_crossings.h"
ISOLINE_SWEEP = INTERNAL + "paths/Isoline_sweep.h"
FACE_DISTANCES = INTERNAL + "paths/Face_distances.h"
STRIP_FIELD = INTERNAL + "window/strips/Edge_strip_field.h"
FACE_WINDOWS = INTERNAL + "window/Face_windows.h"
REMOVAL = INTERNAL + "Voronoi/Redundant_window_removal.h"
OWNERS = INTERNAL + "Voronoi/edges/Vertex_owners.h"
ENTERING = INTERNAL + "window/passing/entering_windows.h"
PASSED = INTERNAL + "window/passing/Passed_faces.h"
RELAY = INTERNAL + "propagation/parallel/Window_relay.h"
WINDOW_FIELD = INTERNAL + "window/Edge_window_field.h"
RADIX_HEAP = INTERNAL + "numeric/Radix_heap.h"
SINGLE_PRECISION = INTERNAL + "numeric/single_precision.h"
BISECTOR = INTERNAL + "numeric/Weighted_bisector.h"
FACE_PARTITION = INTERNAL + "Voronoi/Face_partition.h"
COMPLEX = INTERNAL + "Voronoi/Voronoi_complex.h"
PATH_THINNING = INTERNAL + "paths/Path_thinning.h"
LAZY_PATHS = INTERNAL + "interface/Lazy_path_structure.h"
UNFOLDING = INTERNAL + "surface/unfolding.h"
INTRINSIC_FACE = INTERNAL + "surface/Intrinsic_face.h"
FACE_SHAPE = INTERNAL + "surface/face_shape.h"
EDGE_PARTITION = INTERNAL + "Voronoi/edges/Edge_partition.h"
DIAGRAM_KEEPER = INTERNAL + "Voronoi/Diagram_window_keeper.h"
SEPARATION = INTERNAL + "applications/Location_separation.h"
DISTANCE_CERTIFICATE = INTERNAL + "interface/Distance_certifier.h"
DIAGRAM_CERTIFICATE = INTERNAL + "applications/Diagram_certifier.h"
DIAGRAM_CHECK = INTERNAL + "applications/Diagram_distance_check.h"
DIAGRAM_SAMPLES = INTERNAL + "applications/Diagram_samples.h"
SITE_WITNESS = INTERNAL + "applications/Site_witness.h"
ARC_PIECE = INTERNAL + "certificate/Arc_piece.h"
INTRINSIC_MESH = INTERNAL + "surface/Intrinsic_mesh.h"
EQUAL_SOURCES = INTERNAL + "surface/equal_sources.h"
LOCATOR = INTERNAL + "Voronoi/Cell_locator.h"
MEASURES = INTERNAL + "Voronoi/Voronoi_cell_measures.h"
FACE_CUT = INTERNAL + "Voronoi/Voronoi_face_cut.h"
CHECKS = INTERNAL + "certificate/Distance_checks.h"
VIOLATION = INTERNAL + "certificate/Worst_violation.h"
TARGET_REGION = INTERNAL + "propagation/rows/Target_region.h"
PEELING = INTERNAL + "propagation/rows/peeling_order.h"
MATRIX = INTERNAL + "propagation/rows/Distance_matrix.h"
READER = INTERNAL + "interface/Face_graph_reader.h"
SURFACE = INTERNAL + "interface/Intrinsic_surface.h"
DEPARTURE = INTERNAL + "paths/Departure.h"
WALK = INTERNAL + "interface/tracing/Straightest_walk.h"
FAN = INTERNAL + "interface/tracing/Vertex_fan.h"
TRACE_WALLS = INTERNAL + "interface/tracing/Layouts_with_walls.h"
TRACE_AVOIDED = INTERNAL + "interface/tracing/Layouts_with_avoided_faces.h"
DISTANCE_FUNCTIONS = INTERNAL + "interface/distance_functions.h"
CURVES_AT_WALLS = INTERNAL + "surface/curves/curves_at_walls.h"
VERTEX_COPIES = INTERNAL + "surface/walls/Vertex_copies.h"
WALL_CUT = INTERNAL + "surface/walls/Wall_cut.h"
SOURCES_AT_WALLS = INTERNAL + "surface/walls/sources_at_walls.h"
LAZY_DIAGRAM = INTERNAL + "interface/diagram/Lazy_Voronoi_diagram.h"
DIAGRAM_RUN = INTERNAL + "interface/diagram/propagate_diagram.h"
CELL_TRIANGLES = INTERNAL + "interface/diagram/Cell_triangles.h"
CELL_TOPOLOGY = INTERNAL + "interface/diagram/Cell_topology.h"
EDGE_CONTRACTION = INTERNAL + "Voronoi/Edge_contraction.h"
BLOCK_TEAM = INTERNAL + "propagation/Block_team.h"
BUILDER = INTERNAL + "surface/Intrinsic_mesh_builder.h"
CHUNKS = INTERNAL + "propagation/Chunk_team.h"
LOWER_BOUND = INTERNAL + "certificate/Lower_bound_check.h"
FACE_PATHS = INTERNAL + "certificate/Face_paths.h"
LOWER_FUNCTION = INTERNAL + "certificate/Lower_bound_function.h"
EDGE_FUNCTION = INTERNAL + "certificate/Edge_distance_function.h"
SAMPLE_PLACEMENT = INTERNAL + "applications/Sample_placement.h"
SAMPLES = INTERNAL + "applications/Farthest_point_sampling.h"
RELAXATION = INTERNAL + "applications/Lloyd_relaxation.h"
REMESHING = INTERNAL + "applications/Remeshing.h"
REMESHING_INPUT = INTERNAL + "applications/Remeshing_input.h"
FRONT_EVENT = INTERNAL + "Voronoi/fronts/Front_event.h"
NPY = INTERNAL + "numeric/files/Npy_file.h"
LOCK = INTERNAL + "numeric/files/Lock_file.h"
JSON = INTERNAL + "numeric/files/Json_value.h"
STORE_FOLDER = INTERNAL + "applications/matrix_store/Store_folder.h"
STORE_LAYOUT = INTERNAL + "applications/matrix_store/Store_layout.h"
STORE_ROWS = INTERNAL + "applications/matrix_store/Store_computation.h"
STORED_MATRIX = INTERNAL + "applications/matrix_store/Stored_matrix.h"
STORE_MATRIX = INTERNAL + "applications/matrix_store/store_matrix.h"
STORE_CHECK = INTERNAL + "applications/matrix_store/check_stored_matrix.h"
STORE_INPUT = INTERNAL + "applications/matrix_store/Store_input.h"

WINDOWS = "test_window_pruning"
LAWS = "test_predicate_laws"
FACE_LAWS = "test_laws_in_faces"
LIST_CROSSINGS = "test_window_list_crossing"
EMISSION = "test_emission_sector"
PIECES = "test_straight_pieces"
PLANE = "test_planar_geometry"
ANALYTIC = "test_distances_analytic"
FLAT = "test_distances_in_the_plane"
RULES = "test_pruning_rules"
LANES = "test_numbers_of_lanes"
NEEDLES = "test_needles_and_caps"
OPTIONS = "test_options"
STORE = "test_distance_matrix_store"
STORE_FILES = "test_distance_matrix_store_folder"
KILLS = "test_distance_matrix_store_kills"
INVALID = "test_invalid_input"
SOLVER = "test_distance_solver"
PARALLEL_TEST = "test_parallel_propagation"
WORK_SHARING = "test_work_sharing"
PARALLEL_KEEPERS = "test_parallel_keepers"
REMESHING_TEST = "test_remeshing_topology"
SAMPLING = "test_farthest_point_sampling"
PATHS = "test_paths_interface"
PATHS_BUILDING = "test_paths_building"
HOSTILE_PATHS = "test_paths_on_hostile_meshes"
ISOLINE_TEST = "test_isolines"
ISOLINES_TEST = "test_geodesic_isolines"
SIGNED_ISOLINES = "test_signed_isolines"
CURVE_ISOLINES = "test_isolines_from_curves"
CROSSINGS = "test_isoline_crossings"
BY_HAND = "test_Voronoi_by_hand"
TRACE = "test_trace_geodesic"
TRACE_OBSTACLES = "test_traces_around_obstacles"
LOGARITHM = "test_logarithmic_map"
OBSTACLES = "test_obstacles"
WALLS = "test_walls"
WALLS_OF_FUNCTIONS = "test_walls_of_functions"
WALLS_OF_MATRICES = "test_walls_of_matrices"
WALLS_AND_CURVES = "test_walls_and_curves"
WALLS_OF_DIAGRAMS = "test_walls_of_diagrams"
VORONOI_OF_CURVES = "test_Voronoi_of_curves"
WALLS_OF_CERTIFIED_DIAGRAMS = "test_walls_of_certified_diagrams"
SAMPLING_BESIDE_CURVES = "test_sampling_beside_curves"
RELAXATION_BESIDE_CURVES = "test_relaxation_beside_curves"
DIRECTIONS = "test_directions_of_all_vertices"
PATHS_WITH_OFFSETS = "test_paths_from_curves_with_offsets"
OBSTACLES_OF_APPLICATIONS = "test_obstacles_of_applications"
CURVES = "test_curves"
SIGNS = "test_signed_distances"
HOSTILE_CURVES = "test_curves_on_hostile_meshes"
CURVE_PATHS = "test_paths_from_curves"
BORDER_CURVES = "test_border_curves"
NEAREST_SITES = "test_nearest_sites"
PAIR_PATHS = "test_geodesic_path"
BORDER_DIRECTIONS = "test_directions_at_borders"
CURVES_OF_PATHS = "test_shortest_path_curve"
BOUNDS = "test_radix_heap"
KEPT_WINDOWS = "test_face_windows"
PLANAR = "test_Voronoi_planar"
SYMMETRIC = "test_Voronoi_symmetric"
CROWDED = "test_crowded_faces"
HOSTILE_DIAGRAMS = "test_Voronoi_on_hostile_meshes"
RANDOM_DIAGRAMS = "test_Voronoi_random"
CUT = "test_Voronoi_cut"
NEAR_SITES = "test_Voronoi_nearly_equal_sites"
CERTIFICATE_CHECKS = "test_certificate_checks"
CERTIFICATE_OF_STRIPS = "test_certificate_of_strips"
CERTIFICATION = "test_certification_of_distances"
CERTIFICATION_OF_CURVES = "test_certification_of_curves"
CERTIFICATION_OF_CURVE_DIAGRAMS = "test_certification_of_diagrams_of_curves"
MATRICES = "test_distance_matrix"
DIAGRAM_CERTIFICATION = "test_certification_of_Voronoi_diagrams"
ARC_PIECES = "test_arc_pieces"
SMALL = "test_small_components"
PARALLEL_APPLICATIONS = "test_parallel_applications"
BLOCKS = "test_reading_in_blocks"
REACHED = "test_reached_components"
PRODUCTS = "test_rounded_products"
FUZZ = "test_fuzz_distances"

MUTANTS = [
    # --- the rules that remove windows ---
    ("rule_1_off", PRUNING_RULES,
     "rule_1 = true;", "rule_1 = false;",
     "Rule 1 saves no work", (RULES,)),
    ("pair_rules_off", PRUNING_RULES,
     "pair_rules = true;", "pair_rules = false;",
     "the rules of pairs save no work", (RULES,)),
    ("vertex_rule_off", PRUNING_RULES,
     "vertex_rule = true;", "vertex_rule = false;",
     "checking with vertices saves no work", (RULES,)),
    ("rival_wins_all_ties", RIVAL,
     "factor(wins_ties ? 1 + Tolerance<FT>::distance() : 1 - Tolerance<FT>::distance())",
     "factor(wins_ties ? 1 + Tolerance<FT>::distance() : 1 + Tolerance<FT>::distance())",
     "a vertex from which no window starts takes windows away that are as near", (WINDOWS,)),
    ("rival_wins_no_tie", RIVAL,
     "factor(wins_ties ? 1 + Tolerance<FT>::distance() : 1 - Tolerance<FT>::distance())",
     "factor(wins_ties ? 1 - Tolerance<FT>::distance() : 1 - Tolerance<FT>::distance())",
     "among vertices nearer to each other than rounding no path ever ends", (WINDOWS,)),
    ("vertex_rule_at_near_end_on_the_right", LANE_PRUNING,
     "L::less(right.distance + (length - w.begin), w.begin_distance * right.factor)",
     "L::less(right.distance + (length - w.end), w.end_distance * right.factor)",
     "the right vertex takes all of a window although it is nearer at one end only", (WINDOWS,)),
    ("vertex_rule_at_near_end", LANE_PRUNING,
     "L::less(left.distance + w.end, w.end_distance * left.factor)",
     "L::less(left.distance + w.begin, w.begin_distance * left.factor)",
     "a vertex that is nearer at one end of a window takes all of it", (WINDOWS,)),
    ("vertex_rule_one_side", LANE_PRUNING,
     "       | L::less(right.distance + (length - w.begin), w.begin_distance * right.factor);", ";",
     "windows behind the right vertex are propagated", (WINDOWS,)),
    ("crossed_windows_wrong_one", WINDOW_PRUNING,
     "  if(is_clearly_less(at_left, at_right))\n    return Pair_outcome::RIGHT_IS_DOMINATED;",
     "  if(is_clearly_less(at_right, at_left))\n    return Pair_outcome::RIGHT_IS_DOMINATED;",
     "of two crossed windows the nearer one is removed", (WINDOWS,)),
    ("crossed_windows_kept", WINDOW_PRUNING,
     "    return prune_crossed_windows(left, right);", "    return Pair_outcome::KEEP_BOTH;",
     "the rule for crossed windows saves no work", (WINDOWS,)),
    ("crossed_windows_height", WINDOW_PRUNING,
     "const FT h = (left.begin - right.end) / approach;", "const FT h = (right.end - left.begin) / approach;",
     "crossed windows are compared at a point where they do not cross", (WINDOWS,)),
    ("crossed_windows_slope_of_other_end", WINDOW_PRUNING,
     "(right.image_x - right.end) / right.image_depth;", "(right.image_x - right.begin) / right.image_depth;",
     "crossed windows are compared where the outermost path of one meets the other", (LAWS,)),
    ("crossed_windows_without_roots", WINDOW_PRUNING,
     "- (left.begin_distance - left.root_distance) * h / left.image_depth;",
     "- left.begin_distance * h / left.image_depth;",
     "the way to the root of a window is shortened like its straight part", (LAWS,)),
    ("crossed_windows_beyond_images", WINDOW_PRUNING,
     "if(h > left.image_depth || h > right.image_depth)", "if(h > left.image_depth)",
     "crossed windows are compared beyond an image", (LAWS,)),
    ("pair_trimmed_at_start", WINDOW_PRUNING,
     "  left.end = pair.left_end;\n  left.end_distance = pair.left_end_distance;\n", "",
     "a window goes on where its right neighbor is nearer", (WINDOWS,)),
    ("pair_swallows_right", LANE_PRUNING,
     "right_is_dominated = goes_on & at_last.left_is_nearer & ends_with_right;",
     "right_is_dominated = goes_on & at_last.left_is_nearer;",
     "a window that is trimmed at its beginning is lost as a whole", (WINDOWS,)),
    ("pair_in_lanes_no_margin", LANE_PRUNING,
     "L::all(FT(1 - Tolerance<FT>::distance()))", "L::all(FT(1 + Tolerance<FT>::distance()))",
     "two windows that tie are trimmed against each other", (WINDOWS,)),
    ("pair_in_lanes_end", LANE_PRUNING,
     "left_end = L::select(ends_at_first, first,", "left_end = L::select(ends_at_first, last,",
     "a window that should end at the left end of the shared part ends at the right one", (WINDOWS,)),
    ("pair_in_lanes_begins_too_late", LANE_PRUNING,
     "L::except(goes_on & starts_with_left & at_first.left_is_nearer,", "L::except(goes_on & at_first.left_is_nearer,",
     "a window begins at the left end of the shared part though it is not inside the other one", (WINDOWS,)),
    ("close_images_trimmed", LANE_PRUNING,
     "(overlap & L::less_equal(depth, L::all(close_depth)))\n"
     "               | (overlap & L::less_equal(right.end, left.begin))",
     "(overlap & L::less_equal(right.end, left.begin))",
     "windows whose image is too near are trimmed, which turns their paths", (WINDOWS,)),
    ("dominated_right_not_suspect", LANE_PRUNING,
     "| left_is_dominated | right_is_dominated;", "| left_is_dominated | (right_is_dominated & starts_with_left);",
     "a window that is dominated as a whole is trimmed to nothing unseen", (WINDOWS,)),

    # --- windows and their order ---
    ("order_always_known", WINDOW,
     "return a.key == b.key && (a.is_marked() || b.is_marked());", "return false && a.key == b.key;",
     "pairs are pruned whose order has been lost", (WINDOWS,)),
    ("too_close_never", WINDOW,
     "return w.image_depth <= Tolerance<FT>::closeness() * length", "return w.image_depth < 0 * length",
     "windows whose image is too near are trimmed, which turns their paths", (WINDOWS,)),
    ("minimum_of_window_at_end", WINDOW_NUMBERS,
     "const Number inside = root_distance + image_depth;", "const Number inside = L::maximum(begin_distance, end_distance);",
     "the smallest distance of a new window is too large: a radius cuts it off", (WINDOWS,)),
    ("merge_before_equal_keys", WINDOW_LISTS,
     "std::upper_bound(key + old,", "std::lower_bound(key + old,",
     "windows that came later are put before those with the same key, and not marked", (WINDOWS,)),
    ("merge_unmarked", WINDOW_LISTS,
     "          to.history()[n] |= one_step;\n          list.steps |= 1;\n", "          list.steps |= 0;\n",
     "windows whose order is unknown are not marked", (WINDOWS,)),
    ("merge_not_needed", WINDOW_LISTS,
     "if(middle > 0 && !(key[middle - 1] < key[middle]))", "if(middle > 0 && key[middle - 1] == key[middle])",
     "lists are joined that are out of order", (WINDOWS,)),
    ("last_lane_left_out", LIST_LOOPS,
     "const Mask is_pair = L::first(n - 1 - i);", "const Mask is_pair = L::first(n - i);",
     "the last window of a list is trimmed by what stands behind it in memory", (LANES, ANALYTIC, FLAT)),
    ("nearest_takes_last_tie", LIST_LOOPS,
     "const Mask is_better = is_window & L::less(d, distance);",
     "const Mask is_better = is_window & L::less_equal(d, distance);",
     "of windows that tie another one is taken with more lanes", (LANES,)),

    # --- lists across faces ---
    ("straighter_path_not_taken", LIST_CROSSING,
     "while(is_to_right ? best.index + 1 < list.size", "while(is_to_right ? best.index + 1 < 0 * list.size",
     "a list is split where a bent path crosses it, and a gap opens", (LIST_CROSSINGS,)),
    ("best_window_one_side", LIST_CROSSING,
     "cross(&Window_list_loops<FT>::cross_left, list, 0, path.index + 1, c, to_left, m_left);",
     "cross(&Window_list_loops<FT>::cross_left, list, 0, path.index, c, to_left, m_left);",
     "the nearest window loses its left part", (LIST_CROSSINGS,)),
    ("split_by_unknown_order", LIST_CROSSING,
     "i == path.index || is_order_unknown(w, best)\n                           || is_too_close_to_trim(w, c.length)",
     "i == path.index || is_too_close_to_trim(w, c.length)",
     "a window loses a side though its position beside the nearest one is unknown", (LIST_CROSSINGS,)),
    ("split_against_key", LIST_CROSSING,
     "|| (i < path.index ? w.begin > s : w.end < s);", ";",
     "a window loses a side that its key does not tell it to lose", (LIST_CROSSINGS,)),
    ("separating_point_not_clamped", LIST_CROSSING,
     "best.separating_point = (std::min)((std::max)(m_abscissa[best.index], w.begin), w.end);",
     "best.separating_point = m_abscissa[best.index];",
     "a list is split beside the interval that its shortest path runs through", (LIST_CROSSINGS,)),
    ("next_suspect_off_by_one", LIST_CROSSING,
     "return (std::min)(i + trailing_zeros(rest), n);", "return (std::min)(i + 1 + trailing_zeros(rest), n);",
     "the window behind a suspect is looked at instead", (LIST_CROSSINGS,)),
    ("next_suspect_skips_words", LIST_CROSSING,
     "i = (i / suspects_in_word + 1) * suspects_in_word;", "i = (i / suspects_in_word + 2) * suspects_in_word;",
     "every second group of suspects is passed over", (LIST_CROSSINGS,)),
    ("two_removed_for_one", LIST_CROSSING,
     "        --last;\n", "        last -= last > 1 ? 2 : 1;\n",
     "with a dominated window its neighbor goes as well", (LIST_CROSSINGS,)),
    ("stale_windows_kept", LIST_CROSSING,
     "if(w.root_distance > m_distance[w.root] || w.number_of_faces_crossed()",
     "if(w.number_of_faces_crossed()",
     "windows of a pseudo-source that has been improved since are propagated", (LIST_CROSSINGS,)),
    ("runs_around_for_ever", LIST_CROSSING,
     "if(w.root_distance > m_distance[w.root] || w.number_of_faces_crossed() > m_mesh.most_faces_crossed()\n       || (Rules",
     "if(w.root_distance > m_distance[w.root] || (Rules",
     "paths around faces without area never end", (LIST_CROSSINGS,)),
    ("lengths_cross_faces_once", READER,
     "    if(!Shape::has_points)\n      mesh.bound_faces_crossed_by_lengths();\n", "",
     "paths between lengths that cross a face more than once are lost", (ANALYTIC,)),

    # --- stars, where windows start, the wavefront ---
    ("first_window_mirrored", FIRST_WINDOW,
     "w.image_x = c.length - c.apex_x;", "w.image_x = c.apex_x;",
     "the image is at the mirrored position", (ANALYTIC, FLAT)),
    ("emission_again_for_rounding", STARS,
     "      && (!may_emit || is_clearly_less(d, distance) ||", "      && (!may_emit || d < distance ||",
     "windows start once more for an improvement by rounding", (WINDOWS,)),
    ("no_sector", SECTOR,
     "m_is_in_sector[f] = 0;\n      f = star.faces[f].next;", "f = star.faces[f].next;",
     "windows start in faces that no path bends into", (EMISSION,)),
    ("list_waits_too_long", WAVEFRONT,
     "push(b.distance < a.distance ? b.vertex : a.vertex, f.outward_distance);",
     "push(b.distance < a.distance ? b.vertex : a.vertex, 2 * f.outward_distance);",
     "lists are visited too late: distances are said to be final that are not", (OPTIONS,)),
    ("bends_nowhere", WAVEFRONT,
     "      m_emission[v] |= MUST_EMIT;\n      push(v, distance);\n", "static_cast<void>(push);",
     "no path bends at a saddle", (ANALYTIC, FLAT)),
    ("unreached_vertices_left", WAVEFRONT,
     "if(reached == m_mesh.number_of_vertices() || reached == m_reached_at_last_start)", "if(reached > 0)",
     "vertices between faces thinner than rounding are not reached", (NEEDLES,)),

    # --- tolerances ---
    ("distance_tolerance_zero", TOLERANCE,
     "static FT distance() { return 4 * epsilon(); }", "static FT distance() { return 0 * epsilon(); }",
     "ties are decided by rounding", (PLANE,)),
    ("distance_tolerance_wide", TOLERANCE,
     "static FT distance() { return 4 * epsilon(); }", "static FT distance() { return 4e6 * epsilon(); }",
     "distances that differ are taken for the same", (PLANE,)),
    ("sideways_tolerance_zero", TOLERANCE,
     "static FT sideways() { return 512 * epsilon(); }", "static FT sideways() { return 0 * epsilon(); }",
     "a path that meets a vertex passes it on a side that rounding chooses", (PIECES, HOSTILE_PATHS),
     "a path that goes astray is found out by its length, and looked for without this tolerance (Path_search.h)"),
    ("angle_tolerance_zero", TOLERANCE,
     "static FT angle() { return 1024 * epsilon(); }", "static FT angle() { return 0 * epsilon(); }",
     "flat vertices are taken for saddles, by rounding", (PLANE,)),
    ("angle_tolerance_wide", TOLERANCE,
     "static FT angle() { return 1024 * epsilon(); }", "static FT angle() { return 1024e9 * epsilon(); }",
     "no path bends at a slight saddle", (PLANE,)),
    ("barycentric_tolerance_zero", TOLERANCE,
     "static FT barycentric() { return 64 * input_epsilon(); }",
     "static FT barycentric() { return 0 * input_epsilon(); }",
     "a vertex whose coordinates are rounded is a location beside it", (INVALID,)),
    ("barycentric_tolerance_wide", TOLERANCE,
     "static FT barycentric() { return 64 * input_epsilon(); }",
     "static FT barycentric() { return 64e6 * input_epsilon(); }",
     "locations near a vertex are taken for the vertex", (INVALID,)),
    ("location_tolerance_zero", TOLERANCE,
     "return sqrt(input_epsilon()) / 16;", "return 0 * sqrt(input_epsilon());",
     "locations are rejected for their rounding", (INVALID,)),
    ("location_tolerance_wide", TOLERANCE,
     "return sqrt(input_epsilon()) / 16;", "return 1e6 * sqrt(input_epsilon());",
     "locations outside their face are computed with", (INVALID,)),
    ("triangle_inequality_tolerance_zero", TOLERANCE,
     "static FT triangle_inequality() { return 64 * input_epsilon(); }",
     "static FT triangle_inequality() { return 0 * input_epsilon(); }",
     "flat faces are rejected for the rounding of their lengths", (INVALID,)),
    ("triangle_inequality_tolerance_wide", TOLERANCE,
     "static FT triangle_inequality() { return 64 * input_epsilon(); }",
     "static FT triangle_inequality() { return 64e6 * input_epsilon(); }",
     "lengths that belong to no triangle are computed with", (INVALID,)),
    ("interval_tolerance_zero", TOLERANCE,
     "static FT interval() { return 512 * epsilon(); }",
     "static FT interval() { return 0 * epsilon(); }",
     "windows that are a product of rounding are propagated", (RANDOM_DIAGRAMS,)),
    ("interval_tolerance_wide", TOLERANCE,
     "static FT interval() { return 512 * epsilon(); }",
     "static FT interval() { return 512e6 * epsilon(); }",
     "narrow windows are lost", (NEEDLES,)),
    ("lengthwise_tolerance_zero", TOLERANCE,
     "static FT lengthwise() { return 8 * epsilon(); }",
     "static FT lengthwise() { return 0 * epsilon(); }",
     "paths are taken for wrong ones for their rounding", (HOSTILE_PATHS,)),
    ("lengthwise_tolerance_wide", TOLERANCE,
     "static FT lengthwise() { return 8 * epsilon(); }",
     "static FT lengthwise() { return 8e6 * epsilon(); }",
     "paths that are too long are taken for right ones", (HOSTILE_PATHS,)),
    ("gap_tolerance_wide", TOLERANCE,
     "static FT gap() { return 8 * epsilon(); }",
     "static FT gap() { return 8e6 * epsilon(); }",
     "points of paths that are apart are one", (HOSTILE_PATHS,)),
    ("length_tolerance_zero", TOLERANCE,
     "return sqrt(epsilon()) / 1024;", "return 0 * sqrt(epsilon());",
     "faces that are lost in rounding have directions", (PLANE,)),
    ("length_tolerance_wide", TOLERANCE,
     "return sqrt(epsilon()) / 1024;", "return 1024 * sqrt(epsilon());",
     "needles are taken for faces that are lost in rounding", (PLANE,)),
    ("closeness_tolerance_zero", TOLERANCE,
     "return sqrt(epsilon()) / 16;", "return 0 * sqrt(epsilon());",
     "windows are trimmed whose image is too near to tell directions", (FUZZ,)),
    ("tie_tolerance_zero", TOLERANCE,
     "static FT tie() { return 64 * distance(); }",
     "static FT tie() { return 0 * distance(); }",
     "images that tie take turns", (RANDOM_DIAGRAMS, HOSTILE_DIAGRAMS, CROWDED)),
    ("touching_tolerance_zero", TOLERANCE,
     "static FT touching() { return 64 * closeness(); }",
     "static FT touching() { return 0 * closeness(); }",
     "where a curve touches a line, rounding decides its position", (RANDOM_DIAGRAMS,)),
    ("crossing_tolerance_zero", TOLERANCE,
     "static FT isoline() { return 4096 * epsilon(); }",
     "static FT isoline() { return 0 * epsilon(); }",
     "crossings of isolines are halved for ever", (ISOLINE_TEST,)),
    ("crossing_tolerance_wide", TOLERANCE,
     "static FT isoline() { return 4096 * epsilon(); }",
     "static FT isoline() { return 4096e6 * epsilon(); }",
     "isolines are beside their points", (ISOLINE_TEST,)),
    ("merge_distance_of_a_path_relative_to_the_mesh", PATH_THINNING,
     "m_merge_distance(Tolerance<FT>::gap() * extent)", "m_merge_distance(Tolerance<FT>::gap())",
     "all points of a path on a small component are one", (SMALL,)),
    ("small_components_accepted", BUILDER,
     "if(longest < smallest_component())", "if(longest < 0)",
     "lengths of a component that is too small underflow", (INVALID,)),
    ("farthest_instead_of_nearest_on_arcs", ARC_PIECE,
     "visit_direction({FT(m_size * b.to_other.x - b.size * m_to_right.x),",
     "visit_direction({FT(b.size * m_to_right.x - m_size * b.to_other.x),",
     "a site that is nearer between the ends of an arc is not seen", (ARC_PIECES,)),
    ("points_of_the_chord", ARC_PIECE,
     "const FT stretch = 1 - m_difference * excess * size_c / m_size;", "const FT stretch = 1 + 0 * excess;",
     "points beside the arc are compared", (ARC_PIECES,)),
    ("one_crossing_with_a_line", ARC_PIECE,
     "    visit_direction({FT(k * w.x + root * w.y), FT(k * w.y - root * w.x)}, visit);\n", "",
     "an arc that crosses a line of sight is compared on one side of it only", (ARC_PIECES,)),
    ("arcs_that_are_no_bisectors", DIAGRAM_CHECK,
     "excess = (std::max)(excess, arc.difference(x));", "excess = (std::max)(excess, 0 * arc.difference(x));",
     "a chord is taken for a bisector", (DIAGRAM_CERTIFICATION,)),
    ("stated_distances_are_not_read", SITE_WITNESS,
     "values[v] = own_distance(CGAL::to_double(m_diagram.distance_to_nearest_site(u)));",
     "values[v] = m_field.distance[v];",
     "the certificate of distances looks at its own distances", (DIAGRAM_CERTIFICATION,)),
    ("sites_that_tie_may_own", DIAGRAM_CHECK,
     "owns_something[i] = 1;", "owns_something[i] = 0;",
     "the second of two equal sites may have the cell", (DIAGRAM_CERTIFICATION,)),
    ("sites_are_no_samples", DIAGRAM_SAMPLES,
     "      else if(m_diagram.site(i).first != Graph_traits::null_face())\n",
     "      else if(false)\n",
     "a site whose cell has been overlooked is not looked at", (DIAGRAM_CERTIFICATION,)),
    ("missing_arcs", DIAGRAM_CERTIFICATE,
     "record(DIAGRAM_BOUNDARIES, n == 1 ? 0 : infinity(), no_site());", "record(DIAGRAM_BOUNDARIES, n < 0 ? 1 : 0, no_site());",
     "an arc may be missing", (DIAGRAM_CERTIFICATION,)),
    ("diagram_violations_relative_to_the_mesh", DIAGRAM_CERTIFICATE,
     "{ return m_components.component(get(m_vertex_index_map, v)); }",
     "{ return 0 * m_components.component(get(m_vertex_index_map, v)); }",
     "what is wrong on a small component is not seen beside a large one", (DIAGRAM_CERTIFICATION,)),
    ("depth_zero", TOLERANCE,
     "    return e * e;\n", "    return 0 * e;\n",
     "an image that lies on its edge has no depth", (FUZZ,)),
    ("area_of_needles", GEOMETRY,
     "* ((a - (x - y)) / x) * ((a + (x - y)) / x) *", "* (((a + y) - x) / x) * (((a + x) - y) / x) *",
     "the area of needles is lost in rounding", (PLANE,)),
    ("apex_mirrored", GEOMETRY,
     "t.apex_x = (a + (c - b) * (c + b) / a) / 2;", "t.apex_x = (a + (b - c) * (c + b) / a) / 2;",
     "triangles are laid out as their mirror images", (PLANE,)),
    ("three_half_turns_are_full", ANGLE_SUM,
     "return s <= width * c && (turns == 0 || cosine > 0);", "return s <= width * c;",
     "a vertex with three half turns around it is taken for a flat one", (PLANE,)),

    # --- the mesh, sources ---
    ("split_edge_other_side", SOURCES,
     "= split_side(o, wb, wa, length, v, kept);", "= split_side(o, wa, wb, length, v, kept);",
     "a source on an edge is at the mirrored location in the face on the other side", (ANALYTIC, FLAT)),
    ("split_not_undone", SOURCES,
     "    for(; !m_renamed.empty(); m_renamed.pop_back())\n"
     "      rename(m_renamed.back().vertices, m_renamed.back().to, m_renamed.back().from);\n",
     "    m_renamed.clear();\n",
     "after a source in a face the mesh is not what it was", (SOLVER, PATHS)),

    ("components_not_joined_at_vertices", BUILDER,
     "sets.union_set(std::size_t(component_of_vertex[v]), c);", "continue;",
     "what is reached through a vertex of two components is not read", (REACHED,)),
    ("neighbors_of_kept_components_not_moved", BUILDER,
     "neighbor = neighbor == null_id ? null_id : neighbor - shift;", "neighbor = neighbor == null_id ? null_id : neighbor;",
     "behind a component that is left out, neighbors are other faces", (REACHED,)),

    ("last_face_of_block_not_seen", INTRINSIC_MESH,
     "face_of(*extremes.second) + 1}", "face_of(*extremes.second)}",
     "threads that share vertices miss angles", (BLOCKS,)),
    ("last_fault_is_thrown", BLOCK_TEAM,
     "for(const std::exception_ptr& fault : faults)", "for(const std::exception_ptr fault : {faults.back()})",
     "the fault that is reported depends on the number of threads", (BLOCKS,)),

    # --- parallel propagation, sampling ---
    ("neighbors_at_the_same_time", PARALLEL,
     "    if(!is_nearest_of_links(worker.star))\n", "    if(!is_nearest_of_links(worker.star) && worker.messages.empty())\n",
     "stars that share faces are worked on at the same time", (PARALLEL_TEST,)),
    ("deferred_vertices_lost", PARALLEL,
     "      push(q.vertex, q.key, part, worker);\n      return;", "      return;",
     "vertices next to one that is visited are never visited", (PARALLEL_TEST,)),
    ("parallel_end_too_early", PART,
     "m_nearest_key = !m_batch.empty() ? m_batch.front().key\n                  : m_queue.empty() ",
     "m_nearest_key = m_queue.empty() ",
     "a run to targets ends before the nearest vertices are visited", (PARALLEL_TEST,)),
    ("messages_in_any_order", PART,
     "if(best == nullptr || i.wins(*best))", "if(best == nullptr)",
     "of several improvements of a vertex the first message counts", (PARALLEL_TEST,)),
    ("batch_lost_at_the_end", DIVISION,
     "        push(q.vertex, q.key);\n      part.batch().clear();", "        static_cast<void>(q);\n      part.batch().clear();",
     "a run that ends early loses the vertices of its last batch", (WORK_SHARING,)),
    ("moved_vertices_keep_their_part", DIVISION,
     "      m_records.set_part(q->vertex, to);\n", "      static_cast<void>(q->vertex);\n",
     "vertices that another part visits go back to their first part", (WORK_SHARING,)),
    ("two_part_of_vertex", VERTEX_RECORDS,
     "    return entry & part_mask; // another thread was faster", "    return part;",
     "two parts queue the same vertex", (WORK_SHARING,)),
    ("tail_unit_claimed_twice", SHARING,
     "is_first ? t + 1 : t - one_from_end", "t + 1",
     "a thread that helps does the last unit while the first one is claimed", (WORK_SHARING,)),
    ("last_windows_not_relayed", RELAY,
     "    begin_batch(0, keepers);\n    take_over(reached);\n", "    static_cast<void>(reached), static_cast<void>(keepers);\n",
     "the windows of the last batch of a run are not kept", (PARALLEL_KEEPERS,)),
    ("relay_in_the_order_of_threads", RELAY,
     "    for(const Span& span : m_last_spans)\n      m_keeper.take_over(m_last_logs[span.thread], span.first, span.last, reached);\n",
     "    for(const Log& log : m_last_logs)\n      m_keeper.take_over(log, {}, log.position(), reached);\n",
     "windows are kept in an order that depends on the threads", (PARALLEL_KEEPERS,)),
    ("threads_divide_lists", WINDOW_FIELD,
     "    keeper.m_divides_lists = false;\n", "",
     "where a list is divided depends on the windows that a thread has kept before", (PARALLEL_KEEPERS,)),
    ("copies_of_keepers_share_memory", WINDOW_FIELD,
     "  Window_keeper(const Window_keeper& other) : m_field(other.m_field), m_divides_lists(other.m_divides_lists) {}\n",
     "  Window_keeper(const Window_keeper&) = default;\n",
     "a thread overwrites the windows that another one has kept", (PARALLEL_KEEPERS,)),
    ("farthest_not_up_to_date", FARTHEST,
     "if(!(distance < top.first))", "if(distance > 0 || !(distance < top.first))",
     "a vertex is taken for the farthest by a distance that it had before", (SAMPLING,)),

    # --- paths, points, isolines ---
    ("piece_to_the_wrong_side", STRAIGHT,
     "(c.apex_x - s.abscissa) * s.image_y - c.apex_y * (s.image_x - s.abscissa) > 0);",
     "(c.apex_x - s.abscissa) * s.image_y - c.apex_y * (s.image_x - s.abscissa) < 0);",
     "a straight piece turns to the wrong edge", (PIECES,)),
    ("image_turned_the_other_way", UNFOLDING,
     "{x * angle.cosine - depth * angle.sine,", "{x * angle.cosine + depth * angle.sine,",
     "an image is unfolded to the wrong side", (PIECES,)),
    ("first_query_keeps_no_windows", LAZY_PATHS,
     "m_solver.run(wanted == Stage::EVERYWHERE, go_on)", "m_solver.run(false, go_on)",
     "the first query at a point of a face finds no windows", (PATHS_BUILDING,)),
    ("removed_source_not_noticed", LAZY_PATHS,
     "    if(m_sources.remove(it))\n      set_changed();", "    m_sources.remove(it);",
     "queries answer with a source that has been removed", (PATHS_BUILDING,)),
    ("sides_of_isolines_by_rounding", ISOLINES,
     "return value * (1 - Tolerance<FT>::isoline_value());", "return value;",
     "an edge along a line has points on both sides of it", (SIGNED_ISOLINES,)),
    ("isoline_touching_edge", ISOLINES,
     "return nearest < value && value <= farthest;", "return false && nearest < farthest;",
     "lines that cross an edge twice are not found there", (ISOLINE_TEST,)),
    ("windows_of_isolines_dropped", ISOLINE_SWEEP,
     "*level <= nearest + longest + longest / 2 + margin;", "*level <= nearest;",
     "windows that lead to a line are not kept", (ISOLINES_TEST,)),
    ("windows_of_isolines_released_too_early", ISOLINE_SWEEP,
     "    if(!has_lines)\n      release(f);\n", "    release(f);\n    m_faces[f].state = PASSED;\n    if(!has_lines)\n      return;\n",
     "a face with many crossings has no windows when they are connected", (ISOLINES_TEST,)),
    ("strips_of_isolines_taken_for_windows", FACE_DISTANCES,
     "m_candidates.push_back(Candidate{interval, s.distance, k, STRIP});",
     "m_candidates.push_back(Candidate{interval, s.distance, k, WINDOW});",
     "the direction of rays is taken for the image of a source", (CURVE_ISOLINES,)),
    ("strips_of_isolines_start_no_face", ISOLINE_SWEEP,
     "    m_strips.keep(h, s);\n    activate(f, nearest);\n",
     "    if(m_faces[f].state == ACTIVE)\n      m_strips.keep(h, s);\n",
     "strips that enter a face before any window are lost", (CURVE_ISOLINES,)),
    ("edges_nearer_by_two_paths", FACE_DISTANCES,
     "if(are_nearer && farther < value)",
     "if(are_nearer && (std::min)(distance_by(c, first[c.side]), distance_by(c, last[c.side])) < value)",
     "an edge whose ends are nearer is not looked at, although it is farther between them", (CROSSINGS,)),
    ("convex_functions_taken_for_concave", FACE_DISTANCES,
     "if((std::min)(in_middle, FT(2 * in_middle - farther)) < value)", "if((std::min)(in_middle, farther) < value)",
     "lines that come near an edge between its ends and its middle are not found", (CROSSINGS,)),
    ("no_bounds_of_convex_functions", FACE_DISTANCES,
     "    return are_nearer;\n", "    return true;\n",
     "edges along a line are halved to the end", (CROSSINGS,)),
    ("strips_not_released", STRIP_FIELD,
     "      m_first_free = i;\n", "",
     "the places of strips that have been released are not used again", (KEPT_WINDOWS,)),
    ("released_strips_stay_in_their_chain", STRIP_FIELD,
     "std::uint32_t i = std::exchange(m_last[dense_index(h)], null_id);", "std::uint32_t i = m_last[dense_index(h)];",
     "an edge has the strips of another one", (KEPT_WINDOWS,)),

    # --- Voronoi diagrams ---
    ("chunk_of_windows_lost", FACE_WINDOWS,
     "std::swap(m_links[c].next, m_links[last].next);", "",
     "of many windows of an edge only the last ones are remembered", (KEPT_WINDOWS,)),
    ("chunks_not_released", FACE_WINDOWS,
     "    std::swap(m_links[last].next, m_first_free);\n", "",
     "the memory of windows that have been released is not used again", (KEPT_WINDOWS,)),
    ("bound_rounded_down", SINGLE_PRECISION,
     "static_cast<double>(x) * (1 + rounding)", "static_cast<double>(x) * (1 - rounding)",
     "a face is said to be done before the wavefront has passed it", (BOUNDS,)),
    ("waiting_bucket_not_opened", RADIX_HEAP,
     "for(std::size_t i = 0; i <= last; ++i)", "for(std::size_t i = 0; i < last; ++i)",
     "faces that are done wait on", (BOUNDS,)),
    ("face_done_too_early", PASSED,
     "FT(nearest + longest / 2), FT(nearest + longest)", "FT(nearest + longest / 2), FT(nearest + longest / 2)",
     "windows that come to a face after the first ones are left out", (BY_HAND, RANDOM_DIAGRAMS, CUT)),
    ("one_corner_is_enough", REMOVAL,
     "owner(corner[1]) == source && owner(corner[2]) == source\n", "owner(corner[1]) == source\n",
     "a face is said to be in one cell by two of its corners", (BY_HAND, CUT)),
    ("last_windows_tell_the_source", REMOVAL,
     "record.source = record.source == null_id || record.source == source ? source : several_sources;",
     "record.source = source;",
     "a face is said to be in one cell by the windows that have entered last", (BY_HAND, CUT, RANDOM_DIAGRAMS)),
    ("source_known_for_ever", OWNERS,
     "return m_source[v].distance == m_field->distance[v];", "return m_source[v].vertex != null_id;",
     "a pseudo-source that is reached from another source later still belongs to the first one",
     (RANDOM_DIAGRAMS, HOSTILE_DIAGRAMS)),
    ("faces_of_a_batch_handed_over_again", REMOVAL,
     "      finish_face(f);\n    m_closed_faces.clear();\n", "      finish_face(f);\n",
     "a face that is divided is handed over once more with each later batch", (RANDOM_DIAGRAMS, BY_HAND)),
    ("edges_of_a_batch_forgotten", REMOVAL,
     "      close_edge(e.first, e.second);\n    m_due_edges.clear();\n",
     "      if(e.second != null_id)\n        close_edge(e.first, e.second);\n    m_due_edges.clear();\n",
     "faces at the border of the mesh are never handed over", (RANDOM_DIAGRAMS, HOSTILE_DIAGRAMS)),
    ("gaps_before_intervals_stay", EDGE_PARTITION,
     "    else if(bridge_gap(next, x))\n      return false;\n", "",
     "a farther site keeps an edge up to the interval of a nearer one, although paths bend there",
     (FACE_LAWS,)),
    ("gaps_between_windows_not_bounded", ENTERING,
     "      bound = (std::max)(bound, bound_between(at_x, at_begin, FT(begin - x)));\n", "      bound = bound;\n",
     "a face is said to be done though there are larger distances between its windows",
     (RANDOM_DIAGRAMS, CUT, HOSTILE_DIAGRAMS)),
    ("end_of_edge_not_bounded", ENTERING,
     "  if(x < length)\n    bound =", "  if(x > length)\n    bound =",
     "a face is said to be done though there are larger distances behind its last window",
     (RANDOM_DIAGRAMS, CUT, HOSTILE_DIAGRAMS)),
    ("edge_bounded_by_its_ends", ENTERING,
     "return FT((at_first + at_last + length) / 2);", "return (std::max)(at_first, at_last);",
     "a face is said to be done when its corners are", (RANDOM_DIAGRAMS, CUT, HOSTILE_DIAGRAMS)),
    ("equal_sources_of_the_whole_mesh", EQUAL_SOURCES,
     "             <= Tolerance<FT>::equal_sources() * mesh.extent_around(face_of(e));\n",
     "             <= Tolerance<FT>::equal_sources();\n",
     "sites of a small component are one site if the rounding of the largest component is larger", (SMALL,)),
    ("superfluous_source_keeps_its_cell", EQUAL_SOURCES,
     "else if(is_superfluous(e, it->second, own_offset))", "else if(is_superfluous(e, own_offset, it->second))",
     "of two sites that tie, one of which is nowhere nearer, the later one never gets the cell", (NEAR_SITES,)),
    ("far_points_by_direction_only", BISECTOR,
     "if(!(smallest > Tolerance<FT>::interval() * radius))", "if(smallest >= 0)",
     "arcs between sites that are very near to each other end somewhere else", (NEAR_SITES,)),
    ("tiny_cells_in_the_layout", MEASURES,
     "(std::max)(area < Tolerance<double>::tiny_area() ? it->second.local_area : area, 0.)", "(std::max)(area, 0.)",
     "areas of tiny cells have no digits", (NEAR_SITES,)),
    ("cell_without_origin", MEASURES,
     "s.moment[k] += moment[k] + p.local.area * (origin[k] - s.origin[k]);", "s.moment[k] += moment[k];",
     "centroids forget where the parts of a cell are", (NEAR_SITES, BY_HAND)),
    ("image_never_returns", FRONT_EVENT,
     "if(is_taken_over_between(from, to, left, g, c))",
     "if((from > 0 || !has_been_left) && is_taken_over_between(from, to, left, g, c))",
     "an image that rounding has left at a point stays away, although it is nearer farther on", (CROWDED,)),
    ("extent_of_divided_face_unknown", INTRINSIC_MESH,
     "if(f >= number_built)", "if(f >= m_faces.size())",
     "a part of a divided face is taken for a face of the last component", (SMALL,)),
    ("curve_drawn_on_to_its_end", FACE_PARTITION,
     "    if(completion().is_taken_over_before(f, p))\n      completion().lead_back(f, p);\n", "",
     "a curve that ends near its end goes on with paths that are not the shortest ones", (RANDOM_DIAGRAMS,)),
    ("bisector_turned", BISECTOR,
     "    if(m_tx * ny - m_ty * nx < 0)\n", "    if(m_tx * ny - m_ty * nx > 0)\n",
     "curves run backward", (CUT,)),
    ("nearer_without_margin", TOLERANCE,
     "static FT nearer() { return 4 * distance(); }", "static FT nearer() { return 0 * distance(); }",
     "of two images that tie, one is nearer by rounding", (FACE_LAWS,)),
    ("nearer_with_wide_margin", TOLERANCE,
     "static FT nearer() { return 4 * distance(); }", "static FT nearer() { return 4e6 * distance(); }",
     "an image that is nearer does not take over", (FACE_LAWS,)),
    ("image_above_one_end_of_a_chord", EDGE_PARTITION,
     "(g.weight + n - rise) * margin > chord(first) && ", "(g.weight + n - rise) * margin > chord(first) || ",
     "an image that is farther at one end of a part of an edge never takes over in it", (BY_HAND, PLANAR)),
    ("last_divided_faces_lost", DIAGRAM_KEEPER,
     "for(int i = 0; i < 2; ++i) // those in work", "for(int i = 0; i < 1; ++i) // those in work",
     "the faces that are handed over last do not join the complex", (PARALLEL_KEEPERS,)),
    ("divided_faces_join_late", DIAGRAM_KEEPER,
     "    add_divided();\n    std::swap(m_divided, m_in_work);", "    std::swap(m_divided, m_in_work);",
     "faces that have been divided are dropped or join the complex out of order", (PARALLEL_KEEPERS,)),
    ("edge_divided_at_first_root_only", EDGE_PARTITION,
     "result{root[0], root[1], last, last, last};", "result{root[0], last, last, last, last};",
     "an image that is nearer between two roots is missed", (FACE_LAWS,)),
    ("apex_height_not_scaled", INTRINSIC_FACE,
     "c.apex_y = f.apex_y * ratio;", "c.apex_y = f.apex_y;",
     "the apex is too high above the longer sides of a face", (FACE_LAWS,)),
    ("layout_from_squares_of_sides", FACE_SHAPE,
     "f.apex_x = -dot(base, from_apex) / f.length[0];",
     "f.apex_x = (f.length[0] * f.length[0] + f.length[2] * f.length[2] - f.length[1] * f.length[1]) / "
     "(2 * f.length[0]);",
     "needles that are given by points lose digits", (FACE_LAWS,)),
    ("edge_takes_over_by_rounding", BISECTOR,
     "return a < b * (1 - Tolerance<FT>::nearer());", "return a <= b;",
     "on an edge two sources that tie take turns", (SYMMETRIC, BY_HAND, RANDOM_DIAGRAMS)),
    ("nodes_on_edge_not_reversed", COMPLEX,
     "result.is_reversed = !m_mesh->is_first_of_edge(h);\n    const Index_range* const nodes = m_edge_nodes",
     "result.is_reversed = false;\n    const Index_range* const nodes = m_edge_nodes",
     "the two faces of an edge see its points in the same order", (BY_HAND, CUT)),
    ("locator_wrong_side", LOCATOR,
     "return u.x * (m_p.y - x.y) - u.y * (m_p.x - x.x) > 0 ? a.left_site : a.right_site;",
     "return u.x * (m_p.y - x.y) - u.y * (m_p.x - x.x) < 0 ? a.left_site : a.right_site;",
     "points are located in the cell on the other side of a curve", (SYMMETRIC,)),
    ("area_on_both_sides", MEASURES,
     "const double factor = is_left ? 1 : -1;", "const double factor = 1;",
     "what one cell gains at a curve the other one does not lose", (BY_HAND, PLANAR)),
    ("cut_too_coarse", FACE_CUT,
     "if(best == i || (!is_forced && largest <= tolerance))",
     "if(best == i || (!is_forced && largest <= 64 * tolerance))",
     "cut meshes are farther from the arcs than is asked for", (CUT,)),

    # --- matrices ---
    ("matrix_asks_between_rows_only", MATRIX,
     "return !stop.load(std::memory_order_relaxed) && wants_more(output);",
     "return !stop.load(std::memory_order_relaxed);",
     "rows that have begun do not end", (MATRICES,)),
    ("matrix_passes_ended_rows_on", MATRIX,
     "  if(!wants_more(output))\n    return false;\n", "",
     "a row that has ended early is passed on without distances", (MATRICES,)),

    ("star_without_extent", TARGET_REGION,
     "static_cast<float>(key) - at.back();", "static_cast<float>(key);",
     "visits are skipped from whose stars a path leads to a target", (MATRICES,)),
    ("bounds_of_last_target", TARGET_REGION,
     "sum[l] = (std::max)(sum[l], s + margin);", "sum[l] = s + margin;",
     "the bounds hold for one target of a group only", (MATRICES,)),
    ("bounds_never_renewed", TARGET_REGION,
     "m_is_useful = m_skipped > 0;", "m_is_useful = false;",
     "rows are pruned at their beginning only", (MATRICES,)),
    ("peeled_from_the_near_end", PEELING,
     "keys.emplace_back(-distance(sources[i]), i);", "keys.emplace_back(distance(sources[i]), i);",
     "the vertices that are left lie around the sources", (MATRICES,)),

    # --- remeshing ---
    ("tips_not_treated_apart", SAMPLE_PLACEMENT,
     "m_far_vertex[i].distance == 0 && is_tip(", "m_far_vertex[i].distance == 0 && !is_tip(",
     "samples approach a tip without an end", (REMESHING_TEST,)),
    ("holes_not_first", SAMPLE_PLACEMENT,
     "if(m_far_border_vertex[i].distance > 0)", "if(m_far_border_vertex[i].distance < 0)",
     "samples approach a hole in a cell instead of surrounding it", (REMESHING_TEST,)),
    ("border_samples_move", REMESHING,
     "return bool(CGAL::is_border(v, m_mesh));", "return bool(v == Vertex());",
     "the new mesh shrinks away from the border", (REMESHING_TEST,)),
    ("meshes_of_samples_are_remeshed", REMESHING,
     "if(m_number_of_samples[c] >= m_input.components()[c].number_of_vertices)",
     "if(m_number_of_samples[c] > m_input.components()[c].number_of_vertices)",
     "a mesh without vertices to leave out loses its shape", (REMESHING_TEST,)),
    ("double_edges_in_a_soup", REMESHING,
     "if(Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(faces))", "if(!faces.empty())",
     "edges with the same ends are taken for one", (REMESHING_TEST,)),
    ("pinched_vertices_stay", REMESHING_INPUT,
     "m_number_of_splits = Polygon_mesh_processing::duplicate_non_manifold_vertices(\n"
     "      m_mesh, parameters::output_iterator(std::back_inserter(split)));",
     "m_number_of_splits = 0;",
     "cells around a pinched vertex are never disks", (REMESHING_TEST,)),

    # --- certification ---
    ("certificate_ignores_edges", CHECKS,
     "        check_way(m_mesh.source(h), m_mesh.target(h), m_mesh.length(h), limit, worst);\n"
     "        check_way(m_mesh.target(h), m_mesh.source(h), m_mesh.length(h), limit, worst);\n",
     "        static_cast<void>(limit);\n",
     "values that are too large beyond an edge are certified", (CERTIFICATION,)),
    ("certificate_ignores_short_paths", CHECKS,
     "record(length < m_values[v] ? FT(m_values[v] - length) : FT(length - m_values[v]), length, v, worst);",
     "record(FT(m_values[v] - length), length, v, worst);",
     "values that no path attains are certified", (CERTIFICATION,)),
    ("certificate_forgives_small_components", VIOLATION,
     "if(excess <= Tolerance<FT>::gap() * extent)", "if(excess <= Tolerance<FT>::gap())",
     "what is nothing beside the largest component is nothing for all", (CERTIFICATION,)),
    ("lower_bound_one_side", LOWER_BOUND,
     "      check_pieces(right_side_line(c), {c.target, c.apex});\n", "",
     "a bound that is too large on right sides is believed", (CERTIFICATE_CHECKS, CERTIFICATION)),
    ("chunk_after_the_end", CHUNKS,
     "c < number_of_chunks(n) && !is_ended", "c < number_of_chunks(n)",
     "threads go on after an exception in another one", (PARALLEL_APPLICATIONS,)),
    ("visitor_in_any_thread", CHUNKS,
     "if(worker == 0 && ", "if(",
     "a visitor is called by threads that are not its own", (PARALLEL_APPLICATIONS,)),
    ("last_part_wins", VIOLATION,
     "if(!(other.size > size))", "if(!(other.size >= size))",
     "the vertex of a violation depends on how the check is divided", (CERTIFICATE_CHECKS, PARALLEL_APPLICATIONS)),
    ("function_extrema_of_rays", EDGE_FUNCTION,
     "FT(other.x + other.depth * (rays.x / rays.depth))", "FT(other.x - other.depth * (rays.x / rays.depth))",
     "rays and distances along an edge are compared at the wrong abscissa",
     (CERTIFICATE_OF_STRIPS, CERTIFICATION_OF_CURVES)),
    ("rays_backward", EDGE_FUNCTION,
     "return {length - end, length - begin, -x, depth, offset + x * length, true};",
     "return {length - end, length - begin, x, depth, offset, true};",
     "seen from the other face of an edge, rays come from the wrong side", (CERTIFICATE_OF_STRIPS,)),
    ("direction_taken_for_granted", LOWER_FUNCTION,
     "s.direction_x / size, FT(abs(s.direction_y)) / size, s.distance, true};",
     "s.direction_x, s.direction_y, s.distance, true};",
     "the proof believes a strip whose direction has another length than 1", (CERTIFICATE_OF_STRIPS,)),
    ("rays_through_sides", LOWER_FUNCTION,
     "rays.offset - (direction.x * side.origin.x + direction.y * side.origin.y), true},",
     "rays.offset, true},",
     "the function has wrong values behind the sides of a face", (CERTIFICATE_OF_STRIPS, CERTIFICATION_OF_CURVES)),
    ("rays_on_wrong_side", LOWER_BOUND,
     "return q.x * (c.y - b.y) - q.depth * (c.x - b.x);", "return q.depth * (c.x - b.x) - q.x * (c.y - b.y);",
     "points beside a strip are compared with its rays", (CERTIFICATE_OF_STRIPS, CERTIFICATION_OF_CURVES)),
    ("bound_inside_of_curves", LOWER_BOUND,
     "worst.record(p.at(t) - offset, p.at(t), extents[v], v);",
     "worst.record(FT(0), p.at(t), extents[v], v);",
     "a bound that is too large inside of the edges of curves is believed", (CERTIFICATE_OF_STRIPS,)),
    ("paths_end_on_any_edge", CHECKS,
     "return it == m_offset_on_edge.end() ? infinity() : it->second;",
     "return it == m_offset_on_edge.end() ? FT(0) : it->second;",
     "a path that ends on an edge without a curve counts", (CERTIFICATE_CHECKS,)),
    ("reverse_to_corners_only", DISTANCE_CERTIFICATE,
     "FT(function.least_value(h, on_edge) + offset)", "FT(to_edges + function.least_value(h, on_edge) + offset)",
     "in reverse, the nearest point of a curve is a corner", (CERTIFICATION_OF_CURVES,)),
    ("parabola_from_the_wrong_side", ARC_PIECE,
     "return {FT(1), {FT(-q.x), FT(-q.y)},", "return {FT(1), {q.x, q.y},",
     "arcs between a point and a segment are compared in the wrong places", (ARC_PIECES,)),
    ("rays_into_face_by_image", FACE_PATHS,
     "return x - y * (m_piece.x / m_piece.depth);", "return x + y * (m_piece.x / m_piece.depth);",
     "points of a face are on the wrong rays", (CERTIFICATION_OF_CURVE_DIAGRAMS,)),
    ("curves_are_no_samples", DIAGRAM_CHECK,
     "    { m_samples.add_point_of_curve(site, segment, t); });\n",
     "    { static_cast<void>(site), static_cast<void>(segment), static_cast<void>(t); });\n",
     "a curve whose cell has been overlooked is not looked at", (CERTIFICATION_OF_CURVE_DIAGRAMS,)),
    ("strips_no_paths_into_faces", FACE_PATHS,
     "      { add(Family(piece_of_strip(s), frame, m_size), k, site_of_strip(s)); });",
     "      { static_cast<void>(site_of_strip(s)); });",
     "paths from inside of segments are not known", (CERTIFICATION_OF_CURVE_DIAGRAMS,)),
    ("corner_in_front_of_flat_face", NORMALS,
     "if(c.apex_y <= Tolerance<FT>::closeness() * c.length && c.apex_x > 0 && c.apex_rest > 0)", "if(false)",
     "a corner of a curve that lies on an edge emits nothing across it", (HOSTILE_CURVES,)),
    ("function_extrema", EDGE_FUNCTION,
     "const FT t = (x * other_depth - other_x * depth) / (other_depth - depth);",
     "const FT t = (x * other_depth + other_x * depth) / (other_depth + depth);",
     "distances along an edge are compared at the wrong abscissas", (CERTIFICATE_CHECKS, CERTIFICATION)),

    # --- directions and obstacles ---
    ("walk_turns_wrong_at_edge", WALK,
     "const double x = -(m_d.x * side.x + m_d.y * side.y), y = m_d.x * side.y - m_d.y * side.x;",
     "const double x = m_d.x * side.x + m_d.y * side.y, y = m_d.x * side.y - m_d.y * side.x;",
     "a geodesic is reflected at each edge", (TRACE,)),
    ("walk_uneven_at_vertex", WALK,
     "leave_vertex(fan, reduced_angle(back + fan.total_angle() / 2, fan.total_angle()));",
     "leave_vertex(fan, reduced_angle(back + half_turn, fan.total_angle()));",
     "behind a vertex, only one side has half of the angle", (TRACE,)),
    ("direction_not_scaled", FAN,
     "return m_is_closed ? reduced_angle(angle / m_total_angle * full_turn, full_turn) : angle;",
     "return angle;",
     "directions at a vertex do not end at a full turn", (LOGARITHM, TRACE)),
    ("departure_mirrored", DEPARTURE,
     "return (std::min)((std::max)(FT(atan2(last.y, last.x)), FT(0)), corner);",
     "return corner - (std::min)((std::max)(FT(atan2(last.y, last.x)), FT(0)), corner);",
     "the angle in the first face counts from its other side", (LOGARITHM,)),
    ("sectors_joined_at_cones", RAY_SECTORS,
     " && sum.is_full() ? 1 : 0;", " ? 1 : 0;",
     "rays on both sides of a cone count as neighbors", (DIRECTIONS,),
     "their images differ beyond rounding, and sectors with different images are not joined"),
    ("sectors_of_other_images", RAY_SECTORS,
     "\n         && has_image(s, c, root))", ")",
     "a path takes the direction of another one that crosses the same edge", (DIRECTIONS,)),
    ("sectors_turn_backward", RAY_SECTORS,
     "FT(s.cosine * side.cosine + s.sine * side.sine),", "FT(s.cosine * side.cosine - s.sine * side.sine),",
     "the frame of an edge is turned the wrong way", (DIRECTIONS,)),
    ("sectors_beyond_what_is_seen", RAY_SECTORS,
     "FT low = shadow(here, side, s.low), high = shadow(here, side, s.high);",
     "FT low = 0, high = m_mesh.length(here.halfedge);",
     "a sector has the whole edge, although a cone hides a part of it", (DIRECTIONS,)),
    ("directions_of_bends_by_vertex", PATH_DIRECTIONS,
     "d = direction[end[q.vertex]];", "d = direction[q.vertex];",
     "vertices behind a bend have no direction", (DIRECTIONS,)),
    ("side_of_part_by_first_corner", DEPARTURE,
     "const FT s = (-vj - vi) / area, t = (ui + uj) / area;",
     "const FT s = (vj - vi) / area, t = (ui + uj) / area;",
     "directions at sources in faces count from a line that is no side", (LOGARITHM,)),
    ("walls_divide_no_vertex", WALL_CUT,
     "if(number_of_sectors > number_of_umbrellas)", "if(number_of_sectors > number_of_umbrellas + 1)",
     "paths pass through a vertex inside of a wall", (WALLS,)),
    ("source_at_wall_on_one_side", SOURCES_AT_WALLS,
     "if(behind.first == null_id)\n      continue;", "if(behind.first != null_id || true)\n      continue;",
     "a source on the edge of a wall reaches only the side of its face", (WALLS,)),
    ("first_copy_counts", VERTEX_COPIES,
     "if(distance(c) < distance(result))", "if(distance(result) < distance(result))",
     "a vertex of a wall has the distance of one of its sides", (WALLS,)),
    ("row_from_one_side_of_a_wall", MATRIX,
     "for(; it != m_behind_walls.end() && it->first == i; ++it)",
     "for(; it != m_behind_walls.end() && it->first == i && false; ++it)",
     "a row of a matrix knows one side of its source", (WALLS_OF_MATRICES,)),
    ("landmarks_between_walls", MATRIX,
     "if(number_of_rows() < least_sources || !m_copies.empty())", "if(number_of_rows() < least_sources)",
     "rows are pruned by a triangle inequality that does not hold", (WALLS_OF_MATRICES,)),
    ("stored_walls_from_one_face", STORE_INPUT,
     "    for(std::size_t k = 0; k < name[1]; ++k)\n      h = next(h, tm);\n    edges.push_back(edge(h, tm));",
     "    edges.push_back(edge(h, tm));",
     "a check takes the first edge of each face for the wall", (WALLS_OF_MATRICES,)),
    ("triangles_over_divided_vertices", STORE_CHECK,
     "|| there == unknown || is_divided[b] != 0)", "|| there == unknown)",
     "right rows seem to violate the triangle inequality", (WALLS_OF_MATRICES,)),
    ("sample_by_one_side_of_a_wall", SAMPLES,
     "return distance_of(m_surface.copies().nearest(v, distance_of));", "return distance_of(v);",
     "a vertex on a wall is taken for far, though its other side is near", (WALLS_OF_FUNCTIONS,)),
    ("certificate_without_proposal", DISTANCE_CERTIFICATE,
     "        values[v] = distance(v) <= limit ? distance(v) : Field::infinity();\n", "        continue;\n",
     "right distances at walls are not certified", (WALLS_OF_FUNCTIONS,)),
    ("certificate_believes_the_proposal", DISTANCE_CERTIFICATE,
     "m_surface.nearest_copy(m_surface.descriptor(v), distance) != v)", "true)",
     "wrong distances at walls are certified", (WALLS_OF_FUNCTIONS,)),
    ("curve_joined_across_a_wall", CURVES_AT_WALLS,
     "    return m_location_behind_wall(a.face, a.to).first == null_id;", "    return true;",
     "a curve leads on across a wall, where its end is no vertex of the next face", (WALLS_AND_CURVES,)),
    ("curve_on_one_side_of_a_wall", CURVES_AT_WALLS,
     "      if(!is_behind_wall(s, other))\n", "      if(!is_behind_wall(s, other) || true)\n",
     "a curve along a wall reaches one side of it", (WALLS_AND_CURVES,)),
    ("points_of_curves_on_one_side", CURVES_AT_WALLS,
     "        if(c == v || h == null_id)\n", "        if(c == v || h == null_id || true)\n",
     "a curve that touches a wall in a vertex is on one side only", (WALLS_AND_CURVES,)),
    ("sign_of_the_first_copy", DISTANCE_FUNCTIONS,
     "is_negative[solver.nearest_copy(v)] != 0;", "is_negative[solver.surface().id(v)] != 0;",
     "a vertex on a wall has the sign of another side than its distance", (WALLS_AND_CURVES,)),
    ("cell_for_each_side_of_a_wall", DIAGRAM_RUN,
     "const bool is_any_at_wall = !solver.sources().behind_walls.empty();", "const bool is_any_at_wall = false;",
     "the parts of a cell on both sides of a wall are two cells", (WALLS_OF_DIAGRAMS,)),
    ("ties_at_walls", DIAGRAM_RUN,
     "{ result[v] = static_cast<Vertex_id>(solver.source_at(u)); });", "{ static_cast<void>(v + u); });",
     "beside a wall, rounding decides anew for each edge between sites that tie", (WALLS_OF_DIAGRAMS,)),
    ("cell_of_one_side_of_a_wall", LAZY_DIAGRAM,
     "{ is_same = is_same && cell_at(other) == cell; });", "{ static_cast<void>(other); });",
     "a point of a wall is in the cell of the side of its face", (WALLS_OF_DIAGRAMS,)),
    ("distance_on_one_side_of_a_wall", LAZY_DIAGRAM,
     "return user_distance(m_solver.arrival(m_solver.nearest_side(q)));", "return user_distance(m_solver.arrival(q));",
     "a point of a wall has the distance on the side of its face", (WALLS_OF_DIAGRAMS,)),
    ("cell_mesh_of_one_part", CELL_TRIANGLES,
     "may_have_parts ? all_faces_of_cell(site) : faces_of_connected_cell(site)", "faces_of_connected_cell(site)",
     "the mesh of a cell misses its part behind a wall", (WALLS_OF_DIAGRAMS,)),
    ("cell_without_boundary_missed", CELL_TRIANGLES,
     "if(m_complex.cell(site).vertex != null_id)", "if(m_complex.cell(site).vertex == site)",
     "the mesh of a cell that is a component is empty", (VORONOI_OF_CURVES,)),
    ("parts_of_characteristic_one", CELL_TOPOLOGY,
     "if(elements.pinched_vertices == 0 && !may_have_parts && ", "if(elements.pinched_vertices == 0 && ",
     "a disk and an annulus on two sides of a wall pass for a disk", (WALLS_OF_DIAGRAMS,)),
    ("hole_of_two_edges", EDGE_CONTRACTION,
     "if(m_last == 0 && encloses_hole_of_two(mesh, h))", "if(m_last > 0 && encloses_hole_of_two(mesh, h))",
     "the cut mesh has a hole of two edges, which is no face of a mesh", (WALLS_OF_DIAGRAMS,)),
    ("samples_of_arcs_on_walls", DIAGRAM_SAMPLES,
     "        if(!is_on_wall(arc.point(t)))\n", "",
     "right diagrams between walls are not certified", (WALLS_OF_CERTIFIED_DIAGRAMS,)),
    ("edges_that_end_at_walls", SEPARATION,
     "return !is_inside(opposite(h, tm), diagram) || diagram.avoids_edge(edge(h, tm));",
     "return !is_inside(opposite(h, tm), diagram);",
     "right diagrams between walls are not certified", (WALLS_OF_CERTIFIED_DIAGRAMS,)),
    ("area_behind_walls", DIAGRAM_CERTIFICATE,
     "if(is_at_wall(h, m_diagram))", "if(false && is_at_wall(h, m_diagram))",
     "faces behind a wall are expected in cells that end at it", (WALLS_OF_CERTIFIED_DIAGRAMS,)),
    ("walk_into_avoided_face", TRACE_WALLS,
     "layouts.is_wall(h) || layouts.is_avoided(face(h, tm));", "layouts.is_wall(h);",
     "a traced geodesic enters a face to avoid", (TRACE_OBSTACLES,)),
    ("rim_mirrored", TRACE_AVOIDED,
     "b[next_corner(k)], b[k]);", "b[k], b[next_corner(k)]);",
     "a location at the rim is moved along its edge", (TRACE_OBSTACLES,)),
    ("start_among_avoided_faces", TRACE_AVOIDED,
     "return !is_border(g, tm) && !layouts.is_avoided(face(g, tm)); };", "return !is_border(g, tm); };",
     "a geodesic begins in a face to avoid", (TRACE_OBSTACLES,)),
    ("walk_through_wall", WALK,
     "if(is_end_of_surface(o, m_tm, m_layouts))", "if(is_border(o, m_tm))",
     "a geodesic goes on behind a wall", (WALLS,)),
    ("avoided_faces_shift_positions", READER,
     "m_indices_are_positions = m_indices_are_positions && !result;", "",
     "faces behind a face to avoid get wrong neighbors", (OBSTACLES,)),
    ("rim_from_inside_rejected", SURFACE,
     "if(c[k] != 0 && c[next_corner(k)] != 0 && c[previous_corner(k)] == 0 && is_open(opposite(h, m_tm)))",
     "if(c[k] != 0 && c[next_corner(k)] != 0 && c[previous_corner(k)] != 0 && is_open(opposite(h, m_tm)))",
     "a source on the rim is rejected, and one inside moves to the rim", (OBSTACLES,)),
    ("store_without_faces_to_avoid", STORE_MATRIX,
     "    if(obstacles.is_avoided[f] != 0)\n", "    if(obstacles.is_avoided[f] == 2)\n",
     "a folder that was begun without faces to avoid is continued with them", (OBSTACLES_OF_APPLICATIONS,)),
    ("verified_without_faces_to_avoid", STORE_CHECK,
     "    is_avoided[f] = 1;", "    is_avoided[f] = 0;",
     "a check computes rows through the faces to avoid", (OBSTACLES_OF_APPLICATIONS,)),
    ("certificate_through_faces_to_avoid", DISTANCE_CERTIFICATE,
     "One_block(), std::move(obstacles))", "One_block(), Obstacles{{}, std::move(obstacles.walls)})",
     "distances around obstacles are compared with those through them", (OBSTACLES_OF_APPLICATIONS,)),
    ("area_of_faces_to_avoid", DIAGRAM_CERTIFICATE,
     "if(!m_diagram.avoids_face(f) && extent_around", "if(extent_around",
     "cells have to cover the faces to avoid", (OBSTACLES_OF_APPLICATIONS,)),
    ("rim_is_no_border", SEPARATION,
     "  return !is_border(h, tm) && !diagram.avoids_face(face(h, tm));", "  return !is_border(h, tm);",
     "boundaries of cells may not end at the rim", (OBSTACLES_OF_APPLICATIONS,)),
    ("component_of_a_corner_inside", DIAGRAM_CERTIFICATE,
     "      if(CGAL::to_double(l.second[k]) > largest)", "      if(k == 2)",
     "the area of a site at the rim counts for no component", (OBSTACLES_OF_APPLICATIONS,)),
    ("touching_faces_share_a_vertex", REMESHING_INPUT,
     "    m_number_of_splits += Polygon_mesh_processing::duplicate_non_manifold_vertices(m_mesh);\n  }", "  }",
     "faces that touch in a vertex only are joined there", (OBSTACLES_OF_APPLICATIONS,)),
    ("corners_of_other_curves_end_paths", PATH_SOLVER,
     "        sink.location(location_of_vertex(item.vertex));\n", "        sink.location(end_of_path(steps));\n",
     "where a path runs through a corner of a curve with a larger offset, it jumps to its end", (PATHS_WITH_OFFSETS,)),
    ("offsets_of_curves_ignored", SURFACE_SOURCES,
     "    m_sources.vertices.push_back(null_id);\n    m_surface.add_offset(offset, m_sources);",
     "    m_sources.vertices.push_back(null_id);\n    m_surface.add_offset(0, m_sources);",
     "distances from a curve begin at 0, whatever its offset is", (PATHS_WITH_OFFSETS,)),
    ("curves_without_a_first_run", SAMPLES,
     "return (samples.empty() && !has_sources) ||", "return samples.empty() ||",
     "the first sample is taken before distances from the curves are known", (SAMPLING_BESIDE_CURVES,)),
    ("samples_at_corners_of_curves", SAMPLES,
     "    std::size_t n = m_surface.number_of_vertices();\n", "    std::size_t n = m_field.distance.size();\n",
     "vertices of curves that the user does not know become samples", (SAMPLING_BESIDE_CURVES,)),
    ("relaxation_without_curves", RELAXATION,
     "      diagram.set_sites(curves_parameter(np), sites);\n", "      diagram.set_sites(sites);\n",
     "the cells of sites do not end where a curve is nearer", (RELAXATION_BESIDE_CURVES,)),
    ("energy_of_cells_of_curves", LAZY_DIAGRAM,
     "return has_numbers() && m_sites[cell].curve != nullptr;", "return cell == null_id;",
     "the energy counts the cells of curves, from their first points", (RELAXATION_BESIDE_CURVES,)),
    # --- stored matrices ---
    ("damage_unseen", NPY,
     "  return sum.text() == checksum;", "  return true;",
     "a damaged shard counts as done", (STORE,)),
    ("header_unseen", NPY,
     "if(!is || header.compare(0, header.size(), buffer.data(), npy_header_size) != 0)", "if(!is)",
     "a shard with a damaged header counts as done", (STORE,)),
    ("npy_header_unaligned", NPY,
     "constexpr std::size_t npy_header_size = 128;", "constexpr std::size_t npy_header_size = 132;",
     "elements do not begin at a multiple of 64", (STORE,)),
    ("other_mesh_accepted", STORE_FOLDER,
     "if(other.mesh_hash != m_description.mesh_hash)", "if(false)",
     "rows of two meshes are mixed in one folder", (STORE,)),
    ("other_options_accepted", STORE_FOLDER,
     "if(other.hash() != m_hash)", "if(false)",
     "rows of two kinds are mixed in one folder", (STORE,)),
    ("records_unread", STORE_FOLDER,
     "if(read_record(file(shard, \".done\"), recorded))", "if(false)",
     "a shard that another process has just finished is computed again", (STORE,)),
    ("records_of_any_mesh", STORE_FOLDER,
     "!value.at(\"mesh\").is_text(m_description.mesh_hash) || ", "",
     "records that a killed process has left pass for shards of another mesh", (STORE_FILES,)),
    ("files_of_the_user_removed", STORE_FOLDER,
     "    if(!find_owner(path, owner))\n      return false;\n", "    find_owner(path, owner);\n",
     "old files of the user with the endings .tmp and .lock are removed", (STORE_FILES,)),
    ("files_of_lock_holders_removed", STORE_FOLDER,
     "\n        && !Lock_file::is_held_by_other(m_path / (base_of(path) + \".lock\"), clock)", "",
     "a file that a process of another host writes slowly is removed", (STORE_FILES,)),
    ("manifest_written_without_lock", STORE_FOLDER,
     "if(!lock.is_owned())", "if(false)",
     "a process that has lost the lock replaces a manifest by one without the entries of others", (STORE_FILES,)),
    ("damaged_shards_of_others_count", STORED_MATRIX,
     "std::find(doubtful.begin(), doubtful.end(), s) == doubtful.end()", "true",
     "a damaged shard that another process has locked passes for done", (STORE_FILES,)),
    ("columns_of_damaged_rows_unread", STORED_MATRIX,
     "if(column >= layout().columns)", "if(column > 0x20000000)",
     "a damaged sparse row writes behind the end of memory", (STORE_FILES,)),
    ("violations_relative_to_tiny_distances", STORE_CHECK,
     "(a - b) / (std::max)(a, scale)", "(a - b) / a",
     "the check of a stored matrix rejects meshes with needles", (STORE,)),
    ("triangle_offsets", STORE_LAYOUT,
     "return number * (columns - 1) - (number * (first + row - 1)) / 2;", "return number * (columns - 1);",
     "rows of an upper triangle are read from wrong places", (STORE,)),
    ("half_a_row_stored", STORE_ROWS,
     "      if(m_stop) // the row may be incomplete\n        return;\n", "",
     "a computation that ends stores rows without their distances", (STORE,)),
    ("locks_of_dead_processes", LOCK,
     "return !(parse_owner(text, owner) && is_dead(owner)) && clock.distance(path) < patience;",
     "return clock.distance(path) < patience;",
     "what a killed process had locked is not computed for ten minutes", (KILLS,)),
    ("locks_without_end", LOCK,
     "return !(parse_owner(text, owner) && is_dead(owner)) && clock.distance(path) < patience;",
     "return !(parse_owner(text, owner) && is_dead(owner));",
     "what a dead host had locked is never computed", (KILLS,)),
    ("locks_of_living_processes", LOCK,
     "return !(parse_owner(text, owner) && is_dead(owner)) && clock.distance(path) < patience;",
     "return false;",
     "two processes compute the same shard", (KILLS,)),
    ("members_twice", JSON,
     "      if(object.find(name) != nullptr)\n        complain(\"there are two members '\" + name + \"'\");\n", "",
     "a manifest that was written twice into one file is believed", (STORE,)),
    # --- the same bits for any number of lanes ---
    ("fused_product", SIMD,
     "    if constexpr(std::is_same<FT, double>::value)\n      CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(product);\n", "",
     "a compiler fuses products and sums of single numbers: last digits depend on the processor", (PRODUCTS,)),
    ("fused_product_of_lanes", VECTORS,
     "    CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(product);\n", "",
     "a compiler fuses products and sums of lanes: last digits depend on the number of lanes", (PRODUCTS,)),
    ("fused_product_of_pairs", DOUBLE_PAIR,
     "    CGAL_SURFACE_MESH_GEODESICS_KEEP_ROUNDED(product.v);\n", "",
     "a compiler fuses products and sums of pairs: last digits depend on the processor", (PRODUCTS,)),
    ("barrier_without_effect", SIMD,
     "KEEP_ROUNDED(x) x = __builtin_assoc_barrier(x)", "KEEP_ROUNDED(x) static_cast<void>(x)",
     "no product is rounded before it enters a sum", (PRODUCTS,)),
    ("pair_divides_by_itself", DOUBLE_PAIR,
     "_mm_div_pd(a.v, b.v)", "_mm_div_pd(b.v, a.v)",
     "the quotient of two pairs is the wrong way round", (PRODUCTS,)),
    ("pair_minimum_of_nan", DOUBLE_PAIR,
     "_mm_min_pd(a.v, b.v)", "_mm_min_pd(b.v, a.v)",
     "the minimum of a NaN and a number is the NaN: children of windows are lost", (PRODUCTS,)),
    ("pair_maximum_of_nan", DOUBLE_PAIR,
     "_mm_max_pd(b.v, a.v)", "_mm_max_pd(a.v, b.v)",
     "the maximum of a NaN and a number is the number", (PRODUCTS,)),
    ("pair_less_or_equal", DOUBLE_PAIR,
     "{_mm_cmplt_pd(a.v, b.v)}", "{_mm_cmple_pd(a.v, b.v)}",
     "ties of pairs are decided in another way than those of single numbers", (PRODUCTS,)),
    ("pair_exception_reversed", DOUBLE_PAIR,
     "{_mm_andnot_pd(b.v, a.v)}", "{_mm_andnot_pd(a.v, b.v)}",
     "the lanes of a mask without those of another one are the wrong ones", (PRODUCTS,)),
    ("pair_selects_the_other", DOUBLE_PAIR,
     "_mm_or_pd(_mm_and_pd(m.v, a.v), _mm_andnot_pd(m.v, b.v))", "_mm_or_pd(_mm_and_pd(m.v, b.v), _mm_andnot_pd(m.v, a.v))",
     "a selection takes the lanes of the other number", (PRODUCTS,)),
    ("pair_of_words_selects_the_other", DOUBLE_PAIR,
     "_mm_or_si128(_mm_and_si128(mask, a.v), _mm_andnot_si128(mask, b.v))",
     "_mm_or_si128(_mm_and_si128(mask, b.v), _mm_andnot_si128(mask, a.v))",
     "a selection takes the lanes of the other word", (PRODUCTS,)),
    ("pair_shifts_down", DOUBLE_PAIR,
     "_mm_shuffle_pd(previous.v, x.v, 1)", "_mm_shuffle_pd(previous.v, x.v, 2)",
     "a window is compared with itself, not with its neighbor", (PRODUCTS,)),
    ("pair_first_unsigned", DOUBLE_PAIR,
     "Number(static_cast<double>(static_cast<std::int64_t>(n)))", "Number(static_cast<double>(n))",
     "all lanes count in a step that begins behind the last window", (PRODUCTS,)),
    ("pair_least_of_unset_lanes", DOUBLE_PAIR,
     "bits == 1 || (bits == 3 && words[0] < words[1])", "words[0] < words[1]",
     "the smallest word is that of a lane that does not count", (PRODUCTS,)),
    ("pair_largest_number", DOUBLE_PAIR,
     "numbers[0] < numbers[1] ? numbers[0] : numbers[1]", "numbers[0] < numbers[1] ? numbers[1] : numbers[0]",
     "a list of windows is believed to be farther than it is", (PRODUCTS,)),
    ("pair_counts_alike", DOUBLE_PAIR,
     "{begin, begin + 1}", "{begin, begin}",
     "both windows of a pair have the number of the first one", (PRODUCTS,)),

    # --- curves as sources ---

    ("strip_trimmed_from_left", STRIP_SPLITTING,
     "slope_left = one - L::rounded_product", "slope_left = one + L::rounded_product",
     "a vertex beats rays that are shorter than the way by it", (CURVES, HOSTILE_CURVES)),
    ("strip_trimmed_from_right", STRIP_SPLITTING,
     "slope_right = one + L::rounded_product", "slope_right = one - L::rounded_product",
     "the same from the other end of the edge", (CURVES, HOSTILE_CURVES)),
    ("strip_turned_to_wrong_side", STRIP_SPLITTING,
     "                  + L::rounded_product(s.direction_y, side.angle.sine);",
     "                  - L::rounded_product(s.direction_y, side.angle.sine);",
     "parallel rays bend where they cross an edge to the left", (CURVES,)),
    ("strip_cut_at_apex", STRIP_SPLITTING,
     "s.end = L::select(L::less_equal(apex, end), length,", "s.end = L::select(L::less_equal(apex, end), length / 2,",
     "rays next to the apex get lost", (CURVES,)),
    ("strip_distance_from_wrong_end", STRIP_SPLITTING,
     "s.distance = at_target - L::rounded_product(s.direction_x, side.length);", "s.distance = at_target;",
     "distances of rays that cross to the right are those at the other end of the edge", (CURVES,)),
    ("strip_foot_from_wrong_end", STRIP_SPLITTING,
     "s.foot = foot_of_target - L::rounded_product(height, side.length);", "s.foot = foot_of_target;",
     "the feet of rays that cross to the right are wrong", (CURVES,)),
    ("strip_split_by_path_from_elsewhere", STRIP_FRONT,
     "return m_field.arrival[c.apex].halfedge == h ?", "return m_field.arrival[c.apex].halfedge != null_id ?",
     "a path that enters the face across another edge decides which rays go on", (CURVES, HOSTILE_CURVES)),
    ("strip_to_left_cut_too_far", STRIP_SPLITTING,
     "last = L::select(is_longer, L::minimum(apex, L::all(side.cut)), apex);",
     "last = L::select(is_longer, s.begin, apex);",
     "rays on the left of a better path to the apex get lost", (CURVES, HOSTILE_CURVES)),
    ("strips_beyond_the_apex", STRIP_LOOPS,
     "L::less(L::all(side.known), L::load(strips.apex_distance() + i))", "L::first(L::size)",
     "a tie at the apex takes rays away", (CURVES, HOSTILE_CURVES)),
    ("nothing_beside_normals", NORMALS,
     "m_slope = Tolerance<FT>::beside_normal();", "m_slope = -Tolerance<FT>::beside_normal();",
     "next to the normals no window and no strip is known", (HOSTILE_CURVES, CURVES, VORONOI_OF_CURVES)),
    ("sector_of_farther_curves", NORMALS,
     "found->halfedge == h && !(star.distance < found->offset);", "found->halfedge == h;",
     "a source on a curve with an offset emits between the normals of the curve only", (CURVES, HOSTILE_CURVES)),
    ("sector_on_wrong_side_of_normal", NORMALS,
     "FT& taken = is_counterclockwise ? part.rest : part.begin;",
     "FT& taken = is_counterclockwise ? part.begin : part.rest;",
     "what is taken out of a face is the wrong end of its edge", (EMISSION, CURVES)),
    ("bent_ray_taken_for_straight", STRIP,
     "FT(up_to_edge + norm<FT>(x - abscissa, y));", "distance_of_ray(s, x, y);",
     "the apex gets the length of a ray that is not there", (CURVES,)),
    ("strips_on_one_side", STRIP_FRONT,
     "      add_first_strip(e.right, e.offset, 2 * i + 1, push);\n", "",
     "no ray leaves a curve to the right", (CURVES,)),
    ("strips_turn_in_one_direction", STRIP_FRONT,
     "        are_windows_stale |= turn<false>(previous_halfedge(f->halfedge), wavefront, push);\n", "        {}\n",
     "strips that have entered a star across a left edge stay there", (CURVES,)),
    ("strip_reaches_apex_beside_its_rays", STRIP_SPLITTING,
     "return L::select(L::less_equal(s.begin, crossing) & L::less_equal(crossing, s.end), L::maximum(zero, along_ray),\n"
     "                   up_to_edge + beyond);",
     "return L::maximum(zero, along_ray);",
     "a strip seems to be nearest to an apex that none of its rays reaches", (CURVES, HOSTILE_CURVES)),
    ("vertices_of_curves_emit_nothing", STRIP_FRONT,
     "      wavefront.add_source(v.vertex, v.offset, push);\n", "",
     "corners and ends of curves are no sources", (CURVES,)),
    ("foot_counted_from_wrong_end", CURVE_ARRIVALS,
     "foot.side % 2 == 0 ? along : FT(1 - along)", "foot.side % 2 != 0 ? along : FT(1 - along)",
     "the nearest point of a segment is mirrored", (CURVES,)),
    ("rays_turned_by_lengths", STRIP_SPLITTING,
     """const Number height = L::rounded_product(s.direction_y, side.angle.cosine)
                        + L::rounded_product(s.direction_x, side.angle.sine);""",
     "const Number height = s.direction_y * (L::all(side.edge_length) - apex) / side.length;",
     "beside a short edge, rays turn by a wrong angle, and distances are too small", (HOSTILE_CURVES,)),
    ("sector_as_certain_as_its_distance", SECTOR,
     "(star.distance + reach)", "star.distance",
     "beside a source, a vertex leaves out windows that a shortest path needs", (HOSTILE_CURVES,)),
    ("queries_without_strips", LOCATION_DISTANCE,
     "if(strips != nullptr)", "if(false)",
     "points of faces do not see the rays of curves", (CURVE_PATHS,)),
    ("feet_inside_faces_unreported", PATH_SOLVER,
     "    sink.location(end_of_path(steps));\n  }\n\n  // The surface", "  }\n\n  // The surface",
     "a path ends one point before the curve", (CURVE_PATHS,)),
    ("second_run_forgets_strips", PATH_RUN,
     "propagation.strips().keep_in(&arrivals.strips);", "",
     "strips are not kept", (CURVE_PATHS,)),
    ("vertices_beside_curves_at_one_place", SURFACE_SOURCES,
     "result[i].vertex = m_sources.vertices[i];", "result[i].vertex = 0;",
     "vertices among curves are taken for the first vertex of the mesh", (CURVE_PATHS,)),
    ("curves_walked_once", CURVE_INSERTION,
     "while(m_has_inserted && ++walks < most_walks);\n    if(m_has_inserted)", "while(false);\n    if(false)",
     "edges of a curve that a later one divides get lost", (CURVES,)),
    ("larger_offset_of_copies", CURVE_INSERTION,
     "(name_of(a) == name_of(b) && a.offset < b.offset)", "(name_of(a) == name_of(b) && a.offset > b.offset)",
     "where two curves run along one edge, the larger offset counts", (CURVES,)),
    ("curves_along_twice_separate", CURVE_SIDES,
     "if(e.copies % 2 == 1)", "if(true)",
     "a part of a curve that is run along twice changes the side", (SIGNS,)),
    ("sides_without_contradictions", CURVE_SIDES,
     "else if(m_face_sign[f] != s)", "else if(false)",
     "curves that do not separate the surface are not rejected", (SIGNS,)),
    ("sides_end_at_pinches", CURVE_SIDES,
     "color(face_of(around), s, null_id);", "static_cast<void>(around);",
     "two sides of a curve are connected by a pinched vertex, and are not rejected", (SIGNS,)),
    ("isolines_on_other_side", ISOLINE_CHOICE,
     "is_negative ? -1 : 1", "is_negative ? 1 : -1",
     "isolines with a sign are those of the other side of the curves", (SIGNED_ISOLINES,)),
    ("sides_with_offsets", ISOLINE_CHOICE,
     "if(v.offset != 0)", "if(false)",
     "isolines with a sign cross curves with an offset", (SIGNED_ISOLINES,)),
    ("curve_points_mirrored_in_neighbor", CURVE_SEGMENTS,
     "b[k] = h == m_edge ? m_source_weight : m_target_weight;", "b[k] = m_source_weight;",
     "a point of an edge lies elsewhere in the other face of the edge", (CURVES,)),
    ("curve_of_paths_through_avoided_faces", PATH_CURVE,
     "if(avoids_faces || !internal::find_segment(", "if(!internal::find_segment(",
     "a curve that should lead around a face runs through it", (CURVES_OF_PATHS,)),
    ("curve_of_paths_ends_at_any_point", CURVE_PATH_WRITER,
     "  paths.remove_all_sources();\n", "",
     "a path to the next point ends at an earlier point that is nearer", (CURVES_OF_PATHS,)),
    ("curve_of_paths_is_open", PATH_CURVE,
     "places.size() - (is_closed ? 0 : 1)", "places.size() - 1",
     "the last point is not joined with the first one", (CURVES_OF_PATHS,)),
    ("border_through_faces_to_avoid", BORDER_CYCLES,
     "while(!is_open(opposite(h, tm)))", "while(false)",
     "the border of the rest leads on along an edge that is not on it", (BORDER_CURVES,)),
    ("border_in_the_other_direction", SURFACE_CURVE,
     "(tm, opposite(h, tm), true));", "(tm, opposite(h, tm), false));",
     "the segments of a border do not join", (BORDER_CURVES,)),
    ("curve_of_paths_from_inside", CURVE_SEGMENTS,
     "is_inside = is_inside && is_avoided(f);", "is_inside = false && is_avoided(f);",
     "a point inside of the faces to avoid is called source 0, wherever it is in the range", (CURVES_OF_PATHS,)),
    ("further_curves_with_any_weight", CURVE_INSERTION,
     "item.offset == kept.offset && ", "",
     "a curve with a smaller weight counts beside the one that it meets", (NEAREST_SITES,)),
    ("further_curves_of_edges_lost", CURVE_ARRIVALS,
     "is_vertex ? curves.further_curves_of_vertices : curves.further_curves_of_edges",
     "curves.further_curves_of_vertices",
     "an edge on several curves belongs to one of them", (NEAREST_SITES,)),
    ("equal_sources_with_any_offset", SOURCE_SET,
     "if(offset(j) == offset(i) && ", "if(",
     "a site with a smaller weight counts beside the one at its point", (NEAREST_SITES,)),
    ("equal_sources_on_one_side", SOURCE_SET,
     "if(number(j) == i)", "if(j == i)",
     "two sites on the sides of a wall are not at one point", (NEAREST_SITES,)),
    ("search_trusts_distances_that_are_not_final", DISTANCE_FIELD,
     "return (std::min)(distance[v], final_distance);", "return distance[v];",
     "where a run has ended early, the search for a path drops the way that the path takes", (PAIR_PATHS,)),
    ("directions_from_any_edge_of_border", SURFACE_SOURCES,
     "    if(!a.is_closed)\n      a = angle_around", "    if(false)\n      a = angle_around",
     "directions at a border that was cut later count from an edge in its middle", (BORDER_DIRECTIONS,)),
    ("directions_of_border_reduced", PATH_DIRECTIONS,
     "return d.is_at_border ? ", "return false ? ",
     "directions at a border with more than a full circle lead elsewhere", (BORDER_DIRECTIONS,)),
]
