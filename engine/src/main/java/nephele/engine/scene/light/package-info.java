/**
 * The light on surfaces, without OpenGL. Every include in {@code render/include} that computes light has its Java twin
 * here or, where the reference needs it too, in {@link nephele.engine.level.appearance}; what is prepared once for a level –
 * lamp lists, shadow frames, sky irradiance, sky visibility – is computed here.
 *
 * <p>What is modelled: direct light of the sun and of lamps with shadows; the sky's irradiance times the baked fraction
 * of the hemisphere that sees the sky; emission as seen, lighting nothing. No bounce.
 */
package nephele.engine.scene.light;
