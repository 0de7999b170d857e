/**
 * The exact twin of the picture: rays through the level as written, in double precision, on the CPU. Nothing is baked,
 * rasterised or cut off: solids are half spaces, shadows are rays, the part of the sky that a place sees is integrated,
 * portals remap the ray itself.
 *
 * <p>The model of light is the engine's: direct light of sun and lamps, the sky's irradiance times the part of the
 * hemisphere over the face that sees the sky, emission as seen, no bounce. Light does not pass through portals, the eye
 * does.
 */
package nephele.engine.reference;
