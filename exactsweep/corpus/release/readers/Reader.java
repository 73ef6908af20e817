// java Reader.java worked.jsonl
import java.math.BigInteger;
import java.nio.file.*;
import java.util.*;
class Reader {
  final String s;
  int k = 0;
  Reader(String line) { s = line; }
  Object read() { // The value that begins at k: a String, a List or a Map.
    StringBuilder text = new StringBuilder();
    List<Object> list = new ArrayList<>();
    Map<String, Object> map = new HashMap<>();
    char open = s.charAt(k);
    if (open == '"') for (k++; s.charAt(k) != '"'; k++) text.append(s.charAt(s.charAt(k) == '\\' ? ++k : k));
    else if (open != '{' && open != '[') { while (",]}".indexOf(s.charAt(k)) < 0) text.append(s.charAt(k++)); k--; }
    else for (k++; s.charAt(k) != '}' && s.charAt(k) != ']'; k += s.charAt(k) == ',' ? 1 : 0)
      if (open == '[') list.add(read());
      else { String name = (String) read(); k++; map.put(name, read()); }
    k++;
    return open == '{' ? map : open == '[' ? list : text.toString();
  }
  static String rational(Object o) { String[] p = (o + "/1").split("/"); return new BigInteger(p[0]) + "/" + new BigInteger(p[1]); }
  public static void main(String[] args) throws Exception {
    for (String line : Files.readAllLines(Path.of(args[0]))) {
      Map<?, ?> c = (Map<?, ?>) new Reader(line).read(), e = (Map<?, ?>) c.get("expected");
      List<?> t = (List<?>) e.get("trajectory"), p = (List<?>) t.get(0);
      System.out.println(c.get("id") + " " + ((List<?>) c.get("directrix")).size() + " " + t.size() + " " + ((List<?>) e.get("exact_fits")).size() + " " + rational(p.get(0)) + " " + rational(p.get(1)));
    }
  }
}
