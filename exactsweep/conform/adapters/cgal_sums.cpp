// Minkowski sums of pairs of polygons with CGAL, on exact rationals, a pair a line.
//
//   g++ -std=c++17 -O2 -DNDEBUG -o exactsweep-cgal cgal_sums.cpp -lgmp -lmpfr
//
//   exactsweep-cgal version
//   exactsweep-cgal STRATEGY
//
// Reads, for each pair, one line: the number of rings of the one polygon, its exterior and its holes,
// each as the number of its vertices and their coordinates; then the same of the other one. Answers with one line: the number of rings of the sum, then each
// ring, as the number of its vertices and their coordinates; or a line that starts with "error".

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <CGAL/version.h>

#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using Region = CGAL::Polygon_with_holes_2<Kernel>;

Polygon read_polygon(std::istream& in) {
  std::size_t size = 0;
  in >> size;
  Polygon polygon;
  for (CGAL::Exact_rational x, y; size > 0 && in >> x >> y; --size)
    polygon.push_back(Kernel::Point_2(Kernel::FT(x), Kernel::FT(y)));
  if (!in) throw std::runtime_error("the line is not two polygons");
  return polygon;
}

void write_ring(std::ostream& out, const Polygon& ring) {
  out << " " << ring.size();
  for (const auto& point : ring.vertices())
    out << " " << CGAL::exact(point.x()) << " " << CGAL::exact(point.y());
}

Region read_region(std::istream& in) {
  std::size_t size = 0;
  in >> size;
  std::vector<Polygon> rings;
  while (rings.size() < size) rings.push_back(read_polygon(in));
  if (rings.empty()) throw std::runtime_error("a polygon without rings");
  return Region(rings[0], rings.begin() + 1, rings.end());
}

template <class Decomposition, class Shape>
Region by_pieces(const Shape& p, const Shape& q) {
  return CGAL::minkowski_sum_2(p, q, Decomposition());
}

Region sum_of_regions(const std::string& strategy, const Region& p, const Region& q) {
  if (strategy == "reduced") return CGAL::minkowski_sum_2(p, q);
  if (strategy == "vertical") return by_pieces<CGAL::Polygon_vertical_decomposition_2<Kernel>>(p, q);
  if (strategy == "triangulation")
    return by_pieces<CGAL::Polygon_triangulation_decomposition_2<Kernel>>(p, q);
  throw std::runtime_error(strategy + " takes no holes");
}

Region sum_of_polygons(const std::string& strategy, const Polygon& p, const Polygon& q) {
  if (strategy == "reduced") return CGAL::minkowski_sum_2(p, q);
  if (strategy == "full") return CGAL::minkowski_sum_by_full_convolution_2(p, q);
  if (strategy == "bisectors")
    return by_pieces<CGAL::Small_side_angle_bisector_decomposition_2<Kernel>>(p, q);
  if (strategy == "optimal")
    return by_pieces<CGAL::Optimal_convex_decomposition_2<Kernel>>(p, q);
  if (strategy == "hertel-mehlhorn")
    return by_pieces<CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>>(p, q);
  if (strategy == "greene") return by_pieces<CGAL::Greene_convex_decomposition_2<Kernel>>(p, q);
  if (strategy == "vertical") return by_pieces<CGAL::Polygon_vertical_decomposition_2<Kernel>>(p, q);
  if (strategy == "triangulation")
    return by_pieces<CGAL::Polygon_triangulation_decomposition_2<Kernel>>(p, q);
  throw std::runtime_error("no strategy " + strategy);
}

std::string answer(const std::string& strategy, const std::string& line) try {
  std::istringstream in(line);
  const Region p = read_region(in), q = read_region(in);
  const bool simple = p.number_of_holes() + q.number_of_holes() == 0;
  const Region region = simple ? sum_of_polygons(strategy, p.outer_boundary(), q.outer_boundary())
                               : sum_of_regions(strategy, p, q);
  std::ostringstream out;
  out << 1 + region.number_of_holes();
  write_ring(out, region.outer_boundary());
  for (auto hole = region.holes_begin(); hole != region.holes_end(); ++hole) write_ring(out, *hole);
  return out.str();
} catch (const std::exception& problem) {
  std::string text = problem.what();
  for (char& c : text)
    if (c == '\n') c = ' ';
  return "error " + text;
}

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const std::string strategy = arguments[1];
  if (strategy == "version") {
    std::cout << CGAL_VERSION_STR << std::endl;
    return 0;
  }
  for (std::string line; std::getline(std::cin, line);)
    std::cout << answer(strategy, line) << std::endl;
}
