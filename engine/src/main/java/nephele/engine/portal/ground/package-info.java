/**
 * Portals on uneven ground: {@link nephele.engine.portal.ground.GroundSeat} finds the plane of a portal over the
 * triangles of a terrain, and how far the ground lies below a portal that is there.
 */
package nephele.engine.portal.ground;
