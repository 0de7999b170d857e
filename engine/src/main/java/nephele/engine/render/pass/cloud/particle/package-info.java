/** The technique {@code particles}: soft balls, blended from the farthest to the nearest. */
package nephele.engine.render.pass.cloud.particle;
