/**
 * Proofs about the whole program: replays in several virtual machines, saving under kill, soak tests, planted faults, and levels
 * with odd numbers, made from the records and their ranges.
 */
package nephele.workshop.prove.process;
