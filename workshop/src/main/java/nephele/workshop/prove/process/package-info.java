/**
 * Proofs that run whole processes: replays in several virtual machines, saving under kill, soak tests, planted faults.
 */
package nephele.workshop.prove.process;
