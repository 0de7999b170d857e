/** What a ray that meets nothing sees: a gradient or a skybox; a constant sky needs no pass, it is the clear colour. */
package nephele.engine.render.pass.sky;
