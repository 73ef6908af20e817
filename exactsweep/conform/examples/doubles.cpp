// No-fit polygons and Minkowski sums of any shapes with holes, in doubles, for small cases.
// Put your own code in place of no_fit; or of minkowski_sum, if it computes a + b.
//
// This program reads JSON with nlohmann/json, a single header: apt install nlohmann-json3-dev, or
// brew install nlohmann-json, or copy json.hpp into a folder nlohmann next to this file.
// g++ -std=c++17 -O2 -I. -o doubles doubles.cpp
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>
using namespace std;
using nlohmann::json;

using Point = pair<double, double>;
using Ring = vector<Point>;
using Shape = vector<Ring>;  // A polygon: its exterior, then its holes, in either orientation.
using Line = pair<Point, Point>;

const size_t MOST = 2500;  // Maximum number of pairs of edges; the time grows with its square.

Shape minkowski_sum(Shape a, Shape b);

Shape scale(Shape shape, double k) {
  for (Ring& ring : shape)
    for (auto& [x, y] : ring) x *= k, y *= k;
  return shape;
}

Shape translate(Shape shape, double dx, double dy) {
  for (Ring& ring : shape)
    for (auto& [x, y] : ring) x += dx, y += dy;
  return shape;
}

// The rings around the positions of the reference point at which g overlaps d.
Shape no_fit(const Shape& d, const Shape& g, const Point& reference) {
  return translate(minkowski_sum(d, scale(g, -1)), reference.first, reference.second);
}

// Maximum absolute value of a coordinate.
double find_size(const Shape& shape) {
  double size = 0;
  for (const Ring& ring : shape)
    for (const auto& [x, y] : ring) size = max({size, abs(x), abs(y)});
  return size;
}

const Point& before(const Ring& ring, size_t k) { return ring[(k + ring.size() - 1) % ring.size()]; }

// Positive if r is on the left of pq.
double turn(const Point& p, const Point& q, const Point& r) {
  return (q.first - p.first) * (r.second - p.second) - (q.second - p.second) * (r.first - p.first);
}

// Orient rings with the interior on the left; drop repeated vertices.
Shape orient(const Shape& shape) {
  Shape found;
  for (const Ring& given : shape) {
    Ring ring;
    for (size_t k = 0; k < given.size(); k++)
      if (given[k] != before(given, k)) ring.push_back(given[k]);
    double area = 0;
    for (size_t k = 1; k < ring.size(); k++) area += turn(ring[0], ring[k - 1], ring[k]);
    if ((area > 0) != found.empty()) reverse(ring.begin(), ring.end());
    found.push_back(ring);
  }
  return found;
}

// Translate each edge to the corners of the other shape whose edges enclose its direction.
void place_edges(const Shape& edges, const Shape& corners, vector<Line>& lines) {
  for (const Ring& ring : corners)
    for (size_t k = 0; k < ring.size(); k++) {
      const Point &p = before(ring, k), &q = ring[k], &r = ring[(k + 1) % ring.size()];
      for (const Ring& other : edges)
        for (size_t j = 0; j < other.size(); j++) {
          const Point &s = before(other, j), &t = other[j];
          const double dx = t.first - s.first, dy = t.second - s.second;
          if ((q.first - p.first) * dy - (q.second - p.second) * dx >= 0 &&
              dx * (r.second - q.second) - dy * (r.first - q.first) >= 0)
            lines.push_back({{s.first + q.first, s.second + q.second},
                             {t.first + q.first, t.second + q.second}});
        }
    }
}

// The parameters on a line, from 0 to 1, where another one crosses it or ends on it.
void find_cuts(const Line& line, const Line& other, double near, set<double>& cuts) {
  const auto& [p, q] = line;
  const auto& [r, s] = other;
  if (min(r.first, s.first) > max(p.first, q.first) + near ||
      max(r.first, s.first) < min(p.first, q.first) - near ||
      min(r.second, s.second) > max(p.second, q.second) + near ||
      max(r.second, s.second) < min(p.second, q.second) - near)
    return;
  const double dx = q.first - p.first, dy = q.second - p.second, length = hypot(dx, dy);
  const auto place = [&](double x, double y) {
    const double t = (dx * (x - p.first) + dy * (y - p.second)) / (length * length);
    if (0 < t && t < 1) cuts.insert(t);
  };
  const double one = turn(p, q, r) / length, two = turn(p, q, s) / length;
  if (abs(one) < near) place(r.first, r.second);
  if (abs(two) < near) place(s.first, s.second);
  if (abs(one) >= near && abs(two) >= near && (one > 0) != (two > 0)) {
    const double u = one / (one - two);
    place(r.first + u * (s.first - r.first), r.second + u * (s.second - r.second));
  }
}

// Whether a point is inside a shape: a ray from it crosses an odd number of edges.
bool holds(const Shape& shape, const Point& p) {
  bool inside = false;
  for (const Ring& ring : shape)
    for (size_t k = 0; k < ring.size(); k++) {
      const Point &a = before(ring, k), &b = ring[k];
      if ((a.second > p.second) != (b.second > p.second))
        inside ^= (turn(a, b, p) > 0) == (b.second > a.second);
    }
  return inside;
}

// Whether a point is inside a + b: whether a meets the point minus b.
bool is_inside(const Point& place, const Shape& a, Shape b) {
  for (Ring& ring : b)
    for (auto& [x, y] : ring) x = place.first - x, y = place.second - y;
  for (const Ring& ring : a)
    for (size_t k = 0; k < ring.size(); k++)
      for (const Ring& other : b)
        for (size_t j = 0; j < other.size(); j++) {
          const Point &p = before(ring, k), &q = ring[k], &r = before(other, j), &s = other[j];
          if (turn(p, q, r) * turn(p, q, s) < 0 && turn(r, s, p) * turn(r, s, q) < 0) return true;
        }
  return holds(a, b[0][0]) || holds(b, a[0][0]);
}

// Join pieces to rings; at a branch, take the rightmost piece.
Shape join(set<Line> pieces) {
  Shape rings;
  while (!pieces.empty()) {
    auto piece = pieces.begin();
    const Point start = piece->first;
    Ring ring = {start};
    for (;;) {
      const auto [from, to] = *piece;
      pieces.erase(piece);
      if (to == start) break;
      ring.push_back(to);
      const double back = atan2(from.second - to.second, from.first - to.first);
      double most = -1;
      piece = pieces.end();
      for (auto next = pieces.begin(); next != pieces.end(); ++next) {
        if (next->first != to) continue;
        const Point& end = next->second;
        double angle = atan2(end.second - to.second, end.first - to.first) - back;
        if (angle < 0) angle += 2 * M_PI;
        if (angle > most) most = angle, piece = next;
      }
      if (piece == pieces.end()) throw runtime_error("the boundary does not close");
    }
    rings.push_back(ring);
  }
  return rings;
}

// The rings of a + b: edges of each at convex corners of the other, cut and filtered.
Shape minkowski_sum(Shape a, Shape b) {
  const double largest = max(find_size(a), find_size(b));
  if (largest < 1e-70 || largest > 1e70) {
    // Products would overflow or underflow; scaling by a power of two is exact.
    const double k = ldexp(1, largest > 1 ? -200 : 200);
    return scale(minkowski_sum(scale(a, k), scale(b, k)), 1 / k);
  }
  const auto [x, y] = a[0][0];
  const auto [u, v] = b[0][0];
  if (x != 0 || y != 0 || u != 0 || v != 0)
    // Coordinates near the origin have more digits.
    return translate(minkowski_sum(translate(a, -x, -y), translate(b, -u, -v)), x + u, y + v);
  a = orient(a), b = orient(b);
  vector<Line> placed, lines;
  place_edges(a, b, placed);
  place_edges(b, a, placed);
  double size = 0;
  for (const auto& [p, q] : placed) size = max(size, find_size({{p, q}}));
  const double near = 1e-13 * size;
  Ring nodes;
  const auto find_node = [&](const Point& p) {
    for (const Point& q : nodes)
      if (abs(p.first - q.first) < near && abs(p.second - q.second) < near) return q;
    nodes.push_back(p);
    return p;
  };
  for (const auto& [p, q] : placed) {
    const Line line = {find_node(p), find_node(q)};
    if (line.first != line.second) lines.push_back(line);
  }
  set<Line> pieces;
  for (const Line& line : lines) {
    const auto& [p, q] = line;
    set<double> cuts = {0, 1};
    for (const Line& other : lines) find_cuts(line, other, near, cuts);
    const auto at = [p = p, q = q](double t) -> Point {
      return {p.first + t * (q.first - p.first), p.second + t * (q.second - p.second)};
    };
    for (auto end = next(cuts.begin()); end != cuts.end(); ++end) {
      const Point r = at(*prev(end)), s = at(*end);
      const double dx = s.first - r.first, dy = s.second - r.second, length = hypot(dx, dy);
      // The interior is left of each piece; the exterior is right of boundary pieces.
      // At the midpoint, two corners might be opposite each other.
      if (length > near && !is_inside({r.first + 0.4372 * dx + near * dy / length,
                                       r.second + 0.4372 * dy - near * dx / length},
                                      a, b))
        pieces.insert({find_node(r), find_node(s)});
    }
  }
  return join(pieces);
}

// The protocol: a hello, then a line for each case.

Point read_point(const json& pair) {
  // stod would throw at the least doubles.
  const auto read = [](const json& number) { return strtod(number.get<string>().c_str(), nullptr); };
  return {read(pair[0]), read(pair[1])};
}

Shape read_shape(const json& given, const string& name) {
  Shape shape;
  const auto add = [&](const json& points) {
    shape.emplace_back();
    for (const json& pair : points) shape.back().push_back(read_point(pair));
  };
  add(given[name]);
  if (given.contains(name + "_holes"))
    for (const json& hole : given[name + "_holes"]) add(hole);
  return shape;
}

size_t count_edges(const Shape& shape) {
  size_t count = 0;
  for (const Ring& ring : shape) count += ring.size();
  return count;
}

int main() {
  cout << json{{"hello", "doubles.cpp"},
               {"questions", {"no_fit", "minkowski_sum"}},
               {"shapes", "any"},
               {"numbers", "binary64"},
               {"reference", "given"}}
       << endl;
  for (string line; getline(cin, line);) {
    const json given = json::parse(line);
    if (given.contains("bye")) break;
    json answer = {{"id", given["id"]}};
    const Shape d = read_shape(given, "directrix"), g = read_shape(given, "generatrix");
    if (count_edges(d) * count_edges(g) > MOST) {
      answer["unsupported"] = "too large for an example";
    } else {
      for (const string part : given["ask"])
        answer[part] = part == "no_fit"
                           ? no_fit(d, g, read_point(given["reference"]))
                           : minkowski_sum(read_shape(given, "a"), read_shape(given, "b"));
    }
    cout << answer << endl;
  }
}
