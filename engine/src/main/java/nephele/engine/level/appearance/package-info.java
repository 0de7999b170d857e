/**
 * The meaning of a level's numbers for the eye: reflection of materials, mapping of textures, falloff of lights,
 * radiance of skies. The formulas are in double precision, each with its source; the shaders are their twins, the scene
 * prepares light with them, and the reference path tracer uses them.
 */
package nephele.engine.level.appearance;
