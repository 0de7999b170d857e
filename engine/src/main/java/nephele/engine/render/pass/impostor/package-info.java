/** Draws models that are drawn as impostors: near ones as meshes, small ones from atlases of views, others as both. */
package nephele.engine.render.pass.impostor;
