/**
 * Shapes in the world that follow from a level: frames and triangles of models, and which of them are convex solids.
 */
package nephele.engine.level.placed;
