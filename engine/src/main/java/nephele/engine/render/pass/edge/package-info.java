/** Smooths the edges of the displayed picture by their shapes. */
package nephele.engine.render.pass.edge;
