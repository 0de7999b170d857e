/** Draws the level's solids: Lambert or metallic-roughness surfaces under sun, lamps and ambient light. */
package nephele.engine.render.pass.solid;
