/*!
\ingroup PkgSurfaceMeshGeodesicsConcepts
\cgalConcept

The concept `GeodesicRelaxationVisitor` describes the requirements for a visitor that also follows the iterations of
`CGAL::Surface_mesh_geodesics::geodesic_Lloyd_relaxation()` and of the relaxation in
`CGAL::Surface_mesh_geodesics::geodesic_remeshing()`. These functions take any model of `GeodesicPropagationVisitor` and
call the function below if it has one. The energies are computed only then.

\cgalRefines{GeodesicPropagationVisitor}
*/
class GeodesicRelaxationVisitor
{
public:
  /// is called after each iteration, when the sites have moved.
  ///
  /// \param iteration the number of the iteration, counted from 1
  /// \param largest_move the largest distance in space by which a site has moved, in the unit of the mesh
  /// \param energy the energy of the sites before they moved, with their cells:
  ///        `CGAL::Surface_mesh_geodesic_Voronoi_diagram::energy()`, to which the cells of curves add nothing
  void on_iteration(std::size_t iteration, double largest_move, double energy);
};
