"""The BIDS App: computes spheres, registrations, and resampled surfaces and metrics of many subjects with the command line program."""
