// g++ -std=c++17 reader.cpp -o reader && ./reader worked.jsonl
#include <fstream>
#include <iostream>
#include <map>
#include <vector>
struct Value {  // the text of a string or a number, a list, or an object
  std::string text;
  std::vector<Value> list;
  std::map<std::string, Value> at;
};
Value read(const std::string &s, size_t &k) {  // The value that begins at s[k].
  Value v;
  const char open = s[k];
  if (open == '"') for (k++; s[k] != '"' || !++k; k++) v.text += s[k += s[k] == '\\'];
  else if (open != '{' && open != '[') while (s[k] != ',' && s[k] != ']' && s[k] != '}') v.text += s[k++];
  else for (k++; (s[k] != '}' && s[k] != ']') || !++k; k += s[k] == ',')
    if (open == '{') { const std::string name = read(s, k).text; v.at[name] = read(s, ++k); }
    else v.list.push_back(read(s, k));
  return v;
}
std::string rational(const Value &v) { return v.text + (v.text.find('/') + 1 ? "" : "/1"); }
int main(int, char **argv) {
  std::ifstream file(argv[1]);
  for (std::string line; std::getline(file, line);) {
    size_t k = 0;
    Value c = read(line, k), e = c.at["expected"], p = e.at["trajectory"].list[0];
    std::cout << c.at["id"].text << ' ' << c.at["directrix"].list.size() << ' ' << e.at["trajectory"].list.size()
              << ' ' << e.at["exact_fits"].list.size() << ' ' << rational(p.list[0]) << ' ' << rational(p.list[1]) << '\n';
  }
}
