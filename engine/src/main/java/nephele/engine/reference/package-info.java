/**
 * The reference path tracer, the exact twin of the rendered picture: rays through the level as written, in double
 * precision, on the CPU. Nothing is baked, rasterised or clipped: solids are intersections of half-spaces, shadows are
 * rays, the visible part of the sky is integrated, portals transform the ray itself.
 *
 * <p>Light is followed as far as a {@link nephele.engine.reference.LightTransport} says. {@code DIRECT} is the engine's
 * own model: direct light of sun and punctual lights, the sky's irradiance times the visible part of the hemisphere over
 * the face, emission that lights nothing else; eye rays pass through portals, light does not. {@code FULL} integrates
 * paths over all surfaces and through portals, and over places in clouds.
 */
package nephele.engine.reference;
