/** What the passes that draw clouds share: the cells of a cloud as textures. */
package nephele.engine.render.pass.cloud;
