/**
 * Objects that several passes read, each a {@link nephele.engine.render.frame.SharedResource}: the light of a level, air,
 * exposure and clouds, static geometry, dynamic objects, openings, billboards and plants.
 */
package nephele.engine.render.resource;
