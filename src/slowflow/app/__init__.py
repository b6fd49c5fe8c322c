"""Programs on top: the command line, scenes, reports, the explorer's and editors' data."""
