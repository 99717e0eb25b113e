/*!
\ingroup PkgSurfaceMeshGeodesicsConcepts
\cgalConcept

The concept `GeodesicPropagationVisitor` describes the requirements for a visitor: an object that follows a propagation
and can cancel it. `CGAL::Surface_mesh_geodesics::Geodesic_distance_solver::compute_distances()` takes it with the named
parameter `visitor`, and so do the free functions whose reference lists that parameter. The following functions take it
as an argument:
`CGAL::Surface_mesh_geodesic_paths::build_sequence_tree()`,
`CGAL::Surface_mesh_geodesic_paths::build_sequence_tree_for_faces()` and
`CGAL::Surface_mesh_geodesic_Voronoi_diagram::build()`.

<b>Order of calls.</b> First `on_propagation_begin()`; then, any number of times, `on_progress()` followed by
`go_further()`; at last `on_propagation_end()`. A function that propagates several times, such as
`CGAL::Surface_mesh_geodesics::geodesic_remeshing()`, repeats this sequence each time, and may ask `go_further()` between
two of them as well. Invalid input is found before the first call, except curves that rounding hides or that do not
separate the surface, and vertices of `CGAL::Surface_mesh_geodesics::geodesic_peeling_order()`.

<b>Threads.</b> The thread that has called the function of the package makes all calls, even if that function uses more
threads. Only stored matrices call from several threads, one call at a time.

<b>Requirements.</b> The member functions should be fast, since they are called up to once for each visit of a vertex.
They must not use the object that propagates. They may throw. An exception ends the propagation as a cancellation does,
but without a call of `on_propagation_end()`, and reaches the caller.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_geodesics::Geodesic_default_visitor}
\cgalHasModelsEnd
*/
class GeodesicPropagationVisitor
{
public:
  /// is called once, before the propagation starts.
  ///
  /// \param number_of_vertices the number of vertices of the mesh; of a matrix that is stored the number of rows, and of
  ///        other work that is no propagation the number of its steps. There may be more visits, as some vertices
  ///        are visited again
  void on_propagation_begin(std::size_t number_of_vertices);

  /// is called repeatedly: before each visit of a vertex if one thread propagates, less often if several do. Neither of
  /// the two numbers ever decreases during a propagation.
  ///
  /// \param number_of_visits the number of vertices that the wavefront has visited so far; a vertex that is visited
  ///        again counts again
  /// \param distance_reached a distance, in the unit of the mesh; all distances up to it are final
  void on_progress(std::size_t number_of_visits, double distance_reached);

  /// is called after each `on_progress()`. Returning `false` cancels the propagation: nothing is written to the
  /// property maps of the caller, and a function that returns `bool` returns `false`. Sampling and relaxation, which
  /// propagate several times, return their last complete results. Remeshing adds nothing. The
  /// reference of `geodesic_peeling_order()`, of certificates and of stored matrices says what these return.
  bool go_further();

  /// is called once at the end, also after a cancellation.
  void on_propagation_end();
};
