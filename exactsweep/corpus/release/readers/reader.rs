// rustc reader.rs && ./reader worked.jsonl
use std::collections::HashMap;
#[derive(Default)]
struct Value { text: String, list: Vec<Value>, at: HashMap<String, Value> }
fn read(s: &[u8], k: &mut usize) -> Value { // The value that begins at s[*k].
    let (open, mut v, mut bytes) = (s[*k], Value::default(), vec![]);
    if open == b'{' || open == b'[' {
        *k += 1;
        while s[*k] != b'}' && s[*k] != b']' {
            if open == b'{' {
                let name = read(s, k).text;
                v.at.insert(name, { *k += 1; read(s, k) });
            } else { v.list.push(read(s, k)) }
            if s[*k] == b',' { *k += 1 }
        }
    } else if open == b'"' {
        *k += 1;
        while s[*k] != b'"' { if s[*k] == b'\\' { *k += 1 } bytes.push(s[*k]); *k += 1 }
    } else { while !b",]}".contains(&s[*k]) { bytes.push(s[*k]); *k += 1 } *k -= 1 }
    *k += 1;
    Value { text: String::from_utf8(bytes).unwrap(), ..v }
}
fn rational(v: &Value) -> String { v.text.clone() + if v.text.contains('/') { "" } else { "/1" } }
fn main() {
    for line in std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap().lines() {
        let c = read(line.as_bytes(), &mut 0);
        let (e, p) = (&c.at["expected"].at, &c.at["expected"].at["trajectory"].list);
        println!("{} {} {} {} {} {}", c.at["id"].text, c.at["directrix"].list.len(), p.len(), e["exact_fits"].list.len(), rational(&p[0].list[0]), rational(&p[0].list[1]));
    }
}
