/**
 * A grid of heights as triangles that are computed when a query needs them. A pyramid of minimum and maximum heights
 * lets ray and box queries skip what they cannot hit.
 */
package nephele.engine.math.heightfield;
