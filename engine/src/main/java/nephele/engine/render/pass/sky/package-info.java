/** The background: a gradient or a skybox. A constant sky needs no pass; it is the clear colour. */
package nephele.engine.render.pass.sky;
