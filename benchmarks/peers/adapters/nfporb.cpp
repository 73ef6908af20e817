// No-fit polygons of pairs of polygons with libnfporb, whose header the user provides, one pair per
// line. Numbers are long doubles or, if LIBNFP_USE_RATIONAL is defined, rationals.
//
// A line of input contains two polygons: the number of rings, then the exterior and the holes, each
// as the number of vertices and their coordinates. The answer is the number of rings and the rings in
// the same form, or a line that starts with "error".

#include <fstream>
#include <iomanip>
#include <sstream>

#include <libnfporb.hpp>

using libnfporb::coord_t;
using Polygon = libnfporb::polygon_t;

#ifdef LIBNFP_USE_RATIONAL
coord_t read_number(const std::string& word) { return coord_t(word); }
void write_number(std::ostream& out, const coord_t& value) { out << value.str(); }
#else
coord_t read_number(const std::string& word) {
  const auto slash = word.find('/');
  const long double numerator = std::stold(word);
  return slash == std::string::npos ? numerator : numerator / std::stold(word.substr(slash + 1));
}
void write_number(std::ostream& out, const coord_t& value) {
  out << std::setprecision(21) << value.val();
}
#endif

Polygon::ring_type read_ring(std::istream& in) {
  std::size_t size = 0;
  in >> size;
  Polygon::ring_type ring;
  for (std::string x, y; size > 0 && in >> x >> y; --size)
    ring.push_back({read_number(x), read_number(y)});
  if (!in || ring.empty()) throw std::runtime_error("the line does not contain two polygons");
  ring.push_back(ring.front());
  return ring;
}

Polygon read_polygon(std::istream& in) {
  std::size_t size = 0;
  in >> size;
  Polygon polygon;
  polygon.outer() = read_ring(in);
  while (--size > 0) polygon.inners().push_back(read_ring(in));
  return polygon;
}

std::string answer(const std::string& line) try {
  std::istringstream in(line);
  Polygon stationary = read_polygon(in), orbiting = read_polygon(in);
  std::ostringstream out;
  const auto rings = libnfporb::generate_nfp(stationary, orbiting, true);
  out << rings.size();
  for (const auto& ring : rings) {
    out << " " << ring.size();
    for (const auto& point : ring) {
      write_number(out << " ", point.x_);
      write_number(out << " ", point.y_);
    }
  }
  return out.str();
} catch (const std::exception& problem) {
  std::string text = problem.what();
  for (char& c : text)
    if (c == '\n') c = ' ';
  return "error " + text;
}

int main() {
  for (std::string line; std::getline(std::cin, line);) std::cout << answer(line) << std::endl;
}
