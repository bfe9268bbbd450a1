"""The BIDS App: spheres, registrations and resampled surfaces and metrics of many subjects, by the command line program."""
