/// Every `#ifdef CASE_` below is a misuse of ids that must not compile; the rest of the file must. Each case
/// becomes a test of its own.
#include "thalweg/id.hpp"
#include "thalweg/triangulation.hpp"

namespace {

using thalweg::FaceId;
using thalweg::HalfedgeId;
using thalweg::VertexId;

void want_vertex(VertexId) {}

[[maybe_unused]] void use(const thalweg::Triangulation& mesh, VertexId v, HalfedgeId h, FaceId f) {
  want_vertex(v);
  want_vertex(VertexId(7));
  (void)(v < VertexId(1) && h == HalfedgeId(2) && f != FaceId(3));
  (void)mesh.origin(h);
  std::uint32_t number = v.index();
  v = VertexId(number + 1);

#ifdef CASE_vertex_from_halfedge
  want_vertex(h);
#endif
#ifdef CASE_vertex_from_face
  want_vertex(VertexId(f));
#endif
#ifdef CASE_vertex_from_integer
  want_vertex(7u);
#endif
#ifdef CASE_vertex_from_braces
  want_vertex({7u});
#endif
#ifdef CASE_integer_from_vertex
  number = v;
#endif
#ifdef CASE_array_index
  int array[4] = {};
  (void)array[v];
#endif
#ifdef CASE_assign_across_tags
  f = h;
#endif
#ifdef CASE_equal_across_tags
  (void)(v == f);
#endif
#ifdef CASE_less_across_tags
  (void)(v < h);
#endif
#ifdef CASE_compare_with_integer
  (void)(v == 7u);
#endif
#ifdef CASE_arithmetic
  (void)(v + 1);
#endif
#ifdef CASE_increment
  ++v;
#endif
#ifdef CASE_in_a_condition
  if (v) number = 0;
#endif
#ifdef CASE_origin_of_a_vertex
  (void)mesh.origin(v);
#endif
#ifdef CASE_outgoing_of_a_number
  (void)mesh.outgoing(0u);
#endif
}

}  // namespace
