/**
 * Generated meshes: primitives and Bézier patches with normals and texture coordinates. {@link
 * nephele.engine.model.shape.ShapeKind} lists the primitives and their parameters.
 */
package nephele.engine.model.shape;
