"""Reports of a run: text, HTML, JUnit."""
