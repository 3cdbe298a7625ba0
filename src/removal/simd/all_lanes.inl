// All closed forms, in an order in which each finds what it calls; included once per instruction
// set, behind the registers and the trigonometry of that set.
#include "removal/simd/sweep_lanes.inl"
//
#include "removal/simd/falling_lanes.inl"
//
#include "removal/simd/helix_lanes.inl"
#include "removal/simd/slant_lanes.inl"
#include "removal/simd/upright_lanes.inl"
//
#include "removal/simd/chain_lanes.inl"
#include "removal/simd/outline_lanes.inl"
//
#include "removal/simd/ball_height_lanes.inl"
