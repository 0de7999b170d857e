/** The technique {@code skybox}: clouds baked into pictures around one point, fetched by direction. */
package nephele.engine.render.pass.cloud.skybox;
