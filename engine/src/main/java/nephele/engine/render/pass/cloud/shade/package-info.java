/** The shade of clouds on surfaces. */
package nephele.engine.render.pass.cloud.shade;
