// Minkowski sums and erosions of polygons with CGAL, on exact rationals.
//
//   g++ -std=c++17 -O2 -DNDEBUG -o exactsweep-cgal cgal_sums.cpp -lgmp -lmpfr
//
//   exactsweep-cgal version
//   exactsweep-cgal STRATEGY
//   exactsweep-cgal STRATEGY sum|frame|halves SECONDS [kept|text]
//
// A polygon consists of the number of rings and, for each ring, the number of vertices and their
// coordinates, separated by spaces. With only a STRATEGY, the program reads two polygons per line,
// and answers with their sum in the same form, or with a line that starts with "error".
//
// With an operation, it reads a pair without holes and times P + Q (sum), or the erosion of P by -Q,
// the complement of (complement of P) + Q. For an erosion, CGAL gets the complement as a rectangle
// with the hole P (frame), or as two simple polygons below and above P (halves). It repeats the
// operation for about SECONDS, at most 100 times, and writes the processor times in milliseconds on
// one line, the peak memory in kB on the next, and then the outer boundary of the sum, or the only
// hole of the erosion, one vertex per line. Each run starts from new numbers and ends when all
// coordinates are exact. With `kept`, all runs use the same polygons; with `text`, each run parses
// its numbers from text.

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
using Vertical = CGAL::Polygon_vertical_decomposition_2<Kernel>;
using Triangulation = CGAL::Polygon_triangulation_decomposition_2<Kernel>;
using Bisectors = CGAL::Small_side_angle_bisector_decomposition_2<Kernel>;
using Optimal = CGAL::Optimal_convex_decomposition_2<Kernel>;
using HertelMehlhorn = CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>;
using Greene = CGAL::Greene_convex_decomposition_2<Kernel>;
using Numbers = std::vector<std::vector<std::pair<Exact, Exact>>>;

Numbers read_numbers(std::istream& in) {
  std::size_t size = 0;
  in >> size;
  Numbers rings(in ? size : 0);
  for (auto& ring : rings) {
    in >> size;
    for (Exact x, y; size > 0 && in >> x >> y; --size) ring.push_back({x, y});
  }
  if (!in || rings.empty()) throw std::runtime_error("the input does not contain two polygons");
  return rings;
}

Region make_region(const Numbers& rings) {
  std::vector<Polygon> made;
  for (const auto& ring : rings) {
    made.emplace_back();
    for (const auto& [x, y] : ring) made.back().push_back(Point(Kernel::FT(x), Kernel::FT(y)));
  }
  return Region(made[0], made.begin() + 1, made.end());
}

Region sum_of_polygons(const std::string& strategy, const Polygon& p, const Polygon& q) {
  if (strategy == "reduced") return CGAL::minkowski_sum_2(p, q);
  if (strategy == "full") return CGAL::minkowski_sum_by_full_convolution_2(p, q);
  if (strategy == "bisectors") return CGAL::minkowski_sum_2(p, q, Bisectors());
  if (strategy == "optimal") return CGAL::minkowski_sum_2(p, q, Optimal());
  if (strategy == "hertel-mehlhorn") return CGAL::minkowski_sum_2(p, q, HertelMehlhorn());
  if (strategy == "greene") return CGAL::minkowski_sum_2(p, q, Greene());
  if (strategy == "vertical") return CGAL::minkowski_sum_2(p, q, Vertical());
  if (strategy == "triangulation") return CGAL::minkowski_sum_2(p, q, Triangulation());
  throw std::runtime_error("unknown strategy " + strategy);
}

Region sum_of_regions(const std::string& strategy, const Region& p, const Region& q) {
  if (p.number_of_holes() + q.number_of_holes() == 0)
    return sum_of_polygons(strategy, p.outer_boundary(), q.outer_boundary());
  if (strategy == "reduced") return CGAL::minkowski_sum_2(p, q);
  if (strategy == "vertical") return CGAL::minkowski_sum_2(p, q, Vertical());
  if (strategy == "triangulation") return CGAL::minkowski_sum_2(p, q, Triangulation());
  throw std::runtime_error(strategy + " does not support holes");
}

void write_ring(std::ostream& out, const Polygon& ring, char separator) {
  for (const auto& point : ring.vertices())
    out << separator << CGAL::exact(point.x()) << " " << CGAL::exact(point.y());
}

std::string answer(const std::string& strategy, const std::string& line) try {
  std::istringstream in(line);
  const Region p = make_region(read_numbers(in)), q = make_region(read_numbers(in));
  const Region region = sum_of_regions(strategy, p, q);
  std::vector<Polygon> rings(region.holes_begin(), region.holes_end());
  rings.insert(rings.begin(), region.outer_boundary());
  std::ostringstream out;
  out << rings.size();
  for (const Polygon& ring : rings) write_ring(out << " " << ring.size(), ring, ' ');
  return out.str();
} catch (const std::exception& problem) {
  std::string text = problem.what();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return "error " + text;
}

// The vertices of P from one vertex to another, inclusive, counter-clockwise.
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

// The rectangle is far from P, so that its enlarged boundary does not reach the result.
Polygon erode(const std::string& operation, const std::string& strategy, const Polygon& p,
              const Polygon& q) {
  const auto first = p.left_vertex(), last = p.right_vertex();
  const auto width = 2 * (q.right_vertex()->x() - q.left_vertex()->x());
  const auto height = 2 * (q.top_vertex()->y() - q.bottom_vertex()->y());
  const auto west = first->x() - width, east = last->x() + width;
  const auto low = p.bottom_vertex()->y() - height, high = p.top_vertex()->y() + height;
  const std::vector<Point> corners{{west, low}, {east, low}, {east, high}, {west, high}};
  if (operation == "frame") {
    Polygon hole = p;
    hole.reverse_orientation();
    const Region frame(Polygon(corners.begin(), corners.end()), &hole, &hole + 1);
    // Only one of them has a hole, so they may use different strategies.
    if (strategy == "reduced") return only_hole(CGAL::minkowski_sum_2(frame, q));
    if (strategy == "vertical")
      return only_hole(CGAL::minkowski_sum_2(frame, q, Vertical(), Bisectors()));
    if (strategy == "triangulation")
      return only_hole(CGAL::minkowski_sum_2(frame, q, Triangulation(), Bisectors()));
    throw std::runtime_error(strategy + " does not support holes");
  }
  const Point left(west, first->y()), right(east, last->y());
  std::vector<Point> below = run(p, first, last), above = run(p, last, first);
  std::reverse(below.begin(), below.end());
  std::reverse(above.begin(), above.end());
  below.insert(below.end(), {left, corners[0], corners[1], right});
  above.insert(above.end(), {right, corners[2], corners[3], left});
  Region joined;
  if (!CGAL::join(sum_of_polygons(strategy, Polygon(below.begin(), below.end()), q),
                  sum_of_polygons(strategy, Polygon(above.begin(), above.end()), q), joined))
    throw std::runtime_error("the two halves do not meet");
  return only_hole(joined);
}

// The peak memory of this process in kB; 0 if the system does not report it.
long peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long size = 0;
    if (word == "VmHWM:" && status >> size) return size;
  }
  return 0;
}

void measure(const std::string& strategy, const std::string& operation, const double seconds,
             const std::string& mode) {
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const auto read = [&text] {
    std::istringstream in(text);
    Numbers one = read_numbers(in), other = read_numbers(in);
    return std::pair(one, other);
  };
  const auto make = [](const Numbers& numbers) { return make_region(numbers).outer_boundary(); };
  const auto [first, second] = read();
  const Polygon kept_p = make(first), kept_q = make(second);
  double total = 0;
  for (int repeat = 0; repeat < 100 && (repeat == 0 || total < seconds); ++repeat) {
    Polygon p = mode == "kept" ? kept_p : make(first);
    Polygon q = mode == "kept" ? kept_q : make(second);
    const std::clock_t start = std::clock();
    if (mode == "text") {
      const auto [one, other] = read();
      p = make(one);
      q = make(other);
    }
    const Polygon result = operation == "sum" ? sum_of_polygons(strategy, p, q).outer_boundary()
                                              : erode(operation, strategy, p, q);
    for (const Point& point : result.vertices()) {
      CGAL::exact(point.x());
      CGAL::exact(point.y());
    }
    const double elapsed = double(std::clock() - start) / CLOCKS_PER_SEC;
    total += elapsed;
    std::cout << (repeat ? " " : "") << 1000 * elapsed;
    if (repeat == 99 || total >= seconds) {
      std::cout << "\n" << peak_memory();
      write_ring(std::cout, result, '\n');
    }
  }
  std::cout << "\n";
}

int main(int count, char** arguments) try {
  if (count != 2 && count != 4 && count != 5)
    throw std::runtime_error("STRATEGY, or STRATEGY OPERATION SECONDS [kept|text]");
  const std::string strategy = arguments[1];
  if (strategy == "version") {
    std::cout << CGAL_VERSION_STR << std::endl;
  } else if (count == 2) {
    for (std::string line; std::getline(std::cin, line);)
      std::cout << answer(strategy, line) << std::endl;
  } else {
    measure(strategy, arguments[2], std::atof(arguments[3]), count == 5 ? arguments[4] : "");
  }
} catch (const std::exception& problem) {
  std::cerr << problem.what() << "\n";
  return 1;
}
