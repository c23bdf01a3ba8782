// Nothing of its own: its precompiled headers are those of all test programs.
