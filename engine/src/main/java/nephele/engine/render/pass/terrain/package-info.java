/** Draws the level's terrains: height fields with layers of materials, lit as other surfaces are. */
package nephele.engine.render.pass.terrain;
