/** Bounding volumes of models, from the sphere to the exact triangles, and the contact of models by them. */
package nephele.engine.model.bound;
