"""Results as text: JSON and WKT for programs, reports and stories for people."""
