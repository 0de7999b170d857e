/** The shadows of clouds in the air, for each view. */
package nephele.engine.render.pass.cloud.shaft;
