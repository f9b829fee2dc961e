// CMake makes precompiled headers for a target with sources.
