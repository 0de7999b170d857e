/** What marks portals: a rim around each, a membrane over those that lead nowhere yet, an outline where a shot would open one. */
package nephele.engine.render.pass.rim;
