/**
 * Marks portals: a rim around each, a membrane over those without a partner, an outline where a shot would open one.
 */
package nephele.engine.render.pass.rim;
