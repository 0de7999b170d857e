/** The technique {@code billboard}: flat pictures of soft balls, turned towards the eye. */
package nephele.engine.render.pass.cloud.billboard;
