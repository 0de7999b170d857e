/** Bounding volumes of models, from the sphere to the exact triangles, and how often each reports a contact that is none. */
package nephele.lab.bound;
