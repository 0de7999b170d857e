/**
 * Meshes and curves as values, and what is computed from them: bounds, tangents, subdivision, Catmull-Rom paths. {@code
 * model.shape} generates meshes, {@code model.file} reads and writes them.
 */
package nephele.engine.model;
