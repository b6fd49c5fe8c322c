"""The command line, input files, requirements, reports, and the server for language models."""
