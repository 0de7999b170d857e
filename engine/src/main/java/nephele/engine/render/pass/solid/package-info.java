/** Draws the level's solids: Lambertian or metallic-roughness surfaces under sun, punctual lights and ambient light. */
package nephele.engine.render.pass.solid;
