/**
 * Buffers and meshes on the GPU that several passes draw or read: static geometry, dynamic objects, openings,
 * materials, lights and the view's uniform block.
 */
package nephele.engine.render.resource;
