// Minkowski sums and erosions with CGAL, on exact numbers, timed around the computation alone.
//
//   minkowski OPERATION STRATEGY SECONDS [kept|text] < input
//
// OPERATION is `sum` (P + Q), `frame` or `halves` (the inside of P eroded by -Q, that is, what is
// left of the plane by (complement of P) + Q): `frame` gives the complement to CGAL as a rectangle
// with the hole P, `halves` as two simple polygons, the rectangle being cut to the left and to the
// right of P.  STRATEGY is one of the names in `sum_by_name`.  The input is, for each of P and Q,
// the number of vertices and two rationals a vertex.
//
// Repeats for about SECONDS, at most 100 times, and writes the processor times in
// milliseconds on one line, the most memory of the process in kB on the next, then the outer boundary
// of the sum, or the one hole of the erosion, a vertex a line.  Each run starts from new numbers and ends when all coordinates of the result are exact; with `kept` all runs
// are on the same polygons, and with `text` each reads its numbers from text.

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact = CGAL::Exact_rational;
using Point = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using Region = CGAL::Polygon_with_holes_2<Kernel>;
using Numbers = std::vector<std::pair<Exact, Exact>>;

Numbers read_numbers(std::istream& input) {
  std::size_t size;
  input >> size;
  Numbers numbers(size);
  for (auto& [x, y] : numbers) input >> x >> y;
  if (!input) throw std::runtime_error("the input is not two polygons");
  return numbers;
}

Polygon make_polygon(const Numbers& numbers) {
  Polygon polygon;
  for (const auto& [x, y] : numbers) polygon.push_back(Point(Kernel::FT(x), Kernel::FT(y)));
  return polygon;
}

Region sum_by_name(const std::string& strategy, const Polygon& p, const Polygon& q) {
  if (strategy == "reduced") return CGAL::minkowski_sum_2(p, q);
  if (strategy == "full") return CGAL::minkowski_sum_by_full_convolution_2(p, q);
  if (strategy == "bisectors")
    return CGAL::minkowski_sum_2(p, q, CGAL::Small_side_angle_bisector_decomposition_2<Kernel>());
  if (strategy == "optimal")
    return CGAL::minkowski_sum_2(p, q, CGAL::Optimal_convex_decomposition_2<Kernel>());
  if (strategy == "Hertel-Mehlhorn")
    return CGAL::minkowski_sum_2(p, q, CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>());
  if (strategy == "Greene")
    return CGAL::minkowski_sum_2(p, q, CGAL::Greene_convex_decomposition_2<Kernel>());
  if (strategy == "vertical")
    return CGAL::minkowski_sum_2(p, q, CGAL::Polygon_vertical_decomposition_2<Kernel>());
  if (strategy == "triangulation")
    return CGAL::minkowski_sum_2(p, q, CGAL::Polygon_triangulation_decomposition_2<Kernel>());
  throw std::runtime_error("no strategy " + strategy);
}

Region sum_of_frame(const std::string& strategy, const Region& p, const Polygon& q) {
  const CGAL::Small_side_angle_bisector_decomposition_2<Kernel> simple;
  if (strategy == "reduced") return CGAL::minkowski_sum_2(p, q);
  if (strategy == "vertical")
    return CGAL::minkowski_sum_2(p, q, CGAL::Polygon_vertical_decomposition_2<Kernel>(), simple);
  if (strategy == "triangulation")
    return CGAL::minkowski_sum_2(p, q, CGAL::Polygon_triangulation_decomposition_2<Kernel>(),
                                 simple);
  throw std::runtime_error("no strategy " + strategy);
}

// The corners of a rectangle around P, so far from it that what the sum does to the rectangle's
// own boundary stays clear of the result.
std::vector<Point> frame_around(const Polygon& p, const Polygon& q) {
  const auto width = q.right_vertex()->x() - q.left_vertex()->x();
  const auto height = q.top_vertex()->y() - q.bottom_vertex()->y();
  const auto left = p.left_vertex()->x() - 2 * width, right = p.right_vertex()->x() + 2 * width;
  const auto low = p.bottom_vertex()->y() - 2 * height, high = p.top_vertex()->y() + 2 * height;
  return {Point(left, low), Point(right, low), Point(right, high), Point(left, high)};
}

// The vertices of P from one vertex up to another, both included, counter-clockwise.
std::vector<Point> run(const Polygon& p, Polygon::Vertex_const_iterator from,
                       Polygon::Vertex_const_iterator to) {
  std::vector<Point> points;
  for (auto at = from;; ++at) {
    if (at == p.vertices_end()) at = p.vertices_begin();
    points.push_back(*at);
    if (at == to) return points;
  }
}

Polygon only_hole(const Region& region) {
  if (region.number_of_holes() != 1) throw std::runtime_error("the erosion is not one polygon");
  return *region.holes_begin();
}

Polygon erode(const std::string& operation, const std::string& strategy, const Polygon& p,
              const Polygon& q) {
  const std::vector<Point> corners = frame_around(p, q);
  if (operation == "frame") {
    Region frame(Polygon(corners.begin(), corners.end()));
    Polygon hole = p;
    hole.reverse_orientation();
    frame.add_hole(hole);
    return only_hole(sum_of_frame(strategy, frame, q));
  }
  const auto first = p.left_vertex(), last = p.right_vertex();
  const Point left(corners[0].x(), first->y()), right(corners[1].x(), last->y());
  std::vector<Point> below = run(p, first, last), above = run(p, last, first);
  std::reverse(below.begin(), below.end());
  std::reverse(above.begin(), above.end());
  below.insert(below.end(), {left, corners[0], corners[1], right});
  above.insert(above.end(), {right, corners[2], corners[3], left});
  Region joined;
  if (!CGAL::join(sum_by_name(strategy, Polygon(below.begin(), below.end()), q),
                  sum_by_name(strategy, Polygon(above.begin(), above.end()), q), joined))
    throw std::runtime_error("the two halves do not meet");
  return only_hole(joined);
}

// The most memory that this process has held, in kB; 0 where the system does not say.
long peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long size = 0;
    if (word == "VmHWM:" && status >> size) return size;
  }
  return 0;
}

int main(int count, char** arguments) try {
  if (count == 2 && std::string(arguments[1]) == "version") {
    std::cout << CGAL_VERSION_STR << "\n";
    return 0;
  }
  if (count != 4 && count != 5)
    throw std::runtime_error("minkowski OPERATION STRATEGY SECONDS [kept|text]");
  const std::string operation = arguments[1], strategy = arguments[2];
  const double seconds = std::atof(arguments[3]);
  const std::string mode = count == 5 ? arguments[4] : "";
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const auto read = [&text] {
    std::istringstream input(text);
    Numbers one = read_numbers(input), other = read_numbers(input);
    return std::pair(one, other);
  };
  const auto [first, second] = read();
  const Polygon kept_p = make_polygon(first), kept_q = make_polygon(second);
  double total = 0;
  for (int repeat = 0; repeat < 100 && (repeat == 0 || total < seconds); ++repeat) {
    Polygon p = mode == "kept" ? kept_p : make_polygon(first);
    Polygon q = mode == "kept" ? kept_q : make_polygon(second);
    const std::clock_t start = std::clock();
    if (mode == "text") {
      const auto [one, other] = read();
      p = make_polygon(one);
      q = make_polygon(other);
    }
    const Polygon result = operation == "sum" ? sum_by_name(strategy, p, q).outer_boundary()
                                              : erode(operation, strategy, p, q);
    for (const Point& point : result.vertices()) {
      CGAL::exact(point.x());
      CGAL::exact(point.y());
    }
    const double elapsed = double(std::clock() - start) / CLOCKS_PER_SEC;
    total += elapsed;
    std::cout << (repeat ? " " : "") << 1000 * elapsed;
    if (repeat == 99 || total >= seconds) {
      std::cout << "\n" << peak_memory() << "\n";
      for (const Point& point : result.vertices())
        std::cout << CGAL::exact(point.x()) << " " << CGAL::exact(point.y()) << "\n";
    }
  }
} catch (const std::exception& problem) {
  std::cerr << problem.what() << "\n";
  return 1;
}
