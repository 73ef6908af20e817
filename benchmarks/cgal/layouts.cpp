// Exact detection of overlapping parts, and of parts outside the container, with CGAL.
//
//     layouts OPERATION SECONDS < LAYOUT
//
// OPERATION is `meet`, a test whether interiors intersect, or `intersection`, which computes the
// intersection, as programs with doubles do.
//
// LAYOUT consists of the number of shapes and the shapes; the last one is the complement of the
// container in a frame. A shape consists of the number of rings and the rings, the exterior first; a
// ring of the number of vertices and their exact rational coordinates, counter-clockwise for an
// exterior, clockwise for a hole. The program repeats runs for about SECONDS, and writes their
// processor times in ms on one line, then the overlapping pairs, one per line. A run constructs the
// polygons, finds the pairs of intersecting boxes, and applies the operation to each.

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using Shape = CGAL::Polygon_with_holes_2<Kernel>;
using Exact = Kernel::FT::Exact_type;
using Ring = std::vector<std::pair<Exact, Exact>>;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 2, const Shape*>;
using Pairs = std::vector<std::pair<long, long>>;

static Polygon make_ring(const Ring& ring) {
  Polygon made;
  for (const auto& [x, y] : ring) made.push_back(Point(Kernel::FT(x), Kernel::FT(y)));
  return made;
}

static Shape make_shape(const std::vector<Ring>& rings) {
  Shape made(make_ring(rings[0]));
  for (std::size_t k = 1; k < rings.size(); ++k) made.add_hole(make_ring(rings[k]));
  return made;
}

static bool overlap(const Shape& a, const Shape& b, bool meet) {
  if (!meet) {
    std::vector<Shape> common;
    CGAL::intersection(a, b, std::back_inserter(common));
    return !common.empty();
  }
  const bool holes = a.number_of_holes() || b.number_of_holes();
  return holes ? CGAL::do_intersect(a, b)
               : CGAL::do_intersect(a.outer_boundary(), b.outer_boundary());
}

static Pairs judge(const std::vector<std::vector<Ring>>& given, bool meet) {
  std::vector<Shape> shapes;
  shapes.reserve(given.size());
  for (const auto& rings : given) shapes.push_back(make_shape(rings));
  std::vector<Box> boxes;
  for (const Shape& shape : shapes) boxes.emplace_back(shape.bbox(), &shape);
  Pairs found;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (overlap(*a.handle(), *b.handle(), meet)) {
      const long k = a.handle() - shapes.data(), j = b.handle() - shapes.data();
      found.emplace_back(std::min(k, j), std::max(k, j));
    }
  });
  std::sort(found.begin(), found.end());
  return found;
}

int main(int, char** arguments) {
  if (std::string(arguments[1]) == "version") {
    std::cout << CGAL_VERSION_STR << '\n';
    return 0;
  }
  const bool meet = std::string(arguments[1]) == "meet";
  const double seconds = std::atof(arguments[2]);
  std::size_t count = 0;
  std::cin >> count;
  std::vector<std::vector<Ring>> given(count);
  for (auto& rings : given) {
    std::size_t size = 0;
    std::cin >> size;
    rings.resize(size);
    for (Ring& ring : rings) {
      std::cin >> size;
      ring.resize(size);
      for (auto& [x, y] : ring) std::cin >> x >> y;
    }
  }
  Pairs found;
  double total = 0;
  while (total == 0 || total < seconds) {
    const std::clock_t start = std::clock();
    found = judge(given, meet);
    const double taken = double(std::clock() - start) / CLOCKS_PER_SEC;
    total += std::max(taken, 1e-6);
    std::cout << 1000 * taken << ' ';
  }
  std::cout << '\n';
  for (const auto& [k, j] : found) std::cout << k << ' ' << j << '\n';
}
