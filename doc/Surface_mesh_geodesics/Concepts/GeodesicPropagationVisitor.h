/*!
\ingroup PkgSurfaceMeshGeodesicsConcepts
\cgalConcept

The concept `GeodesicPropagationVisitor` describes what the functions of this package ask of a visitor, the object that
follows a propagation and may end it before its time. It is passed with the named parameter `visitor` to the free
functions, and as an argument to `CGAL::Surface_mesh_geodesic_paths::build_sequence_tree()`,
`CGAL::Surface_mesh_geodesic_Voronoi_diagram::build()` and
`CGAL::Surface_mesh_geodesics::Geodesic_distance_solver::compute_distances()`.

The functions are called in the order `on_propagation_begin()`, then any number of times `on_progress()` and
`go_further()` in turn, then `on_propagation_end()`; all of them by the thread that has called the function of the
package, also if that uses more threads. A function that propagates several times, such as
`CGAL::Surface_mesh_geodesics::geodesic_remeshing()`, repeats all this each time. Invalid input is found earlier: then
none of them is called. They should be fast, as they are called up to once for each visit of a vertex. They must not use
the object that propagates.

They may throw: the propagation ends then as if it had been cancelled, but without a call of `on_propagation_end()`, and
the exception is passed on to the caller.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh_geodesics::Geodesic_default_visitor}
\cgalHasModelsEnd
*/
class GeodesicPropagationVisitor
{
public:
  /// is called once, before the propagation starts.
  ///
  /// \param number_of_vertices the number of vertices of the mesh
  void on_propagation_begin(std::size_t number_of_vertices);

  /// is called from time to time: before each visit of a vertex by one thread, less often with several. Neither of the
  /// two numbers ever decreases during a propagation.
  ///
  /// \param number_of_visits the number of vertices that the wavefront has visited so far; a vertex may be visited more
  ///        than once
  /// \param distance_reached a distance, in the unit of the mesh, up to which all distances are final
  void on_progress(std::size_t number_of_visits, double distance_reached);

  /// is asked after each `on_progress()`. If it returns `false`, the propagation is cancelled: nothing is written to
  /// the property maps of the caller, and the function that propagates returns `false`. (Sampling, relaxation and
  /// remeshing, which propagate several times, return what they had before; see there.)
  bool go_further();

  /// is called once at the end, also if the propagation was cancelled.
  void on_propagation_end();
};
