/** Times the steps of a frame, on the GPU's clock or to the return of {@code glFinish}. */
package nephele.engine.render.timing;
