/// A counter of your own: whatever has `count_in_circle` can stand where the library's counters stand. Here
/// the orders of the triangles of a terrain are found three ways: by trying every site, by the search of the
/// Delaunay graph, and by point location in an order-k Voronoi diagram.
#include <thalweg/thalweg.hpp>

#include <cstdio>
#include <vector>

namespace {

/// Tries every site: the slowest counter, and the easiest to believe.
class EverySite {
 public:
  explicit EverySite(const std::vector<thalweg::Point2>& sites) : sites_(sites) {}

  unsigned count_in_circle(thalweg::VertexId u, thalweg::VertexId v, thalweg::VertexId w,
                           unsigned limit) const {
    unsigned count = 0;
    for (const thalweg::Point2& site : sites_) {
      const bool inside =
          thalweg::incircle(sites_[u.index()], sites_[v.index()], sites_[w.index()], site) > 0;
      if (inside && ++count > limit) break;
    }
    return count;
  }

 private:
  const std::vector<thalweg::Point2>& sites_;
};

/// How many triangles have order 0, 1, ... limit, and more.
template <class Counter>
std::vector<unsigned> histogram(const thalweg::Triangulation& mesh, Counter&& counter, unsigned limit) {
  std::vector<unsigned> result(limit + 2);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto [u, v, w] = mesh.corners(thalweg::FaceId(f));
    ++result[counter.count_in_circle(u, v, w, limit)];
  }
  return result;
}

}  // namespace

int main() {
  // A bumpy slope on a grid that is a little askew.
  std::vector<thalweg::Point2> sites;
  std::vector<thalweg::Point3> points;
  for (int i = 0; i < 200; ++i) {
    const double x = i % 20 + (i * 37 % 11) / 16.0;
    const double y = i / 20 + (i * 53 % 13) / 16.0;
    sites.push_back({x, y});
    points.push_back({x, y, y + i * 61 % 17});
  }
  constexpr unsigned kOrder = 4;
  const auto terrain = thalweg::minimize_pits(points, {.order = kOrder});
  const auto delaunay = thalweg::delaunay(sites);
  const auto diagram = thalweg::order_k_voronoi(sites, kOrder + 1);
  if (!terrain || !delaunay || !diagram) return 1;

  const thalweg::DelaunayGraph graph(sites, *delaunay);
  const thalweg::Triangulation& mesh = terrain->triangulation;
  const auto tried = histogram(mesh, EverySite(sites), kOrder);
  const auto searched = histogram(mesh, thalweg::CircleCounter(graph), kOrder);
  const auto located = histogram(mesh, thalweg::VoronoiCounter(*diagram), kOrder);
  for (unsigned k = 0; k <= kOrder; ++k) std::printf("order %u: %u triangles\n", k, tried[k]);
  return tried == searched && tried == located && tried.back() == 0 && tried[0] < mesh.face_count() ? 0 : 2;
}
