/**
 * The light from outside a level: the sky's irradiance, the sun at a height, and both through the level's clouds, whose
 * walks are those of {@code reference.volume}.
 */
package nephele.engine.reference.sky;
