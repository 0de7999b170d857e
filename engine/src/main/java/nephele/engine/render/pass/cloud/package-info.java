/** The cells of a cloud as textures, shared by the passes that draw clouds. */
package nephele.engine.render.pass.cloud;
