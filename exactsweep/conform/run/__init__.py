"""Running a program over cases: protocol, processes, journal."""
