"""Results as text: JSON for programs, reports and explanations for people."""
