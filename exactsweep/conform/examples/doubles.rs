// No-fit polygons and Minkowski sums of any shapes with holes, in doubles, for small cases.
// Put your own code in place of no_fit; or of minkowski_sum, if it computes a + b.
//
// cargo new mine && cd mine && cargo add serde_json
// cp ../doubles.rs src/main.rs && cargo build --release
use serde_json::{json, Value};
use std::f64::consts::TAU;
use std::io::{stdin, stdout, BufRead, Write};

type Point = (f64, f64);
type Ring = Vec<Point>;
/// A polygon: its exterior, then its holes, in either orientation.
type Shape = Vec<Ring>;
type Line = (Point, Point);

/// Maximum number of pairs of edges; the time grows with its square.
const MOST: usize = 2500;

/// The rings around the positions of the reference point at which g overlaps d.
fn no_fit(d: &Shape, g: &Shape, reference: Point) -> Shape {
    translate(&minkowski_sum(d, &scale(g, -1.0)), reference)
}

/// The rings of a + b: edges of each at convex corners of the other, cut and filtered.
fn minkowski_sum(a: &Shape, b: &Shape) -> Shape {
    let size = |most: f64, p: &Point| most.max(p.0.abs()).max(p.1.abs());
    let largest = a.iter().chain(b).flatten().fold(0.0, size);
    if largest < 1e-70 || largest > 1e70 {
        // Products would overflow or underflow; scaling by a power of two is exact.
        let k = 2f64.powi(if largest > 1.0 { -200 } else { 200 });
        return scale(&minkowski_sum(&scale(a, k), &scale(b, k)), 1.0 / k);
    }
    let ((x, y), (u, v)) = (a[0][0], b[0][0]);
    if [x, y, u, v] != [0.0; 4] {
        // Coordinates near the origin have more digits.
        let rings = minkowski_sum(&translate(a, (-x, -y)), &translate(b, (-u, -v)));
        return translate(&rings, (x + u, y + v));
    }
    let (a, b) = (&orient(a), &orient(b));
    let placed = [place_edges(a, b), place_edges(b, a)].concat();
    let near = 1e-13 * placed.iter().fold(0.0, |most, (p, q)| size(size(most, p), q));
    let mut nodes: Vec<Point> = vec![];
    let mut find_node = |p: Point| {
        let is_near = |q: &Point| (p.0 - q.0).abs() < near && (p.1 - q.1).abs() < near;
        nodes.iter().position(is_near).unwrap_or_else(|| {
            nodes.push(p);
            nodes.len() - 1
        })
    };
    for &(p, q) in &placed {
        find_node(p);
        find_node(q);
    }
    let mut pieces: Vec<(usize, usize)> = vec![];
    for &(p, q) in &placed {
        if find_node(p) == find_node(q) {
            continue;
        }
        let mut cuts = vec![0.0, 1.0];
        for &(r, s) in &placed {
            find_cuts((p, q), (r, s), near, &mut cuts);
        }
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let (r, s) = (between(p, q, pair[0]), between(p, q, pair[1]));
            let (dx, dy) = (s.0 - r.0, s.1 - r.1);
            let length = dx.hypot(dy);
            // The interior is left of each piece; the exterior is right of boundary pieces.
            // At the midpoint, two corners might be opposite each other.
            let x = r.0 + 0.4372 * dx + near * dy / length;
            let y = r.1 + 0.4372 * dy - near * dx / length;
            if length > near && !is_inside((x, y), a, b) {
                pieces.push((find_node(r), find_node(s)));
            }
        }
    }
    pieces.sort();
    pieces.dedup();
    join(pieces, &nodes)
}

fn map(shape: &Shape, change: impl Fn(Point) -> Point) -> Shape {
    shape.iter().map(|ring| ring.iter().map(|&p| change(p)).collect()).collect()
}

fn scale(shape: &Shape, k: f64) -> Shape {
    map(shape, |(x, y)| (k * x, k * y))
}

fn translate(shape: &Shape, by: Point) -> Shape {
    map(shape, |(x, y)| (x + by.0, y + by.1))
}

fn between(p: Point, q: Point, t: f64) -> Point {
    (p.0 + t * (q.0 - p.0), p.1 + t * (q.1 - p.1))
}

/// Positive if r is on the left of pq.
fn turn(p: Point, q: Point, r: Point) -> f64 {
    (q.0 - p.0) * (r.1 - p.1) - (q.1 - p.1) * (r.0 - p.0)
}

fn list_edges(shape: &Shape) -> impl Iterator<Item = Line> + '_ {
    shape.iter().flat_map(|ring| {
        (0..ring.len()).map(move |k| (ring[(k + ring.len() - 1) % ring.len()], ring[k]))
    })
}

/// Orient rings with the interior on the left; drop repeated vertices.
fn orient(shape: &Shape) -> Shape {
    let mut found: Shape = vec![];
    for given in shape {
        let mut ring = given.clone();
        ring.dedup();
        while ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        let area: f64 = ring.windows(2).map(|side| turn(ring[0], side[0], side[1])).sum();
        if (area > 0.0) != found.is_empty() {
            ring.reverse();
        }
        found.push(ring);
    }
    found
}

/// Translate each edge to the corners of the other shape whose edges enclose its direction.
fn place_edges(edges: &Shape, corners: &Shape) -> Vec<Line> {
    let mut lines = vec![];
    for ring in corners {
        for (k, &corner) in ring.iter().enumerate() {
            let before = ring[(k + ring.len() - 1) % ring.len()];
            let after = ring[(k + 1) % ring.len()];
            for (p, q) in list_edges(edges) {
                let (dx, dy) = (q.0 - p.0, q.1 - p.1);
                if (corner.0 - before.0) * dy - (corner.1 - before.1) * dx >= 0.0
                    && dx * (after.1 - corner.1) - dy * (after.0 - corner.0) >= 0.0
                {
                    let put = |p: Point| (p.0 + corner.0, p.1 + corner.1);
                    lines.push((put(p), put(q)));
                }
            }
        }
    }
    lines
}

/// Add the parameters on a line, from 0 to 1, where another one crosses it or ends on it.
fn find_cuts((p, q): Line, (r, s): Line, near: f64, cuts: &mut Vec<f64>) {
    if r.0.min(s.0) > p.0.max(q.0) + near
        || r.0.max(s.0) < p.0.min(q.0) - near
        || r.1.min(s.1) > p.1.max(q.1) + near
        || r.1.max(s.1) < p.1.min(q.1) - near
    {
        return;
    }
    let (dx, dy) = (q.0 - p.0, q.1 - p.1);
    let length = dx.hypot(dy);
    let mut place = |(x, y): Point| {
        let t = (dx * (x - p.0) + dy * (y - p.1)) / (length * length);
        if 0.0 < t && t < 1.0 {
            cuts.push(t);
        }
    };
    let (one, two) = (turn(p, q, r) / length, turn(p, q, s) / length);
    if one.abs() < near {
        place(r);
    }
    if two.abs() < near {
        place(s);
    }
    if one.abs() >= near && two.abs() >= near && (one > 0.0) != (two > 0.0) {
        place(between(r, s, one / (one - two)));
    }
}

/// Whether a point is inside a + b: whether a meets the point minus b.
fn is_inside((x, y): Point, a: &Shape, b: &Shape) -> bool {
    let c = &map(b, |(u, v)| (x - u, y - v));
    list_edges(a).any(|(p, q)| {
        list_edges(c).any(|(r, s)| {
            turn(p, q, r) * turn(p, q, s) < 0.0 && turn(r, s, p) * turn(r, s, q) < 0.0
        })
    }) || holds(a, c[0][0])
        || holds(c, a[0][0])
}

/// Whether a point is inside a shape: a ray from it crosses an odd number of edges.
fn holds(shape: &Shape, p: Point) -> bool {
    let crosses = |(a, b): &Line| {
        (a.1 > p.1) != (b.1 > p.1) && (turn(*a, *b, p) > 0.0) == (b.1 > a.1)
    };
    list_edges(shape).filter(crosses).count() % 2 == 1
}

/// Join pieces to rings; at a branch, take the rightmost piece.
fn join(mut pieces: Vec<(usize, usize)>, nodes: &[Point]) -> Shape {
    let angle = |p: usize, q: usize| (nodes[q].1 - nodes[p].1).atan2(nodes[q].0 - nodes[p].0);
    let mut rings = vec![];
    while let Some((start, mut to)) = pieces.pop() {
        let mut from = start;
        let mut ring = vec![nodes[start]];
        while to != start {
            ring.push(nodes[to]);
            let back = angle(to, from);
            let right = |k: &usize| (angle(to, pieces[*k].1) - back).rem_euclid(TAU);
            let next = (0..pieces.len())
                .filter(|&k| pieces[k].0 == to)
                .max_by(|j, k| right(j).total_cmp(&right(k)))
                .expect("the boundary does not close");
            (from, to) = pieces.swap_remove(next);
        }
        rings.push(ring);
    }
    rings
}

fn read_point(pair: &Value) -> Point {
    let read = |k: usize| pair[k].as_str().unwrap().parse().unwrap();
    (read(0), read(1))
}

fn read_shape(given: &Value, name: &str) -> Shape {
    let read = |ring: &Value| ring.as_array().unwrap().iter().map(read_point).collect();
    let holes = given[format!("{name}_holes")].as_array().cloned().unwrap_or_default();
    std::iter::once(&given[name]).chain(&holes).map(read).collect()
}

/// Answer all questions of a case.
fn answer(given: &Value) -> Value {
    let (d, g) = (read_shape(given, "directrix"), read_shape(given, "generatrix"));
    let mut said = json!({ "id": given["id"] });
    if list_edges(&d).count() * list_edges(&g).count() > MOST {
        said["unsupported"] = json!("too large for an example");
        return said;
    }
    for part in given["ask"].as_array().unwrap() {
        said[part.as_str().unwrap()] = match part.as_str() {
            Some("no_fit") => json!(no_fit(&d, &g, read_point(&given["reference"]))),
            _ => json!(minkowski_sum(&read_shape(given, "a"), &read_shape(given, "b"))),
        };
    }
    said
}

fn main() {
    let questions = ["no_fit", "minkowski_sum"];
    let say = |line: Value| {
        println!("{line}");
        stdout().flush().unwrap();
    };
    say(json!({
        "hello": "doubles.rs", "questions": questions, "shapes": "any",
        "numbers": "binary64", "reference": "given",
    }));
    for line in stdin().lock().lines() {
        let given: Value = serde_json::from_str(&line.unwrap()).unwrap();
        if given.get("bye").is_some() {
            break;
        }
        say(answer(&given));
    }
}
