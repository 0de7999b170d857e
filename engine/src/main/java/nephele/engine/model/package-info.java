/** Meshes and curves: primitives, Bézier patches, Catmull-Rom paths, and the files that hold meshes. */
package nephele.engine.model;
