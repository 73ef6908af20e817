"""Results as text: JSON and WKT for programs, reports and explanations for people."""
