/// Ejection chains: an exit that pays only once the pit that it makes elsewhere has been drained in its turn.
#pragma once

#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

/// Goes on from any triangulation of order <= k: for each pit that is left, inserts one of its exits even if
/// that makes a pit elsewhere, inserts an exit of the new pit, and so on for a few steps; keeps the chain if
/// pits are fewer in the end and takes it back otherwise. Never makes it worse. Deterministic: pits and exits
/// are taken in elevation order. Complexity: bounded by a fixed number of insertions a call, whatever the
/// terrain.
void insert_chains(const Surface& surface, unsigned k, const Watch& watch, Outcome& outcome);

}  // namespace thalweg::detail
