/**
 * The static world as convex solids, and queries of moving rounded shapes against it: distance, sweep, ray,
 * depenetration. A {@link nephele.engine.collision.PortalWorld} is the static world opened at the portals: behind each
 * open aperture an {@link nephele.engine.collision.ApertureVolume} is cut out of the solids by an {@link
 * nephele.engine.collision.ApertureCutter} and filled with the other side's solids. {@link
 * nephele.engine.collision.PortalWorld#active} decides which apertures are open to a query, so that far queries see the
 * plain world.
 */
package nephele.engine.collision;
