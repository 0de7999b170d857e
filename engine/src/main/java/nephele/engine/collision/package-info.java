/**
 * The static world as convex solids, and queries of moving rounded shapes against it: distance, sweep, ray,
 * depenetration. The query objects are reused. Near open portals the world is cut and filled with the other side's
 * solids.
 */
package nephele.engine.collision;
