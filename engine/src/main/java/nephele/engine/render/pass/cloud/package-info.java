/** What the techniques that draw clouds share: order, layers of low resolution, surfaces among clouds, cells as textures. */
package nephele.engine.render.pass.cloud;
