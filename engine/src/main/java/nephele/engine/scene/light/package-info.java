/**
 * The light on surfaces, without OpenGL. Every include in {@code render/include} that computes light has its Java twin
 * here or, if the reference needs it too, in {@link nephele.engine.level.appearance}. Data prepared once for a level,
 * such as light lists, shadow frames, sky irradiance and sky visibility, is computed here.
 *
 * <p>The model: direct light of the sun and of punctual lights with shadows; the sky's irradiance times the baked
 * visible fraction of the hemisphere; emission that lights nothing else. No bounces.
 */
package nephele.engine.scene.light;
