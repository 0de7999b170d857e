/**
 * The bounding volume hierarchy behind every spatial query: construction with the surface area heuristic, refitting
 * after an edit, and traversal by ray, box, sweep and frustum.
 */
package nephele.engine.math.bvh;
