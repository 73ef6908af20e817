"""Template programs that speak the protocol of `exactsweep conform`."""

# One line about each program.
SUMMARIES = {
    "doubles.cpp": "C++: no-fit polygons and Minkowski sums of any shapes with holes, in doubles",
    "doubles.js": "JavaScript: the same",
    "doubles.py": "Python: the same",
    "doubles.rs": "Rust: the same",
    "convex.py": "Python: convex pairs in fractions, the shortest program",
    "shapes.py": "Python: every question, by exactsweep itself",
}
