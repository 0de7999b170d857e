/** Models where a level has them: frames, triangles in the world, and which of them are convex solids. */
package nephele.engine.level.placed;
