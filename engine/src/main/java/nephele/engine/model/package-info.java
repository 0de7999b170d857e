/** Meshes and curves: primitives, Bézier patches, Catmull-Rom paths, and the file formats of meshes. */
package nephele.engine.model;
