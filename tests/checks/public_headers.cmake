# The layer of every public header: the one place that says so. The layering check and the test that each header
# compiles alone both read it; a header that is missing here fails the check.
set(kernel_headers array.hpp delaunay.hpp export.hpp id.hpp point.hpp predicates.hpp result.hpp triangulation.hpp
                   validate.hpp version.hpp)
set(order_headers circle_count.hpp order_k_voronoi.hpp useful_order.hpp voronoi_counter.hpp)
set(terrain_headers drainage.hpp hard_instances.hpp minimize.hpp pits.hpp thalweg.hpp)
set(bindings_headers thalweg.h)
