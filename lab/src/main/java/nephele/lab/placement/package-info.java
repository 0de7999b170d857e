/** Random walls of triangles with holes, shots at them, and the true answer whether a rectangle fits where it is aimed. */
package nephele.lab.placement;
