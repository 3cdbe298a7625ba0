// OpenVDB's grids of floats and of integers. Whatever of them is not inlined is compiled once, in
// grids.cpp: compiled in each source once more, it takes most of their compile time. OpenVDB's own
// library lacks some of it.
#pragma once

#include <openvdb/openvdb.h>

extern template class openvdb::tree::Tree<openvdb::FloatTree::RootNodeType>;
extern template class openvdb::tree::Tree<openvdb::Int32Tree::RootNodeType>;
extern template class openvdb::Grid<openvdb::FloatTree>;
extern template class openvdb::Grid<openvdb::Int32Tree>;
