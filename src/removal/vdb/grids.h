// OpenVDB's grids of floats and of integers. Whatever of them is not inlined is that of OpenVDB's
// library, which has it compiled: compiled here once more, in each source, it takes most of their
// compile time.
#pragma once

#include <openvdb/openvdb.h>

// Without optimisation nothing is inlined; then functions would be asked for that the library has
// not, as it inlines them.
#if defined(OPENVDB_USE_EXPLICIT_INSTANTIATION) && defined(__OPTIMIZE__)
extern template class openvdb::tree::Tree<openvdb::FloatTree::RootNodeType>;
extern template class openvdb::tree::Tree<openvdb::Int32Tree::RootNodeType>;
extern template class openvdb::Grid<openvdb::FloatTree>;
extern template class openvdb::Grid<openvdb::Int32Tree>;
#endif
