/** Measures frames: process CPU, wall time, draws, triangles and allocation. */
package nephele.lab.bench;
