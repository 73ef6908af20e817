// The trajectory of convex pairs of integers: the hull of the differences of their vertices.
// g++ -std=c++17 -O2 -o convex convex.cpp
#include <algorithm>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>
using namespace std;
using Point = pair<long long, long long>;
using Points = vector<Point>;

// The value of a member of a case, up to a text at its end.
string value(const string& line, const string& name, const string& end) {
  size_t from = line.find("\"" + name + "\":") + name.size() + 3;
  return line.substr(from, line.find(end, from) - from);
}
Points points(string text) {
  replace_if(text.begin(), text.end(), [](char c) { return c != '-' && !isdigit(c); }, ' ');
  Points read;
  istringstream in(text);
  for (long long x, y; in >> x >> y;) read.push_back({x, y});
  return read;
}
// Appends the corners to the right of sorted points to a loop, without the last one.
void right_side(const Points& points, Points& loop) {
  const size_t first = loop.size() + 2;
  for (auto [x, y] : points) {
    for (; loop.size() >= first; loop.pop_back()) {
      auto [ax, ay] = loop[loop.size() - 2];
      auto [bx, by] = loop.back();
      if ((__int128)(bx - ax) * (y - ay) > (__int128)(x - ax) * (by - ay)) break;
    }
    loop.push_back({x, y});
  }
  loop.pop_back();
}
// The trajectory: put your own code in its place.
Points answer(const Points& d, const Points& g, const Point& reference) {
  Points sums, loop;
  for (auto [dx, dy] : d)
    for (auto [gx, gy] : g) sums.push_back({dx - gx + reference.first, dy - gy + reference.second});
  sort(sums.begin(), sums.end());
  right_side(sums, loop);
  reverse(sums.begin(), sums.end());
  right_side(sums, loop);
  return loop;
}
int main() {
  cout << R"({"hello": "convex.cpp", "loops": ["trajectory"], "numbers": "int32", )"
       << R"("reference": "given"})" << endl;
  for (string line; getline(cin, line) && line.find("\"bye\"") == string::npos;) {
    cout << "{\"id\":" << value(line, "id", ",");
    if (value(line, "class", ",").find("CC") != string::npos) {
      const Point reference = points(value(line, "reference", "]"))[0];
      const char* before = ", \"trajectory\": [[";
      for (auto [x, y] : answer(points(value(line, "directrix", "]]")),
                                points(value(line, "generatrix", "]]")), reference)) {
        cout << before << x << ", " << y << "]";
        before = ", [";
      }
      cout << "]}" << endl;
    } else {
      cout << ", \"unsupported\": \"not convex\"}" << endl;
    }
  }
}
